// SPDX-License-Identifier: Apache-2.0
// `jaywalk compare`: behaviours x numbers of agents x seeded tests, in parallel.

#include <functional>
#include <optional>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/comparison/compare_results.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/progress_line.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/store_options.h"
#include "tools/jaywalk/run/agent_trace.h"
#include "tools/jaywalk/run/trace_output.h"

namespace jaywalk::command::compare {

CommandHelp help() {
  CommandHelp help{
      .usage = "SCENARIO.yaml [OPTIONS]",
      .description =
          "Runs every behaviour of the scenario with every number of agents in many seeded\n"
          "tests, in parallel, and prints a table: accuracy, score and the other measures, in\n"
          "the paper's world beside the published values. Tests of the same number start alike\n"
          "whatever the behaviour. The results do not depend on --threads. Exits with 1 if no\n"
          "test of some row has a result.\n",
      .options =
          {
              {option::kBehaviours, "LIST",
               "these behaviours: names of the scenario's, of installed ones\n"
               "(jaywalk list behaviours) or .asl files, separated by commas;\n"
               "repeatable"},
              {option::kAgents, "LIST", "these numbers of agents, as 1..10,15,20"},
              {option::kTests, "N", "tests for each behaviour and number of agents"},
              {option::kThreads, "N", "threads (default: as many as cores)"},
              {option::kCsv, "FILE", "write the results as CSV", Written::file},
              {option::kJson, "FILE", "write the results as JSON, the published ones with them",
               Written::file},
              {option::kDefects, "LIST",
               "run each test with a healthy AV and with each of these defects\n"
               "of it (jaywalk list defects), as latency,short-range=12, or all"},
              {option::kAvs, "LIST",
               "run each test with each of these models of the AV and rank them:\n"
               "the world's (jaywalk list vehicles) or its simulator's, as\n"
               "constant,braking,idm"},
              {option::kKills, "FILE", "write which behaviours killed which defects as CSV",
               Written::file},
              {option::kWithKills, "FILE",
               "put the kills of such a file, as `search --kills` writes it, beside\n"
               "them; repeatable"},
              {option::kPerTest, "FILE",
               "write each test as a line of CSV: how it ended, ticks until the\n"
               "precondition, collision, impact speed, verdicts",
               Written::file},
              {option::kStarts, "FILE",
               "write the start cells of the largest number of agents as CSV,\n"
               "which world.spawn.cells reads",
               Written::file},
              {option::kReport, "FILE", "write a page (.html) or a picture (.svg) of the results",
               Written::file},
              {option::kFailOn, "EXPR",
               "exit with 1 if a row meets it, or lacks the value:\n"
               "MEASURE<NUMBER (also <= > >= == !=), as accuracy<40, or of an\n"
               "assertion ID.fail>0 (also pass, vacuous, unavoidable,\n"
               "exercised_pct); repeatable"},
              kPolicyOption,
              {option::kSituations, "", "print which situations the tests covered"},
              kCoverageOption,
              kTraceOption,
              kStrictOption,
              kFormatOption,
              {option::kQuiet, "", "print no table"},
          },
      .examples =
          "  jaywalk compare scenarios/paper.yaml\n"
          "  jaywalk compare scenarios/paper.yaml --tests 200 --agents 1,3,10 --csv out.csv\n"
          "  jaywalk compare scenarios/paper.yaml --behaviours proximity,mine.asl\n"
          "  jaywalk compare scenarios/paper.yaml --set world.spawn.choose=cell\n"
          "  jaywalk compare scenarios/rules_of_the_road.yaml --defects all --kills kills.csv\n"
          "  jaywalk compare scenarios/paper.yaml --store paper.gpkg --resume\n"
          "  jaywalk compare scenarios/paper.yaml --store 2.gpkg --shard 2/4\n"
          "  jaywalk compare scenarios/paper.yaml --behaviours election --fail-on 'accuracy<40'\n"
          "  jaywalk compare scenarios/paper.yaml --assertions "
          "scenarios/assertions/crossing.yaml\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  help.options.insert(help.options.end(), kJudgingOptions.begin(), kJudgingOptions.end());
  help.options.insert(help.options.end(), kStoreOptions.begin(), kStoreOptions.end());
  help.options.insert(help.options.end(), kScenarioOptions.begin(), kScenarioOptions.end());
  help.options.insert(help.options.end(), kLimitOptions.begin(), kLimitOptions.end());
  return help;
}

namespace {

/// Runs a test with those that listen to it; `file` may be null.
TestRun run_listened(const Request& request, TraceFile* file, const TestKey& test,
                     const TestSetup& setup, TestOptions& options,
                     const std::function<TestRun()>& run) {
  const ExperimentPlan& plan = request.comparison.plan;
  std::optional<PlanCoverage::Borrowed> counting;
  Observers observers;
  if (request.coverage != nullptr) observers.add(*counting.emplace(*request.coverage).get());
  std::optional<TestTrace> trace;
  if (file != nullptr) {
    observers.add(trace.emplace());
    options.observe = [&](const World& world, const Mas& mas) { trace->tick(world, mas); };
    trace->begin(plan.behaviours[test.behaviour], setup);
  }
  options.observer = observers.get();
  TestRun result = run();
  if (trace && !result.interrupted) {
    trace->end(result);
    file->add(plan.place_of(test), trace->lines());
  }
  return result;
}

/// Prints the results, writes the files asked for and evaluates --fail-on.
ExitCode conclude(const Request& request, const Arguments& arguments,
                  const ComparisonResults& results, const reporting::FactsTable& facts,
                  Console& console) {
  const Comparison& comparison = results.comparison;
  const OutputOptions& output = request.options.output;
  bool written = write_files(arguments, request, results, facts, console);
  if (request.coverage != nullptr) {
    const std::string subject = coverage_subject(results.description, {});
    written = write_coverage(arguments, request.coverage->total(), subject, console) && written;
  }
  show_comparison(output, comparison, console);
  if (request.options.situations) {
    console.print((output.shown ? "\n" : "") + situations_of(request, results));
  }
  for (const std::string& note : results.notes) console.note(note);
  if (!comparison.complete) {
    console.note(interruption(request, results));
    return ExitCode::interrupted;
  }
  const bool all_have = have_results(comparison, console);
  const bool failed = report_failures(request.options.conditions, comparison, console);
  if (fails_strictly(output, comparison, console) || failed || !written || !all_have) {
    return ExitCode::failed;
  }
  return ExitCode::success;
}

}  // namespace

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto request = read_request(arguments, console);
  if (!request || !can_be_run(*request, console)) return ExitCode::usage;

  const ExperimentPlan& plan = request->comparison.plan;
  const std::optional<StoreOptions>& store = request->comparison.store;
  reporting::FactsTable facts(plan);
  std::optional<TraceFile> trace;
  // While tests run, an interrupt keeps all finished ones in the store; before and after, nothing
  // polls for it.
  const InterruptGuard interrupt;
  std::optional<PromptEnd> end(std::in_place, interrupt);
  std::optional<ProgressLine> line;
  bool traced = false;
  ComparisonHooks hooks;
  hooks.opened = [&] {
    end.reset();
    if (!open_trace(arguments, trace, console)) return Proceed::no;
    line.emplace(console);
    return Proceed::yes;
  };
  hooks.progress = [&](const Progress& now) { line->show(now); };
  hooks.closed = [&](const std::optional<std::string>& unwritten) {
    line->clear();
    traced = finish_trace(arguments, trace, console);
    if (store && !unwritten) console.wrote(store->path);
    if (!interrupt.interrupted()) end.emplace(interrupt);
  };
  hooks.interrupted = [&] { return interrupt.interrupted(); };
  hooks.around = [&](const TestKey& test, const TestSetup& setup, TestOptions& options,
                     const std::function<TestRun()>& run) {
    return run_listened(*request, trace ? &*trace : nullptr, test, setup, options, run);
  };
  hooks.skipped = [&](const TestKey& test) {
    if (trace) trace->add(plan.place_of(test), {});
  };
  if (request->options.wants_page() && !store) {
    hooks.measured = [&](const TestKey& test, const TestResult& result,
                         const Recording& recording) { facts.add(test, result, recording); };
  }
  auto results = run_comparison(request->comparison, hooks);
  if (!results) {
    console.report(results.diagnostics());
    return line ? ExitCode::failed : ExitCode::usage;
  }
  if (!traced) return ExitCode::failed;
  add_kills(request->other_kills, results.value().comparison.kills);
  return conclude(*request, arguments, results.value(), facts, console);
}

}  // namespace jaywalk::command::compare
