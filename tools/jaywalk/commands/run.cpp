// SPDX-License-Identifier: Apache-2.0
// `jaywalk run`: an agent, a project or one test of a scenario, once.

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/run/java_host.h"
#include "tools/jaywalk/run/own_world.h"
#include "tools/jaywalk/run/run_files.h"

namespace jaywalk::command::run {
namespace {

/// Options that mean something for one kind of file only.
constexpr std::array kForScenarios = {
    option::kSet,   option::kPreset, option::kBehaviour, option::kAgents,     option::kTest,
    option::kWatch, option::kSpeed,  option::kStore,     option::kAssertions, option::kMetrics,
    option::kJunit, option::kFailOn, option::kStrict,    option::kPolicy};
constexpr std::array kForPrograms = {option::kRealtime,    option::kThreads,
                                     option::kIgnoreJava,  option::kAllowWrite,
                                     option::kEnvironment, option::kEnvironmentTimeout,
                                     option::kJason};

bool refuse(std::span<const OptionName> options, std::string_view kind, const Arguments& arguments,
            Console& console) {
  Diagnostics diagnostics;
  for (const OptionName option : options) {
    if (arguments.has(option)) {
      diagnostics.error(option.dashed(), fmt::format("has no meaning for {}", kind));
    }
  }
  console.report(diagnostics);
  return diagnostics.has_errors();
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "FILE [OPTIONS]",
      .description =
          "Runs FILE once: an agent (.asl), a Jason project (.mas2j), or one test of a\n"
          "scenario (.yaml). What agents print goes to standard output as '[agent] text',\n"
          "everything else to standard error. Time is virtual: waiting costs none.\n"
          "A run ends when an agent stops it, or when every agent is idle and nothing is\n"
          "pending; the exit code is then 0, or 1 if an agent asked for that.\n",
      .options =
          {
              {option::kTimeout, "S", "give up after so many seconds, with exit code 1"},
              {option::kMaxCycles, "N", "stop after so many reasoning cycles of one agent"},
              {option::kMaxInferences, "N", "stop after so many inferences of all agents together"},
              {option::kMaxTicks, "N", "stop after so many ticks"},
              {option::kMaxMemory, "MB",
               "what each agent, and all of them together, may own (default 1024,\n"
               "and half of the machine's memory); what asks for more fails"},
              {option::kRealtime, "", "timers follow the wall clock"},
              {option::kThreads, "N",
               "so many agents reason at the same time (default 1); what they\n"
               "do and print does not depend on it"},
              kJasonOption,
              {option::kIgnoreJava, "",
               "run a project without its Java classes, or without those that\n"
               "--jason cannot run"},
              {option::kAllowWrite, "FOLDER",
               "the agents may write files in this folder, too, not only in the\n"
               "working one; repeatable"},
              {option::kBehaviour, "FILE",
               "of a scenario: this program (.asl), behaviour of the scenario\n"
               "or installed one (jaywalk list behaviours) instead of the first"},
              {option::kAgents, "N", "of a scenario: the number of pedestrians"},
              {option::kTest, "N", "of a scenario: which test, from 0"},
              kPolicyOption,
              {option::kWatch, "", "of a scenario: draw the test tick by tick"},
              {option::kSpeed, "X", "of --watch: ticks a second (default 2)"},
              kCoverageOption,
              {option::kTrace, "FILE.jsonl",
               "write what happens, a JSON object a line: test (of a program:\n"
               "run), tick (cycle), percept, event, message, plan, action with\n"
               "its outcome, failure, end",
               Written::file},
              {option::kStore, "FILE",
               "of a scenario: keep the test in this new GeoPackage (.gpkg)", Written::file},
              {option::kStrict, "",
               "of a scenario: exit with 1 if agents dropped intentions or\n"
               "never acted"},
              {option::kFailOn, "EXPR",
               "of a scenario: exit with 1 if the test meets it, as\n"
               "collision_avoidance.fail>0; repeatable"},
          },
      .examples =
          "  jaywalk run hello.asl\n"
          "  jaywalk run project.mas2j --timeout 10\n"
          "  jaywalk run project.mas2j --threads 8\n"
          "  jaywalk run robot.asl --environment \"python3 world.py\"\n"
          "  jaywalk run scenarios/paper.yaml --behaviour election --agents 3 --watch\n"
          "  jaywalk run scenarios/paper.yaml --behaviour mine.asl --test 7 --seed 42\n"};
  help.options.insert(std::ranges::find(help.options, option::kIgnoreJava, &OptionSpec::name),
                      std::begin(kWorldOptions), std::end(kWorldOptions));
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  help.options.insert(help.options.end(), kJudgingOptions.begin(), kJudgingOptions.end());
  help.options.insert(help.options.end(), kScenarioOptions.begin(), kScenarioOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  constexpr std::array kWanted{InputKind::program, InputKind::project, InputKind::scenario};
  Diagnostics wrong;
  const auto file = only_input(arguments, "run", "file", kWanted, wrong);
  console.report(wrong);
  if (!file) return ExitCode::usage;
  const std::string& path = *file;
  if (is_scenario_file(path)) {
    if (refuse(kForPrograms, "a scenario", arguments, console)) return ExitCode::usage;
    return run_scenario_file(path, arguments, console);
  }
  if (path.ends_with(".asl")) {
    if (refuse(kForScenarios, "an agent", arguments, console)) return ExitCode::usage;
    return run_agent_file(path, arguments, console);
  }
  if (path.ends_with(".mas2j")) {
    if (refuse(kForScenarios, "a project", arguments, console)) return ExitCode::usage;
    return run_project_file(path, arguments, console);
  }
  console.error(fmt::format("expected a file .asl, .mas2j or .yaml, found '{}'", path));
  return ExitCode::usage;
}

}  // namespace jaywalk::command::run
