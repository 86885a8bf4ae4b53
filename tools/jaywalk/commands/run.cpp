// `jaywalk run`: an agent, a project or one test of a scenario, once.

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/shipped.h"
#include "tools/jaywalk/run/run_program.h"
#include "tools/jaywalk/run/run_scenario.h"

namespace jaywalk::command::run {
namespace {

/// Options that mean something for one kind of file only.
constexpr std::array<std::string_view, 14> kForScenarios = {
    "set",   "preset",     "behaviour", "agents", "test",    "watch",  "speed",
    "store", "assertions", "metrics",   "junit",  "fail-on", "strict", "policy"};
constexpr std::array<std::string_view, 4> kForPrograms = {"realtime", "threads", "ignore-java",
                                                          "allow-write"};

bool refuse(std::span<const std::string_view> options, std::string_view kind,
            const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  for (const std::string_view option : options) {
    if (arguments.has(option)) {
      diagnostics.error(fmt::format("--{}", option), fmt::format("has no meaning for {}", kind));
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
              {"timeout", "S", "give up after so many seconds, with exit code 1"},
              {"max-cycles", "N", "stop after so many reasoning cycles of one agent"},
              {"max-inferences", "N", "stop after so many inferences of all agents together"},
              {"max-ticks", "N", "stop after so many ticks"},
              {"max-memory", "MB",
               "what each agent, and all of them together, may own (default 1024,\n"
               "and half of the machine's memory); what asks for more fails"},
              {"realtime", "", "timers follow the wall clock"},
              {"threads", "N",
               "so many agents reason at the same time (default 1); what they\n"
               "do and print does not depend on it"},
              {"ignore-java", "", "run a project without its Java classes"},
              {"allow-write", "FOLDER",
               "the agents may write files in this folder, too, not only in the\n"
               "working one; repeatable"},
              {"behaviour", "FILE",
               "of a scenario: this program (.asl), behaviour of the scenario\n"
               "or installed one (jaywalk list behaviours) instead of the first"},
              {"agents", "N", "of a scenario: the number of pedestrians"},
              {"test", "N", "of a scenario: which test, from 0"},
              kPolicyOption,
              {"watch", "", "of a scenario: draw the test tick by tick"},
              {"speed", "X", "of --watch: ticks a second (default 2)"},
              kCoverageOption,
              {"trace", "FILE.jsonl",
               "write what happens, a JSON object a line: test (of a program:\n"
               "run), tick (cycle), percept, event, message, plan, action with\n"
               "its outcome, failure, end",
               Written::file},
              {"store", "FILE", "of a scenario: keep the test in this new GeoPackage (.gpkg)",
               Written::file},
              {"strict", "",
               "of a scenario: exit with 1 if agents dropped intentions or\n"
               "never acted"},
              {"fail-on", "EXPR",
               "of a scenario: exit with 1 if the test meets it, as\n"
               "collision_avoidance.fail>0; repeatable"},
          },
      .examples =
          "  jaywalk run hello.asl\n"
          "  jaywalk run project.mas2j --timeout 10\n"
          "  jaywalk run project.mas2j --threads 8\n"
          "  jaywalk run scenarios/paper.yaml --behaviour election --agents 3 --watch\n"
          "  jaywalk run scenarios/paper.yaml --behaviour mine.asl --test 7 --seed 42\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  help.options.insert(help.options.end(), kJudgingOptions.begin(), kJudgingOptions.end());
  help.options.insert(help.options.end(), kScenarioOptions.begin(), kScenarioOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().size() != 1) {
    console.error(fmt::format("expected one file, found {}", arguments.operands().size()),
                  "jaywalk run --help shows how to write it");
    return ExitCode::usage;
  }
  const std::string path = located(arguments.operands().front());
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
