// SPDX-License-Identifier: Apache-2.0
// `jaywalk reach`: which situations tests of a scenario can meet at all, and a script for each.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiment/compare/experiment.h"
#include "experiment/test_run/test_run.h"
#include "search/model_based/reachable_situations.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"

namespace jaywalk::command::reach {
namespace {

namespace js = jaywalk::search;

/// The behaviour that repeats walks.
constexpr const char* kScripted = "scripted";

/// Why walks cannot be followed in this world; empty if they can.
std::string objection(const WorldSpec& world) {
  if (world.kind() != "crossing") {
    return fmt::format("the scenario's world is {}; pedestrians walk in the crossing",
                       world.kind());
  }
  if (!world.command().empty() || !world.simulator().name.empty()) {
    return "a program or a simulator drives the AV: breadth-first, it would be started for each "
           "walk";
  }
  return {};
}

/// Checks the scenario before `scripted`, which other worlds do not have, replaces its behaviours.
/// Empty also if the scenario cannot be read: preparing it reports that.
std::string objection(const std::string& path, const Arguments& arguments) {
  const Result<Scenario> scenario = read_scenario(path, scenario_options(arguments, {}));
  return scenario.ok() ? objection(*scenario.value().world) : std::string();
}

std::optional<js::ReachPlan> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  const auto path = only_input(arguments, "reach", "scenario", kScenarios, diagnostics);
  js::ReachPlan plan;
  const auto tests = arguments.number(option::kTests, 1, diagnostics, kMaxTests);
  const auto seed = arguments.number(option::kSeed, 0, diagnostics);
  const auto states = arguments.number(option::kMostStates, 1, diagnostics);
  plan.threads = read_threads(arguments, diagnostics);
  console.report(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  if (const std::string why = objection(*path, arguments); !why.empty()) {
    console.error(why);
    return std::nullopt;
  }
  plan.prepared = prepare_scenario(*path, arguments, {kScripted}, console);
  if (plan.prepared == nullptr) return std::nullopt;
  const ExperimentSpec& experiment = plan.prepared->scenario().experiment;
  plan.seed = seed.value_or(experiment.seed);
  plan.tests = tests.value_or(std::max<std::uint64_t>(plan.tests, experiment.tests));
  plan.most_states = states.value_or(plan.most_states);
  if (const std::string why = problem(*plan.prepared, {.agents = 1}); !why.empty()) {
    console.error(why);
    return std::nullopt;
  }
  return plan;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "SCENARIO.yaml [OPTIONS]",
      .description =
          "Finds breadth-first which situations one pedestrian can bring about in a\n"
          "scenario, whatever it does, from the cells in which tests begin, against the AV\n"
          "with its controller: what tests have not covered but never can is no hole. With\n"
          "--csv, each situation with the start and the moves of the shortest walk to it,\n"
          "which the behaviour `scripted` repeats (its parameter `moves`).\n",
      .options =
          {
              {option::kTests, "N", "take the start cells of N tests (default: 2000)"},
              {option::kMostStates, "N", "give up after N states (default: 5000000)"},
              {option::kThreads, "N", "threads (default: as many as cores)"},
              {option::kCsv, "FILE", "write a row for each situation as CSV", Written::file},
              {option::kQuiet, "", "print no table"},
          },
      .examples =
          "  jaywalk reach scenarios/coverage_feedback.yaml --csv walks.csv\n"
          "  jaywalk reach scenarios/coverage_feedback.yaml --set world.length=40\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  help.options.insert(help.options.end(), kScenarioOptions.begin(), kScenarioOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  std::optional<js::ReachPlan> plan = read_request(arguments, console);
  if (!plan) return ExitCode::usage;
  const InterruptGuard interrupt;
  plan->interrupted = [&] { return interrupt.interrupted(); };
  const js::Reach found = js::reach(*plan);
  if (interrupt.interrupted()) {
    console.note("interrupted");
    return ExitCode::interrupted;
  }
  if (!arguments.has(option::kQuiet)) console.print(js::reach_text(found));
  const std::array outputs = {OutputFile{option::kCsv, [&] { return js::reach_csv(found); }}};
  return write_outputs(arguments, outputs, console) ? ExitCode::success : ExitCode::failed;
}

}  // namespace jaywalk::command::reach
