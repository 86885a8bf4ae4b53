// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/comparison/compare_request.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/scenario/number_list.h"
#include "experiment/test_run/simulator_version.h"
#include "experiment/test_run/test_run.h"
#include "experiment/test_run/tested_vehicles.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/store_options.h"

namespace jaywalk::command::compare {
namespace {

CompareOptions read_options(const Arguments& arguments, Diagnostics& diagnostics) {
  CompareOptions options;
  options.seed = arguments.number(option::kSeed, 0, diagnostics);
  options.tests = arguments.number(option::kTests, 1, diagnostics, kMaxTests);
  options.threads = read_threads(arguments, diagnostics);
  if (const auto text = arguments.text(option::kAgents)) {
    auto list = parse_number_list(*text, option::kAgents.dashed());
    if (list) {
      options.agents = std::move(list).value();
    } else {
      diagnostics.append(std::move(list.diagnostics()));
    }
  }
  options.conditions = read_conditions(arguments, diagnostics);
  options.limits = limit_sets(arguments, diagnostics);
  options.store = read_store_options(arguments, diagnostics);
  check_coverage_options(arguments, diagnostics);
  options.output = read_output_options(arguments, diagnostics);
  options.behaviours = listed(arguments, option::kBehaviours);
  options.report = arguments.text(option::kReport);
  options.kills = arguments.texts(option::kWithKills);
  for (const OptionName option : {option::kKills, option::kWithKills}) {
    if (arguments.has(option)) options.about_defects.push_back(option);
  }
  options.coverage = arguments.has(option::kCoverage);
  options.situations = arguments.has(option::kSituations);
  options.per_test = arguments.has(option::kPerTest);
  options.starts = arguments.has(option::kStarts);
  return options;
}

bool has_defects(const ExperimentPlan& plan) {
  return plan.vehicles.size() > 1 && !compares_models(plan.vehicles);
}

/// Whether agents start in cells, where nothing keeps tests from being run.
bool has_cells(const ComparisonRequest& request) {
  const TestSetup first{.agents = request.plan.agents.front(), .seed = request.seed, .test = 0};
  return !start_cells(request.prepared->scenario(), first).empty();
}

/// Reads the kills of other files; false after reporting errors in them.
bool read_other_kills(Request& request, Console& console) {
  const ExperimentPlan& plan = request.comparison.plan;
  constexpr std::size_t kMostBytes = std::size_t{1} << 26U;
  Diagnostics diagnostics;
  for (const std::string& path : request.options.kills) {
    const auto source = read_source(path, kMostBytes);
    auto lines = source.ok() ? parse_kills(source.value())
                             : Result<std::vector<KillLine>>(source.diagnostics());
    if (!lines.ok()) {
      diagnostics.append(lines.diagnostics());
      continue;
    }
    diagnostics.append(mistakes_of(lines.value(), plan, request.other_kills));
    request.other_kills.insert(request.other_kills.end(), lines.value().begin(),
                               lines.value().end());
  }
  console.report(diagnostics);
  if (diagnostics.has_errors()) return false;
  const auto others = other_defects(request.other_kills, plan);
  if (!others.empty() && plan.vehicles.size() > 1) {
    console.note(fmt::format("--with-kills: left out are defects that are not looked for here: {}",
                             fmt::join(others, ", ")));
  }
  return true;
}

}  // namespace

std::optional<Request> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  const auto file = only_input(arguments, "compare", "scenario", kScenarios, diagnostics);
  Request request{.options = read_options(arguments, diagnostics)};
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  const CompareOptions& options = request.options;
  auto prepared = prepare_scenario(*file, arguments, options.behaviours, console, options.limits);
  if (!prepared) return std::nullopt;
  ComparisonRequest& comparison = request.comparison;
  comparison = comparison_request(std::move(prepared));
  comparison.options = scenario_options(arguments, options.behaviours, options.limits);
  comparison.seed = options.seed.value_or(comparison.seed);
  comparison.plan.agents = options.agents.value_or(comparison.plan.agents);
  comparison.plan.tests = options.tests.value_or(comparison.plan.tests);
  comparison.plan.threads = options.threads;
  comparison.store = options.store;
  comparison.situations = options.situations;
  comparison.per_test = options.per_test;
  auto criteria = read_criteria(arguments, comparison.criteria.assertions, console);
  if (!criteria || !check_conditions(options.conditions, *criteria, console)) return std::nullopt;
  comparison.criteria = std::move(*criteria);
  auto simulator = simulator_version(comparison.prepared->scenario());
  if (!simulator.ok()) {
    console.report(simulator.diagnostics());
    return std::nullopt;
  }
  comparison.simulator = std::move(simulator).value();
  if (options.coverage) {
    const std::uint32_t most = std::ranges::max(comparison.plan.agents);
    request.coverage = std::make_unique<PlanCoverage>(*comparison.prepared,
                                                      all_behaviours(*comparison.prepared, most));
  }
  if (has_defects(comparison.plan) && !read_other_kills(request, console)) return std::nullopt;
  return request;
}

bool can_be_run(const Request& request, Console& console) {
  Diagnostics wrong = problems(request.comparison);
  if (!has_defects(request.comparison.plan)) {
    for (const OptionName option : request.options.about_defects) {
      wrong.error(option.dashed(), "has no meaning without defects",
                  "--defects names them, or all; jaywalk list defects shows them");
    }
  }
  if (!wrong.has_errors() && request.options.starts && !has_cells(request.comparison)) {
    wrong.error(option::kStarts.dashed(), "agents of this world do not start in cells",
                "it is for worlds with a grid, as that of scenarios/paper.yaml");
  }
  console.report(wrong);
  return !wrong.has_errors();
}

}  // namespace jaywalk::command::compare
