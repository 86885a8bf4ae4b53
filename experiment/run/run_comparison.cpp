// SPDX-License-Identifier: Apache-2.0
#include "experiment/run/run_comparison.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "experiment/results/reader.h"
#include "experiment/run/comparison_tables.h"
#include "experiment/test_run/simulator_version.h"
#include "experiment/test_run/tested_vehicles.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

/// The tests of a comparison while they run: selects them, runs and judges each, on any thread.
class RunningTests {
 public:
  /// `store` may be null. REQUIRES: all outlive it.
  RunningTests(const ComparisonRequest& request, const ExperimentDescription& description,
               const ComparisonHooks& hooks, ComparisonTables& tables, ResultsWriter* store)
      : request_(request),
        description_(description),
        hooks_(hooks),
        tables_(tables),
        store_(store),
        shard_(request.store ? request.store->shard : Shard{}),
        ground_(request.prepared->scenario().world->ground()),
        runners_(*request.prepared) {
    const std::uint64_t each = (request.plan.tests + shard_.count - shard_.index) / shard_.count;
    wanted_ = request.plan.cells() * each - (store != nullptr ? store->had() : 0);
  }

  /// Runs the missing tests; progress counts these alone.
  [[nodiscard]] ExperimentOutcome run() {
    const auto progress = [&](const Progress&) {
      const bool broken = store_ != nullptr && store_->failure();
      if (hooks_.progress) hooks_.progress({.done = done_, .total = wanted_});
      if (!broken && !is_interrupted()) return Proceed::yes;
      give_up();
      return Proceed::no;
    };
    ExperimentPlan plan = request_.plan;
    plan.summed_up = store_ == nullptr;
    ExperimentOutcome outcome = run_experiment(
        plan, [&](const TestKey& test) { return run_or_skip(test); }, progress);
    outcome.progress = {.done = done_, .total = wanted_};
    return outcome;
  }

  [[nodiscard]] bool is_interrupted() const { return hooks_.interrupted && hooks_.interrupted(); }

 private:
  Result<TestResult> run_or_skip(const TestKey& test) {
    // All of the shard, or those that the store does not have yet.
    const bool in_shard = shard_.has(test.number);
    const bool selected = in_shard && (store_ == nullptr || !store_->had(test));
    if (!selected && hooks_.skipped) hooks_.skipped(test);
    if (!selected && (in_shard || !tables_.first_tests.is_wanted(test))) return TestResult{};
    auto result = selected ? run_selected(test) : probe(test);
    if (!result) give_up();
    if (result && selected) done_.fetch_add(1, std::memory_order_relaxed);
    return result;
  }

  void give_up() {
    tables_.first_tests.give_up();
    if (tables_.feedback) tables_.feedback->give_up();
  }

  [[nodiscard]] Diagnostics not_run(const TestKey& test, std::string why) const {
    Diagnostics diagnostics;
    diagnostics.error(fmt::format("{}, {}, test {}", request_.plan.behaviours[test.behaviour],
                                  counted(test.agents, "agent"), test.number),
                      std::move(why));
    return diagnostics;
  }

  [[nodiscard]] TestSetup setup_of(const TestKey& test) const {
    return {.behaviour = test.behaviour,
            .agents = test.agents,
            .seed = request_.seed,
            .test = test.number,
            .vehicle = test.vehicle};
  }

  /// A test that another part of the experiment has, but that decides whether others are started.
  Result<TestResult> probe(const TestKey& test) {
    const TestRun run = runners_.run(
        setup_of(test), {.names = &description_.names, .interrupted = hooks_.interrupted});
    if (run.interrupted) return not_run(test, run.message);
    tables_.first_tests.finished(test, run.completed ? std::string() : run.message);
    return TestResult{};
  }

  Result<TestResult> run_selected(const TestKey& test) {
    TestSetup setup = setup_of(test);
    if (tables_.feedback) {
      auto covered = tables_.feedback->wait_for(test);
      if (!covered) return not_run(test, "given up");
      setup.feedback = std::move(*covered);
    }
    if (tables_.carry_over) setup.head_start = tables_.carry_over->head_start(test);
    const auto start = std::chrono::steady_clock::now();
    const auto why_not = tables_.first_tests.why_not_started(test);
    if (!why_not) return not_run(test, "given up");
    Recording recording;
    const bool recorded =
        store_ != nullptr || hooks_.measured || asks(request_.criteria) || tables_.situations;
    // Tests with a defect have no measure of CPU time, and reading the clock is expensive.
    const bool is_timed = test.vehicle == 0 || compares_models(request_.plan.vehicles);
    TestOptions options{.record = recorded ? &recording : nullptr,
                        .names = &description_.names,
                        .measure_cpu = is_timed,
                        .interrupted = hooks_.interrupted};
    const auto run_it = [&] {
      return why_not->empty() ? runners_.run(setup, options) : errored_test(*why_not, options);
    };
    const TestRun run = hooks_.around ? hooks_.around(test, setup, options, run_it) : run_it();
    if (run.interrupted) return not_run(test, run.message);
    const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
    tables_.first_tests.finished(test, run.completed ? std::string() : run.message);
    if (tables_.carry_over) tables_.carry_over->finished(test, run.left_over);
    return keep(test, run, wall.count(), std::move(recording));
  }

