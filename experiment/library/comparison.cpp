#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "experiment/compare/carry_over.h"
#include "experiment/compare/experiment.h"
#include "experiment/compare/first_tests.h"
#include "experiment/library/test_report.h"
#include "experiment/results/reader.h"
#include "experiment/results/writer.h"
#include "experiment/test_run/simulator_version.h"
#include <jaywalk/comparison.h>

namespace jaywalk {
namespace {

bool asks_for_judgement(const Criteria& criteria) {
  return criteria.metrics || !criteria.assertions.empty();
}

/// The comparison under way: what all tests share.
class Comparing {
 public:
  Comparing(const RunnableScenario& scenario, const ComparisonOptions& options)
      : options_(options),
        prepared_(*scenario.prepared()),
        seed_(options.seed.value_or(scenario.seed())),
        rules_(options.rules.value_or(scenario.rules())),
        plan_(plan_for(scenario)),
        scenario_options_(scenario.options()),
        ground_(prepared_.scenario().world->ground()),
        runners_(prepared_),
        first_tests_(plan_),
        carry_over_(plan_),
        assessments_(criteria(), plan_) {}

  /// Options that cannot be carried out.
  [[nodiscard]] Diagnostics obstacles() const;
  [[nodiscard]] Result<ComparisonReport> run();

 private:
  [[nodiscard]] ExperimentPlan plan_for(const RunnableScenario& scenario) const;
  [[nodiscard]] const Criteria& criteria() const { return rules_.criteria(); }
  [[nodiscard]] bool is_chained() const { return plan_.order == TestOrder::chained; }
  [[nodiscard]] Result<ExperimentDescription> description() const;
  /// Opens the store, if there is one, and takes from it what later tests depend on.
  [[nodiscard]] Diagnostics open_store();
  [[nodiscard]] Diagnostics add_first_tests();
  [[nodiscard]] Result<TestResult> run_test(const TestKey& test);
  void keep(const TestKey& test, const TestResult& result, const TestRun& run, Recording recording);
  [[nodiscard]] Result<ComparisonReport> summed_up(ExperimentOutcome outcome) const;

