// `jaywalk compare`: behaviours x numbers of agents x seeded tests, in parallel.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/experiment.h"
#include "experiment/export/csv.h"
#include "experiment/export/json.h"
#include "experiment/export/junit.h"
#include "experiment/feedback.h"
#include "experiment/number_list.h"
#include "experiment/plan_coverage.h"
#include "experiment/report/chart.h"
#include "experiment/report/situation_table.h"
#include "experiment/report/verdict_table.h"
#include "experiment/results/reader.h"
#include "experiment/trial.h"
#include "experiment/verdict.h"
#include "tools/jaywalk/command.h"
#include "tools/jaywalk/coverage_options.h"
#include "tools/jaywalk/interrupt.h"
#include "tools/jaywalk/judging.h"
#include "tools/jaywalk/output_files.h"
#include "tools/jaywalk/progress_line.h"
#include "tools/jaywalk/reporting.h"
#include "tools/jaywalk/scenario_options.h"
#include "tools/jaywalk/shipped.h"
#include "tools/jaywalk/store_options.h"
#include "tools/jaywalk/usual_options.h"

namespace jaywalk::command::compare {
namespace {

/// Everything that the command line says, once it is known to be right.
struct Request {
  std::shared_ptr<const PreparedScenario> prepared;
  std::uint64_t seed = 0;
  ExperimentPlan plan;
  std::vector<FailureCondition> conditions;
  std::optional<StoreOptions> store;
  Inquiry inquiry;
  Ground ground;
  /// Null: nobody asks for it.
  std::unique_ptr<PlanCoverage> coverage;
  bool situations = false;
};

/// What is collected while tests run, beside their results.
struct Collected {
  explicit Collected(const Request& request)
      : findings(request.inquiry, request.plan), situations(request.plan) {
    const std::uint64_t generation = request.prepared->scenario().experiment.feedback;
    if (generation > 0) feedback.emplace(request.plan, generation, situations);
  }