  /// Judges the test and hands it to the tables and the store.
  TestResult keep(const TestKey& test, const TestRun& run, double wall_us, Recording recording) {
    const TestResult result = result_of(run, wall_us);
    tables_.notes.add(request_.plan.place_of(test), run.notes);
    // All measures are about the first vehicle.
    if (test.vehicle == 0) note_measured(test, result, run, recording);
    TestAssessment found;
    if (asks(request_.criteria) && result.errored) {
      tables_.kills.add_errored(test);
    } else if (asks(request_.criteria)) {
      found = assess(request_.criteria, recording, ground_);
      // Assessments that go into a store are summed up from there.
      if (test.vehicle == 0 && store_ == nullptr) tables_.assessments.add(test, found);
      tables_.kills.add(test, blames_the_av(found));
    }
    const TestOutcome outcome = outcome_of(run);
    tables_.avs.add(test, result, outcome.impact_mps, blame_of(found));
    if (tables_.per_test) tables_.per_test->add(test, outcome, found);
    if (store_ != nullptr) {
      TestRecord record = make_test_record(test, result, run, std::move(recording));
      record.assessments = to_rows(request_.criteria, found);
      store_->add(std::move(record));
    }
    return result;
  }

  void note_measured(const TestKey& test, const TestResult& result, const TestRun& run,
                     const Recording& recording) {
    tables_.troubles.add(test, run.troubles);
    if (hooks_.measured) hooks_.measured(test, result, recording);
    if (tables_.situations && !result.errored) {
      tables_.situations->add(test, covered_bins(recording, ground_));
    }
    if (tables_.feedback) tables_.feedback->finished(test);
  }

  const ComparisonRequest& request_;
  const ExperimentDescription& description_;
  const ComparisonHooks& hooks_;
  ComparisonTables& tables_;
  ResultsWriter* store_;
  Shard shard_;
  Ground ground_;
  TestRunners runners_;
  std::uint64_t wanted_ = 0;
  std::atomic<std::uint64_t> done_ = 0;
};

/// Summed up from the store, which may have had tests before.
Result<Comparison> stored_comparison(const std::string& path) {
  const auto store = ResultsReader::open(path);
  if (!store) return store.diagnostics();
  return store.value()->comparison();
}

std::size_t behaviour_of(const ExperimentPlan& plan, const Summary& summary) {
  const auto place = std::ranges::find(plan.behaviours, summary.behaviour);
  return static_cast<std::size_t>(place - plan.behaviours.begin());
}

Comparison summed_up(const ComparisonRequest& request, const std::string& scenario,
                     const ComparisonTables& tables, ExperimentOutcome outcome) {
  Comparison comparison{.scenario = scenario,
                        .seed = request.seed,
                        .tests = request.plan.tests,
                        .summaries = std::move(outcome.summaries),
                        .published = published_rows(*request.prepared),
                        .kills = tables.kills.matrix(),
                        .avs = tables.avs.ranking(asks(request.criteria)),
                        .complete = outcome.complete()};
  for (Summary& summary : comparison.summaries) {
    const std::size_t behaviour = behaviour_of(request.plan, summary);
    summary.code_lines = request.prepared->behaviours()[behaviour].code_lines;
    comparison.troubles.push_back(tables.troubles.troubles(behaviour, summary.agents));
  }
  add_assessments(request.criteria, tables.assessments, request.plan.behaviours, comparison);
  return comparison;
}

}  // namespace

Result<ComparisonResults> run_comparison(const ComparisonRequest& request,
                                         const ComparisonHooks& hooks) {
  if (Diagnostics wrong = problems(request); wrong.has_errors()) return wrong;
  ExperimentDescription description = describe(request);
  if (!request.simulator) {
    auto simulator = simulator_version(request.prepared->scenario());
    if (!simulator) return std::move(simulator.diagnostics());
    description.simulator = std::move(simulator).value();
  }
  ComparisonTables tables(request);
  Diagnostics trouble = add_earlier_tests(request, description, tables);
  if (trouble.has_errors()) return trouble;
  std::unique_ptr<ResultsWriter> store;
  if (request.store) {
    auto opened = open_store(*request.store, description);
    if (!opened) return std::move(opened.diagnostics());
    store = std::move(opened).value();
  }

  if (hooks.opened && hooks.opened() == Proceed::no) return Diagnostics{};
  RunningTests tests(request, description, hooks, tables, store.get());
  ExperimentOutcome outcome = tests.run();
  const auto unwritten = store ? store->finish() : std::nullopt;
  if (hooks.closed) hooks.closed(unwritten);
  if (unwritten) trouble.append(unwritten_store(request.store->path, *unwritten));
  if (outcome.failed_test && !tests.is_interrupted()) trouble.append(std::move(outcome.failure));
  if (trouble.has_errors()) return trouble;

  const Progress progress = outcome.progress;
  auto comparison = request.store
                        ? stored_comparison(request.store->path)
                        : summed_up(request, description.scenario, tables, std::move(outcome));
  if (!comparison) return std::move(comparison.diagnostics());
  ComparisonResults results{.comparison = std::move(comparison).value(),
                            .description = std::move(description),
                            .progress = progress,
                            .notes = tables.notes.texts(),
                            .per_test = std::move(tables.per_test)};
  for (const Summary& summary : results.comparison.summaries) {
    if (!request.situations) break;
    results.situations.push_back(tables.situations->coverage(behaviour_of(request.plan, summary),
                                                             summary.agents, request.plan.tests));
  }
  return results;
}

}  // namespace jaywalk