  const ComparisonOptions& options_;
  const PreparedScenario& prepared_;
  std::uint64_t seed_;
  JudgingRules rules_;
  ExperimentPlan plan_;
  const ScenarioOptions& scenario_options_;
  Ground ground_;
  TestRunners runners_;
  FirstTests first_tests_;
  CarryOver carry_over_;
  AssessmentTable assessments_;
  std::unique_ptr<ResultsWriter> store_;
  bool is_given_up_ = false;  // by the caller
};

Diagnostics trouble_about(std::string subject, std::string why) {
  Diagnostics diagnostics;
  diagnostics.error(std::move(subject), std::move(why));
  return diagnostics;
}

ExperimentPlan Comparing::plan_for(const RunnableScenario& scenario) const {
  ExperimentPlan plan{.behaviours = scenario.behaviours(),
                      .agents = options_.agents.value_or(scenario.agents()),
                      .tests = options_.tests.value_or(scenario.tests()),
                      .order = test_order(prepared_.scenario()),
                      .summed_up = options_.store.empty(),
                      .threads = std::max(1U, options_.threads)};
  plan.vehicles = {scenario.vehicles().front()};
  return plan;
}

Diagnostics Comparing::obstacles() const {
  if (prepared_.vehicles().size() > 1) {
    return trouble_about("experiment", "tests with several AVs are run by `jaywalk compare` alone");
  }
  if (prepared_.scenario().experiment.feedback > 0) {
    return trouble_about("experiment.feedback", "such tests are run by `jaywalk compare` alone");
  }
  if (plan_.tests == 0 || plan_.tests > kMaxTests) {
    return trouble_about("tests",
                         fmt::format("expected 1 to {}, found {}", kMaxTests, plan_.tests));
  }
  if (plan_.agents.empty() || std::ranges::count(plan_.agents, 0U) > 0) {
    return trouble_about("agents", "expected one number of agents or more, each at least 1");
  }
  if (options_.resume && options_.store.empty()) {
    return trouble_about("resume", "there is no store to go on with");
  }
  if (options_.resume && is_chained()) {
    return trouble_about("resume", "each test of this scenario needs the one before it");
  }
  for (const std::uint32_t agents : plan_.agents) {
    std::string why = problem(prepared_, {.agents = agents, .seed = seed_});
    if (!why.empty()) return trouble_about("agents", std::move(why));
  }
  return {};
}

Result<ExperimentDescription> Comparing::description() const {
  ExperimentDescription description = describe(prepared_, scenario_options_, plan_, seed_);
  add_judging(description, criteria().files, criteria().metrics);
  make_portable(description, prepared_.scenario().files);
  auto simulator = simulator_version(prepared_.scenario());
  if (!simulator) return std::move(simulator.diagnostics());
  description.simulator = std::move(simulator).value();
  return description;
}

Diagnostics Comparing::open_store() {
  if (options_.store.empty()) return {};
  const auto described = description();
  if (!described) return described.diagnostics();
  auto opened = options_.resume ? ResultsWriter::resume(options_.store, described.value())
                                : ResultsWriter::create(options_.store, described.value());
  if (!opened) return std::move(opened.diagnostics());
  store_ = std::move(opened).value();
  return {};
}

// Stored first tests decide about the others of their row as they did when they were run.
Diagnostics Comparing::add_first_tests() {
  if (!options_.resume) return {};
  const auto earlier = ResultsReader::open(options_.store);
  if (!earlier) return {};  // it is made now, or opening it says why not
  const ResultsReader& store = *earlier.value();
  const ExperimentPlan plan = plan_of(store.description());
  if (plan.behaviours != plan_.behaviours || plan.agents != plan_.agents) return {};
  Diagnostics trouble;
  const auto unread = store.for_each_test({}, [&](const StoredTest& stored) {
    if (stored.test.number >= std::min(FirstTests::kCount, plan_.tests)) return Proceed::yes;
    const auto error = store.error(stored.id);
    if (error) first_tests_.finished(stored.test, error.value());
    if (!error) trouble.append(error.diagnostics());
    return error ? Proceed::yes : Proceed::no;
  });
  if (unread) trouble.append(*unread);
  return trouble;
}

Result<TestResult> Comparing::run_test(const TestKey& test) {
  if (store_ != nullptr && store_->had(test)) return TestResult{};
  const auto not_run = [&](std::string why) {
    first_tests_.give_up();
    return trouble_about(fmt::format("{}, agents {}, test {}", plan_.behaviours[test.behaviour],
                                     test.agents, test.number),
                         std::move(why));
  };
  TestSetup setup{
      .behaviour = test.behaviour, .agents = test.agents, .seed = seed_, .test = test.number};
  if (is_chained()) setup.head_start = carry_over_.head_start(test);
  const auto why_not = first_tests_.why_not_started(test);
  if (!why_not) return not_run("given up");
  Recording recording;
  const bool is_recorded = store_ != nullptr || asks_for_judgement(criteria());
  const TestOptions how{.record = is_recorded ? &recording : nullptr, .measure_cpu = true};
  const auto start = std::chrono::steady_clock::now();
  const TestRun run = why_not->empty() ? runners_.run(setup, how) : errored_test(*why_not, how);
  const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
  first_tests_.finished(test, run.completed ? std::string() : run.message);
  if (is_chained()) carry_over_.finished(test, run.left_over);
  TestResult result{.errored = !run.completed,
                    .ticks = static_cast<std::uint32_t>(run.outcome.ticks),
                    .cpu_us = run.cpu_s * 1e6,
                    .wall_us = wall.count()};
  if (run.completed) {
    result.succeeded = run.outcome.success;
    result.score = run.outcome.score();
  }
  keep(test, result, run, std::move(recording));
  return result;
}

// Judges a test, and hands it to the store if there is one.
void Comparing::keep(const TestKey& test, const TestResult& result, const TestRun& run,
                     Recording recording) {
  std::vector<AssessmentRow> rows;
  if (run.completed && asks_for_judgement(criteria())) {
    const TestAssessment found = assess(criteria(), recording, ground_);
    // Assessments that go into a store are summed up from there.
    if (store_ == nullptr) assessments_.add(test, found);
    if (store_ != nullptr) rows = to_rows(criteria(), found);
  }
  if (store_ == nullptr) return;
  TestRecord record = make_test_record(test, result, run, std::move(recording));
  record.assessments = std::move(rows);
  store_->add(std::move(record));
}

Result<ComparisonReport> Comparing::summed_up(ExperimentOutcome outcome) const {
  if (!options_.store.empty()) {
    const auto reader = ResultsReader::open(options_.store);
    if (!reader) return reader.diagnostics();
    const auto stored = reader.value()->comparison();
    if (!stored) return stored.diagnostics();
    return report_of(stored.value());
  }
  Comparison comparison{.scenario = prepared_.scenario().name,
                        .seed = seed_,
                        .tests = plan_.tests,
                        .summaries = std::move(outcome.summaries),
                        .published = published_rows(prepared_),
                        .assertions = ids_of(criteria()),
                        .complete = outcome.complete()};
  for (Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(plan_.behaviours, summary.behaviour);
    const auto index = static_cast<std::size_t>(behaviour - plan_.behaviours.begin());
    summary.code_lines = prepared_.behaviours()[index].code_lines;
    if (!asks_for_judgement(criteria())) continue;
    comparison.assessments.push_back(assessments_.summary(index, summary.agents));
  }
  return report_of(comparison);
}

Result<ComparisonReport> Comparing::run() {
  for (Diagnostics found : {add_first_tests(), open_store()}) {
    if (found.has_errors()) return found;
  }
  ExperimentOutcome outcome = run_experiment(
      plan_, [this](const TestKey& test) { return run_test(test); },
      [this](const Progress& now) {
        const bool is_broken = store_ != nullptr && store_->failure();
        const bool goes_on = !options_.progress || options_.progress(now.done, now.total);
        if (!goes_on) is_given_up_ = true;
        if (goes_on && !is_broken) return Proceed::yes;
        first_tests_.give_up();
        return Proceed::no;
      });
  const bool is_ended = !outcome.complete();
  if (store_ != nullptr) {
    if (const auto failure = store_->finish()) return trouble_about(options_.store, *failure);
    store_.reset();
  }
  if (outcome.failed_test && !is_given_up_) return outcome.failure;
  auto report = summed_up(std::move(outcome));
  if (report && is_ended) report.value().is_complete = false;
  return report;
}

}  // namespace

Result<ComparisonReport> compare(const RunnableScenario& scenario,
                                 const ComparisonOptions& options) {
  Comparing comparing(scenario, options);
  if (Diagnostics found = comparing.obstacles(); found.has_errors()) return found;
  return comparing.run();
}

}  // namespace jaywalk