  FindingsTable findings;
  SituationTable situations;
  std::optional<CoverageFeedback> feedback;
};

/// What can be read without the scenario, so that all its mistakes are reported at once.
struct Options {
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> tests;
  unsigned threads = 1;
  std::optional<std::vector<std::uint32_t>> agents;
  std::vector<FailureCondition> conditions;
  std::optional<StoreOptions> store;
};

Options read_options(const Arguments& arguments, Diagnostics& diagnostics) {
  Options options;
  options.seed = arguments.number("seed", 0, diagnostics);
  options.tests = arguments.number("tests", 1, diagnostics);
  options.threads = read_threads(arguments, diagnostics);
  if (const auto text = arguments.text("agents")) {
    auto list = parse_number_list(*text, "--agents");
    if (list) {
      options.agents = std::move(list).value();
    } else {
      diagnostics.append(std::move(list.diagnostics()));
    }
  }
  options.conditions = read_conditions(arguments, diagnostics);
  options.store = read_store_options(arguments, diagnostics);
  check_coverage_options(arguments, diagnostics);
  return options;
}

std::optional<Request> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  if (arguments.operands().size() != 1) {
    diagnostics.error("compare",
                      fmt::format("expected one scenario, found {}", arguments.operands().size()),
                      "jaywalk compare --help shows how to write it");
  }
  const Options options = read_options(arguments, diagnostics);
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  Request request{.prepared = prepare_scenario(located(arguments.operands().front()), arguments,
                                               listed(arguments, "behaviours"), console),
                  .conditions = options.conditions,
                  .store = options.store};
  if (!request.prepared) return std::nullopt;
  const ExperimentSpec& defaults = request.prepared->scenario().experiment;
  request.seed = options.seed.value_or(defaults.seed);
  request.plan.agents = options.agents.value_or(defaults.agents);
  request.plan.tests = options.tests.value_or(defaults.tests);
  request.plan.threads = options.threads;
  for (const PreparedBehaviour& behaviour : request.prepared->behaviours()) {
    request.plan.behaviours.push_back(behaviour.name);
  }
  auto inquiry = read_inquiry(arguments, request.prepared->scenario().assertions, console);
  if (!inquiry || !check_conditions(request.conditions, *inquiry, console)) return std::nullopt;
  request.inquiry = std::move(*inquiry);
  request.ground = ground(request.prepared->scenario().world);
  if (arguments.has("coverage")) {
    request.coverage = std::make_unique<PlanCoverage>(*request.prepared);
  }
  request.situations = arguments.has("situations") || defaults.feedback > 0;
  return request;
}

/// What is too large to be carried out.
Diagnostics excesses(const Request& request) {
  Diagnostics diagnostics;
  if (request.plan.tests > kMaxTests) {
    diagnostics.error("--tests",
                      fmt::format("at most {}, found {}", kMaxTests, request.plan.tests));
  }
  for (const std::uint32_t agents : request.plan.agents) {
    if (agents > kMaxAgents) {
      diagnostics.error("--agents", fmt::format("at most {}, found {}", kMaxAgents, agents));
    }
  }
  const bool is_part = request.store && request.store->shard.count > 1;
  if (is_part && request.prepared->scenario().experiment.feedback > 0) {
    diagnostics.error("--shard", "the tests of a part need what the other parts' tests cover",
                      "experiment.feedback=0 runs them without that");
  }
  return diagnostics;
}

/// Why some test cannot be run (there are no start cells for it, say); empty if all can.
std::string first_obstacle(const Request& request) {
  for (const std::uint32_t agents : request.plan.agents) {
    for (std::uint64_t test = 0; test < request.plan.tests; ++test) {
      // Obstacles are the same for all behaviours, and only given start cells can be too few.
      std::string why =
          obstacle(*request.prepared, {.agents = agents, .seed = request.seed, .test = test});
      if (!why.empty() || !request.prepared->scenario().start_cells) return why;
    }
  }
  return {};
}

Diagnostics not_run(const TestCase& test, std::string_view behaviour, std::string why) {
  Diagnostics diagnostics;
  diagnostics.error(fmt::format("{}, {} agents, test {}", behaviour, test.agents, test.number),
                    std::move(why));
  return diagnostics;
}

/// Who wants to know about the tests as they are run; null: nobody.
struct Listeners {
  Collected& collected;
  ResultsWriter* store = nullptr;
  reporting::FactsTable* facts = nullptr;
};

/// Runs a test, finds out about it and hands it to the store, if there is one.
Result<TestResult> run_test(const Request& request, const TestCase& test,
                            const Listeners& listeners) {
  ResultsWriter* const store = listeners.store;
  const bool recorded =
      store != nullptr || listeners.facts != nullptr || asks(request.inquiry) || request.situations;
  TrialInput input{.behaviour = test.behaviour,
                   .agents = test.agents,
                   .seed = request.seed,
                   .test = test.number};
  std::optional<CoverageFeedback>& feedback = listeners.collected.feedback;
  if (feedback) {
    auto told = feedback->wait_for(test);
    if (!told) return not_run(test, request.plan.behaviours[test.behaviour], "given up");
    input.feedback = std::move(*told);
  }
  const auto start = std::chrono::steady_clock::now();
  Recording recording;
  TrialOptions options{.record = recorded ? &recording : nullptr, .measure_cpu = true};
  std::optional<PlanCoverage::Borrowed> observer;
  if (request.coverage != nullptr) options.observer = observer.emplace(*request.coverage).get();
  TrialResult trial = run_trial(*request.prepared, input, options);
  const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
  if (!trial.completed) {
    return not_run(test, request.plan.behaviours[test.behaviour], std::move(trial.message));
  }
  const TestResult result{.succeeded = trial.outcome.success,
                          .ticks = static_cast<std::uint32_t>(trial.outcome.ticks),
                          .score = trial.outcome.score(),
                          .cpu_us = trial.cpu_s * 1e6,
                          .wall_us = wall.count()};
  std::vector<Assessment> assessments;
  if (asks(request.inquiry)) {
    const TestFindings found = assess(request.inquiry, recording, request.ground);
    listeners.collected.findings.add(test, found);
    if (store != nullptr) assessments = to_assessments(request.inquiry, found);
  }
  if (listeners.facts != nullptr) listeners.facts->add(test, result, recording);
  if (request.situations) {
    listeners.collected.situations.add(test, covered_bins(recording, request.ground));
    if (feedback) feedback->finished(test);
  }
  if (store != nullptr) {
    TestRecord record = make_test_record(test, result, trial, std::move(recording));
    record.assessments = std::move(assessments);
    store->add(std::move(record));
  }
  return result;
}

/// What is to be run: everything, or what the store wants and does not have.
class Selection {
 public:
  Selection(const Request& request, const ResultsWriter* store)
      : store_(store), shard_(request.store ? request.store->shard : Shard{}) {
    const ExperimentPlan& plan = request.plan;
    const std::uint64_t cells = plan.behaviours.size() * plan.agents.size();
    const std::uint64_t each = (plan.tests + shard_.count - shard_.index) / shard_.count;
    wanted_ = cells * each - (store != nullptr ? store->had() : 0);
  }

