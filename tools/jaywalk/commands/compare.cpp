// `jaywalk compare`: behaviours x numbers of agents x seeded tests, in parallel.

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

/// The results of the tests that were run.
struct Findings {
  const Collected& collected;
  const ExperimentOutcome& outcome;
  const Comparison& comparison;
  const reporting::FactsTable& facts;
};

/// Prints the results, writes the files asked for and evaluates --fail-on.
ExitCode conclude(const Request& request, const Arguments& arguments, const Findings& findings,
                  Console& console) {
  const auto& [collected, outcome, comparison, facts] = findings;
  bool written = write_files(arguments, request, collected, comparison, facts, console);
  if (request.coverage != nullptr) {
    const std::string subject = coverage_subject(request.description, {});
    written = write_coverage(arguments, request.coverage->total(), subject, console) && written;
  }
  show_comparison(arguments, comparison, console);
  if (arguments.has(option::kSituations)) {
    console.print((prints_table(arguments) ? "\n" : "") +
                  situations_of(request, comparison, collected.situations));
  }
  for (const std::string& note : collected.notes.texts()) console.note(note);
  if (!comparison.complete) {
    console.note(interruption(request, outcome, comparison));
    return ExitCode::interrupted;
  }
  const bool all_have = have_results(comparison, console);
  const bool failed = report_failures(request.conditions, comparison, console);
  if (fails_strictly(arguments, comparison, console) || failed || !written || !all_have) {
    return ExitCode::failed;
  }
  return ExitCode::success;
}

}  // namespace

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto request = read_request(arguments, console);
  if (!request) return ExitCode::usage;
  if (!can_be_run(*request, console)) return ExitCode::usage;

  Collected collected(*request);
  if (!add_earlier_tests(*request, collected, console)) return ExitCode::usage;
  // From here on an interrupt keeps all finished tests in the store.
  const InterruptGuard interrupt;
  std::unique_ptr<ResultsWriter> store;
  if (request->store) {
    const PromptEnd end(interrupt);
    auto opened = open_store(*request->store, request->description);
    if (!opened) {
      console.report(opened.diagnostics());
      return ExitCode::usage;
    }
    store = std::move(opened).value();
  }

  ProgressLine line(console);
  const Selection selection(*request, store.get());
  reporting::FactsTable facts(request->plan);
  std::optional<TraceFile> trace;
  if (!open_trace(arguments, trace, console)) return ExitCode::usage;
  const Listeners listeners{.collected = collected,
                            .store = store.get(),
                            .facts = wants_page(arguments) && !store ? &facts : nullptr,
                            .trace = trace ? &*trace : nullptr,
                            .interrupted = [&] { return interrupt.interrupted(); }};
  ExperimentOutcome outcome =
      run_selection(*request, selection, listeners, [&](const Progress& now) {
        line.show(now);
        return interrupt.interrupted() ? Proceed::no : Proceed::yes;
      });
  line.clear();
  const bool traced = finish_trace(arguments, trace, console);
  const bool kept = !store || is_kept(store->finish(), request->store->path, console);
  if (outcome.failed_test && !interrupt.interrupted()) {
    console.report(outcome.failure);
    return ExitCode::failed;
  }
  if (!kept || !traced) return ExitCode::failed;

  std::optional<PromptEnd> end;  // the long work from here on does not poll for interrupts
  if (!interrupt.interrupted()) end.emplace(interrupt);
  const std::optional<Comparison> comparison = comparison_of(*request, collected, outcome, console);
  if (!comparison) return ExitCode::failed;
  return conclude(*request, arguments, {collected, outcome, *comparison, facts}, console);
}

}  // namespace jaywalk::command::compare
