// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "experiment/export/comparison_files.h"
#include "experiment/judge/trace_file.h"
#include "experiment/report/tables/tables.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/shipped.h"
#include "tools/jaywalk/run/run_files.h"

namespace jaywalk {
namespace {

/// The scenario whose ground the drive was on and whose assertions count unless others are given.
std::optional<Scenario> scenario_of(const Arguments& arguments, Console& console) {
  const auto path = arguments.text(option::kScenario);
  if (!path) {
    console.note("on the paper's road: --scenario names another");
    return Scenario{};
  }
  Diagnostics wrong;
  const auto file = input_file(*path, kScenarios, wrong);
  console.report(wrong);
  if (!file) return std::nullopt;
  Result<Scenario> scenario = read_scenario(*file, {.files = files_on_disk()});
  if (scenario) return std::move(scenario).value();
  console.report(scenario.diagnostics());
  return std::nullopt;
}

std::optional<Recording> read_trace(const std::string& path, Console& console) {
  Diagnostics diagnostics;
  const Result<SourcePtr> source = read_source(path, kMaxTraceBytes);
  Result<Recording> recording =
      source ? parse_trace(source.value(), diagnostics) : Result<Recording>(source.diagnostics());
  console.report(diagnostics);
  if (recording) return std::move(recording).value();
  console.report(recording.diagnostics());
  return std::nullopt;
}

/// The drive as the only test of a comparison, which conditions of --fail-on are about.
Comparison comparison_of(const std::string& name, const Criteria& criteria,
                         const Recording& recording, const TestAssessment& assessment) {
  const auto others = static_cast<std::uint32_t>(recording.actors().size() - 1);
  const ExperimentPlan plan{.behaviours = {name}, .agents = {others}, .tests = 1};
  AssessmentTable table(criteria, plan);
  table.add({.agents = others}, assessment);
  const TestResult result{.ticks = static_cast<std::uint32_t>(recording.scenes() - 1)};
  Comparison comparison{.summaries = {summarise({&result, 1})}};
  comparison.summaries.front().behaviour = name;
  comparison.summaries.front().agents = others;
  add_assessments(criteria, table, plan.behaviours, comparison);
  return comparison;
}

/// Options that are about the tests of a store.
bool only_for_stores(const Arguments& arguments, Console& console) {
  for (const OptionName option : {option::kTest, option::kWrite, option::kCsv, option::kJson}) {
    if (!arguments.has(option)) continue;
    console.error(
        fmt::format("{} is about the tests of a store, not about a trace", option.dashed()));
    return true;
  }
  if (arguments.operands().empty()) return false;
  console.error("--trace stands in place of a store", "judge one of them at a time");
  return true;
}

}  // namespace

ExitCode judge_trace(const std::string& path, const Arguments& arguments, Console& console) {
  if (only_for_stores(arguments, console)) return ExitCode::usage;
  Diagnostics wrong;
  const std::vector<FailureCondition> conditions = read_conditions(arguments, wrong);
  console.report(wrong);
  if (wrong.has_errors()) return ExitCode::usage;
  const auto scenario = scenario_of(arguments, console);
  if (!scenario) return ExitCode::usage;
  const auto criteria = read_criteria(arguments, scenario->assertions, console);
  if (!criteria) return ExitCode::usage;
  if (!asks(*criteria)) {
    console.error("there is nothing to judge", "--assertions names a file of assertions");
    return ExitCode::usage;
  }
  if (!check_conditions(conditions, *criteria, console)) return ExitCode::usage;
  const auto recording = read_trace(path, console);
  if (!recording) return ExitCode::usage;

  const TestAssessment assessment = assess(*criteria, *recording, scenario->world->ground());
  const std::string name = std::filesystem::path(path).stem().string();
  if (!arguments.has(option::kQuiet)) {
    console.print(render_assessment(*criteria, assessment, recording->actors()));
  }
  if (const auto junit = arguments.text(option::kJunit)) {
    if (!write_output(*junit, to_junit(name, *criteria, assessment), console)) {
      return ExitCode::failed;
    }
  }
  const Comparison comparison = comparison_of(name, *criteria, *recording, assessment);
  return report_failures(conditions, comparison, console) ? ExitCode::failed : ExitCode::success;
}

}  // namespace jaywalk