  [[nodiscard]] bool has(const TestCase& test) const {
    return shard_.has(test.number) && (store_ == nullptr || !store_->had(test));
  }
  /// How many tests it has.
  [[nodiscard]] std::uint64_t size() const { return wanted_; }

 private:
  const ResultsWriter* store_;
  Shard shard_;
  std::uint64_t wanted_ = 0;
};

/// Runs what is selected; whoever looks at the progress sees nothing of the rest.
ExperimentOutcome run_selection(const Request& request, const Selection& selection,
                                const Listeners& listeners, const ProgressFunction& progress) {
  std::optional<CoverageFeedback>& feedback = listeners.collected.feedback;
  std::atomic<std::uint64_t> done = 0;
  const auto test = [&](const TestCase& test_case) -> Result<TestResult> {
    if (!selection.has(test_case)) return TestResult{};
    auto result = run_test(request, test_case, listeners);
    if (!result && feedback) feedback->give_up();
    done.fetch_add(1, std::memory_order_relaxed);
    return result;
  };
  const auto own_progress = [&](const Progress&) {
    const bool broken = listeners.store != nullptr && listeners.store->failure();
    Proceed proceed = progress({.done = done, .total = selection.size()});
    if (broken) proceed = Proceed::no;
    if (proceed == Proceed::no && feedback) feedback->give_up();
    return proceed;
  };
  ExperimentOutcome outcome = run_experiment(request.plan, test, own_progress);
  outcome.progress = {.done = done, .total = selection.size()};
  return outcome;
}

ExperimentDescription describe_experiment(const Request& request, const Arguments& arguments) {
  ExperimentDescription description =
      describe(*request.prepared, scenario_options(arguments, listed(arguments, "behaviours")),
               request.plan, request.seed);
  add_judging(description, request.inquiry.files, request.inquiry.metrics);
  return description;
}

/// What the tests that a store to be continued has have covered, so that later ones can be told.
bool add_earlier_situations(const Request& request, Collected& collected, Console& console) {
  if (!request.situations || !request.store || !request.store->resume) return true;
  std::error_code ignored;
  if (!std::filesystem::exists(request.store->path, ignored)) return true;
  const auto store = ResultsReader::open(request.store->path);
  const auto tests =
      store.ok() ? store.value()->tests() : Result<std::vector<StoredTest>>(store.diagnostics());
  if (!tests.ok()) {
    console.report(tests.diagnostics());
    return false;
  }
  for (const StoredTest& stored : tests.value()) {
    if (stored.result.succeeded) {
      const auto recording = store.value()->recording(stored.id);
      if (!recording.ok()) {
        console.report(recording.diagnostics());
        return false;
      }
      collected.situations.add(stored.test, covered_bins(recording.value(), request.ground));
    }
    if (collected.feedback) collected.feedback->finished(stored.test);
  }
  return true;
}

std::vector<SituationRow> situation_rows(const Request& request, const Comparison& comparison,
                                         const SituationTable& table) {
  std::vector<SituationRow> rows;
  for (const Summary& summary : comparison.summaries) {
    const auto place = std::ranges::find(request.plan.behaviours, summary.behaviour);
    const auto behaviour = static_cast<std::size_t>(place - request.plan.behaviours.begin());
    rows.push_back({summary.behaviour, summary.agents,
                    table.coverage(behaviour, summary.agents, request.plan.tests)});
  }
  return rows;
}

/// Summed up from the store, which may have had tests before; nothing after reporting why not.
std::optional<Comparison> stored_comparison(const Request& request, Console& console) {
  const std::string& path = request.store->path;
  auto store = ResultsReader::open(path);
  if (!store) {
    console.report(store.diagnostics());
    return std::nullopt;
  }
  auto comparison = store.value()->comparison();
  if (comparison) return std::move(comparison).value();
  console.report(comparison.diagnostics());
  return std::nullopt;
}

Comparison make_comparison(const Request& request, ExperimentOutcome& outcome) {
  Comparison comparison{.scenario = request.prepared->scenario().name,
                        .seed = request.seed,
                        .tests = request.plan.tests,
                        .summaries = std::move(outcome.summaries),
                        .complete = outcome.complete()};
  for (Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(request.prepared->behaviours(), summary.behaviour,
                                             &PreparedBehaviour::name);
    summary.code_lines = behaviour->code_lines;
  }
  return comparison;
}

/// The start cells of all tests of the largest number of agents.
std::string start_cells_csv(const Request& request) {
  const std::uint32_t agents = *std::ranges::max_element(request.plan.agents);
  return print_start_cells(
      start_cells(request.prepared->scenario(), agents, request.seed, request.plan.tests));
}

/// A page, and not a picture.
bool wants_page(const Arguments& arguments) {
  const auto report = arguments.text("report");
  return report && !report->ends_with(".svg");
}

std::optional<std::string> report_of(const Arguments& arguments, const Request& request,
                                     const Comparison& comparison,
                                     const reporting::FactsTable& facts, Console& console) {
  if (!wants_page(arguments)) return render_svg(comparison);
  if (request.store) {
    return stored_report(request.store->path, *arguments.text("report"), ReplayPages::none,
                         console);
  }
  return unstored_report({.comparison = comparison,
                          .description = describe_experiment(request, arguments),
                          .prepared = request.prepared,
                          .inquiry = request.inquiry,
                          .facts = facts});
}

bool write_files(const Arguments& arguments, const Request& request, const Comparison& comparison,
                 const reporting::FactsTable& facts, Console& console) {
  const std::array files = {
      OutputFile{"csv", [&] { return to_csv(comparison); }},
      OutputFile{"json", [&] { return to_json(comparison); }},
      OutputFile{"junit", [&] { return to_junit(comparison); }},
      OutputFile{"starts", [&] { return start_cells_csv(request); }},
      OutputFile{"report",
                 [&] { return report_of(arguments, request, comparison, facts, console); }},
  };
  return write_outputs(arguments, files, console);
}

/// What is there, and how to get the rest.
std::string interruption(const Request& request, const ExperimentOutcome& outcome,
                         const Comparison& comparison) {
  std::string text = fmt::format(
      "interrupted after {} of {} tests; the rows shown and written are finished, {} of {}.\n",
      outcome.progress.done, outcome.progress.total, comparison.summaries.size(),
      request.plan.behaviours.size() * request.plan.agents.size());
  if (!request.store) {
    return text +
           "To get the others, run the same command again (--behaviours and --agents leave out "
           "rows).";
  }
  return text + fmt::format(
                    "All finished tests are in '{}'; the same command with --resume runs "
                    "the others.",
                    request.store->path);
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "SCENARIO.yaml [OPTIONS]",
      .description =
          "Runs every behaviour of the scenario with every number of agents in many seeded\n"
          "tests, in parallel, and prints a table: accuracy, score and the other measures,\n"
          "beside the values that the paper published. Tests of the same number start alike\n"
          "whatever the behaviour. The results do not depend on --threads.\n",
      .options =
          {
              {"behaviours", "LIST",
               "these behaviours: names of the scenario's or .asl files,\n"
               "separated by commas; repeatable"},
              {"agents", "LIST", "these numbers of agents, as 1..10,15,20"},
              {"tests", "N", "tests for each behaviour and number of agents"},
              {"threads", "N", "threads (default: as many as cores)"},
              {"csv", "FILE", "write the results as CSV"},
              {"json", "FILE", "write the results as JSON, the published ones with them"},
              {"starts", "FILE",
               "write the start cells of the largest number of agents as CSV,\n"
               "which world.spawn.cells reads"},
              {"report", "FILE", "write a page (.html) or a picture (.svg) of the results"},
              {"fail-on", "EXPR",
               "exit with 1 if a row meets it: MEASURE<NUMBER (also <= > >=\n"
               "== !=), as accuracy<40, or of an assertion ID.fail>0 (also\n"
               "pass, vacuous, unavoidable, exercised_pct); repeatable"},
              {"situations", "", "print which situations the tests covered"},
              kCoverageOption,
              {"quiet", "", "print no table"},
          },
      .examples =
          "  jaywalk compare scenarios/paper.yaml\n"
          "  jaywalk compare scenarios/paper.yaml --tests 200 --agents 1,3,10 --csv out.csv\n"
          "  jaywalk compare scenarios/paper.yaml --behaviours proximity,mine.asl\n"
          "  jaywalk compare scenarios/paper.yaml --set world.spawn.choose=cell\n"
          "  jaywalk compare scenarios/paper.yaml --store paper.gpkg --resume\n"
          "  jaywalk compare scenarios/paper.yaml --store 2.gpkg --shard 2/4\n"
          "  jaywalk compare scenarios/paper.yaml --behaviours election --fail-on 'accuracy<40'\n"
          "  jaywalk compare scenarios/paper.yaml --assertions "
          "scenarios/assertions/crossing.yaml\n"};
  help.options.insert(help.options.end(), kJudgingOptions.begin(), kJudgingOptions.end());
  help.options.insert(help.options.end(), kStoreOptions.begin(), kStoreOptions.end());
  help.options.insert(help.options.end(), kScenarioOptions.begin(), kScenarioOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto request = read_request(arguments, console);
  if (!request) return ExitCode::usage;
  if (const Diagnostics wrong = excesses(*request); wrong.has_errors()) {
    console.report(wrong);
    return ExitCode::usage;
  }
  if (const std::string why = first_obstacle(*request); !why.empty()) {
    console.error(why);
    return ExitCode::usage;
  }

  Collected collected(*request);
  FindingsTable& findings = collected.findings;
  if (!add_earlier_situations(*request, collected, console)) return ExitCode::usage;
  // Whoever sees that there is a store may end us, and what is finished is kept.
  const InterruptGuard interrupt;
  std::unique_ptr<ResultsWriter> store;
  if (request->store) {
    store = open_store(*request->store, describe_experiment(*request, arguments), console);
    if (!store) return ExitCode::usage;
  }

  ProgressLine line(console);
  const Selection selection(*request, store.get());
  reporting::FactsTable facts(request->plan);
  const Listeners listeners{.collected = collected,
                            .store = store.get(),
                            .facts = wants_page(arguments) && !store ? &facts : nullptr};
  ExperimentOutcome outcome =
      run_selection(*request, selection, listeners, [&](const Progress& now) {
        line.show(now);
        return interrupt.interrupted() ? Proceed::no : Proceed::yes;
      });
  line.clear();
  const bool kept = !store || finish_store(*store, request->store->path, console);
  if (outcome.failed_test && !interrupt.interrupted()) {
    console.report(outcome.failure);
    return ExitCode::failed;
  }
  if (!kept) return ExitCode::failed;

  std::optional<Comparison> comparison =
      request->store ? stored_comparison(*request, console) : make_comparison(*request, outcome);
  if (!comparison) return ExitCode::failed;
  if (!store) add_findings(request->inquiry, findings, request->plan.behaviours, *comparison);
  bool written = write_files(arguments, *request, *comparison, facts, console);
  if (request->coverage != nullptr) {
    written = write_coverage(arguments, request->coverage->total(), console) && written;
  }
  const bool quiet = arguments.has("quiet");
  if (!quiet) console.print(render_tables(*comparison));
  if (arguments.has("situations")) {
    const auto rows = situation_rows(*request, *comparison, collected.situations);
    console.print((quiet ? "" : "\n") + situation_text(rows));
  }
  if (!comparison->complete) {
    console.note(interruption(*request, outcome, *comparison));
    return ExitCode::interrupted;
  }
  if (report_failures(request->conditions, *comparison, console) || !written) {
    return ExitCode::failed;
  }
  return ExitCode::success;
}

}  // namespace jaywalk::command::compare
