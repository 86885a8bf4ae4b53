#include "tools/jaywalk/comparison/compare_tests.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "experiment/results/reader.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/run/test_trace.h"

namespace jaywalk::command::compare {
namespace {

Diagnostics not_run(const TestKey& test, std::string_view behaviour, std::string why) {
  Diagnostics diagnostics;
  diagnostics.error(
      fmt::format("{}, {}, test {}", behaviour, counted(test.agents, "agent"), test.number),
      std::move(why));
  return diagnostics;
}

/// Its place in the plan.
std::uint64_t number_of(const ExperimentPlan& plan, const TestKey& test) {
  return plan.cell_of(test) * plan.tests + test.number;
}

/// What is measured of a test; of one that ended errored the times alone.
TestResult measured(const TestRun& run, double wall_us) {
  TestResult result{.errored = !run.completed,
                    .ticks = static_cast<std::uint32_t>(run.outcome.ticks),
                    .cpu_us = run.cpu_s * 1e6,
                    .wall_us = wall_us};
  if (result.errored) return result;
  result.succeeded = run.outcome.success;
  result.score = run.outcome.score();
  return result;
}

/// Reports a test with the first vehicle, which the measures are of, to the listeners.
void note_measured(const Request& request, const TestKey& test, const TestResult& result,
                   const TestRun& run, const Recording& recording, const Listeners& listeners) {
  if (test.vehicle > 0) return;
  listeners.collected.troubles.add(test, run.troubles);
  if (listeners.facts != nullptr) listeners.facts->add(test, result, recording);
  if (!request.situations) return;
  if (!result.errored) {
    listeners.collected.situations.add(test, covered_bins(recording, request.ground));
  }
  if (listeners.collected.feedback) listeners.collected.feedback->finished(test);
}

/// Runs a test, finds out about it and hands it to the store, if there is one.
Result<TestResult> run_planned_test(const Request& request, const TestKey& test,
                                    TestRunners& runners, const Listeners& listeners) {
  ResultsWriter* const store = listeners.store;
  const bool recorded = store != nullptr || listeners.facts != nullptr || asks(request.criteria) ||
                        request.situations;
  TestSetup setup{.behaviour = test.behaviour,
                  .agents = test.agents,
                  .seed = request.seed,
                  .test = test.number,
                  .vehicle = test.vehicle};
  std::optional<CoverageFeedback>& feedback = listeners.collected.feedback;
  if (feedback) {
    auto covered = feedback->wait_for(test);
    if (!covered) return not_run(test, request.plan.behaviours[test.behaviour], "given up");
    setup.feedback = std::move(*covered);
  }
  std::optional<CarryOver>& carry_over = listeners.collected.carry_over;
  if (carry_over) setup.head_start = carry_over->head_start(test);
  const auto start = std::chrono::steady_clock::now();
  Recording recording;
  // With a defect nobody asks what reasoning costs, and reading the clock costs a tenth of a test.
  const bool is_timed = test.vehicle == 0 || compares_models(request.plan.vehicles);
  TestOptions options{.record = recorded ? &recording : nullptr, .measure_cpu = is_timed};
  std::optional<PlanCoverage::Borrowed> observer;
  Observers observers;
  if (request.coverage != nullptr) observers.add(*observer.emplace(*request.coverage).get());
  std::optional<TestTrace> trace;
  if (listeners.trace != nullptr) {
    observers.add(trace.emplace());
    options.observe = [&](const World& world, const Mas& mas) { trace->tick(world, mas); };
    trace->begin(request.plan.behaviours[test.behaviour], setup);
  }
  options.observer = observers.get();
  options.interrupted = listeners.interrupted;
  TestRun run = runners.run(setup, options);
  if (run.interrupted) {
    return not_run(test, request.plan.behaviours[test.behaviour], run.message);
  }
  if (trace) {
    trace->end(run);
    listeners.trace->add(number_of(request.plan, test), trace->lines());
  }
  const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
  if (carry_over) carry_over->finished(test, run.left_over);
  const TestResult result = measured(run, wall.count());
  listeners.collected.notes.add(number_of(request.plan, test), run.note);
  note_measured(request, test, result, run, recording, listeners);
  std::vector<AssessmentRow> assessments;
  TestAssessment found;
  if (asks(request.criteria) && result.errored) {
    listeners.collected.kills.add_errored(test);
  } else if (asks(request.criteria)) {
    found = assess(request.criteria, recording, request.ground);
    // What a store has is summed up from there.
    if (test.vehicle == 0 && store == nullptr) listeners.collected.assessments.add(test, found);
    listeners.collected.kills.add(test, blames_the_av(found));
    if (store != nullptr) assessments = to_rows(request.criteria, found);
  }
  listeners.collected.avs.add(test, result, outcome_of(run).impact_mps, blame_of(found));
  if (PerTestTable* const table = listeners.collected.per_test.get()) {
    table->add(test, outcome_of(run), found);
  }
  if (store != nullptr) {
    TestRecord record = make_test_record(test, result, run, std::move(recording));
    record.assessments = std::move(assessments);
    store->add(std::move(record));
  }
  return result;
}

void add_situations(const Request& request, const ResultsReader& store, const StoredTest& stored,
                    Collected& collected, Diagnostics& trouble) {
  if (stored.result.succeeded) {
    const auto recording = store.recording(stored.id);
    if (!recording.ok()) {
      trouble.append(recording.diagnostics());
      return;
    }
    collected.situations.add(stored.test, covered_bins(recording.value(), request.ground));
  }
  if (collected.feedback) collected.feedback->finished(stored.test);
}

void add_left_over(const ResultsReader& store, const StoredTest& stored, CarryOver& carry_over,
                   Diagnostics& trouble) {
  if (stored.result.errored) return carry_over.finished(stored.test, 0);
  const auto again = store.rerun(stored.id);
  if (again.ok()) {
    carry_over.finished(stored.test, again.value().left_over);
  } else {
    trouble.append(again.diagnostics());
  }
}

/// Whether a test is the next one of the same chain.
bool follows(const StoredTest& test, const StoredTest& next) {
  return next.test.behaviour == test.test.behaviour && next.test.agents == test.test.agents &&
         next.test.number == test.test.number + 1;
}

/// Commands are the user's own where the store is of the scenario that the user gives.
Commands commands_for(const std::string& path, const ExperimentDescription& description) {
  const auto store = ResultsReader::open(path);
  if (!store.ok()) return Commands::refused;
  ExperimentDescription stored = store.value()->description();
  stored.tests = description.tests;  // there may be more now
  return difference(stored, description).empty() ? Commands::allowed : Commands::refused;
}

}  // namespace

void ControllerNotes::add(std::uint64_t place, const std::string& note) {
  if (note.empty()) return;
  const std::lock_guard lock(mutex_);
  if (tests_++ == 0 || place < first_) {
    first_ = place;
    note_ = note;
  }
}

std::string ControllerNotes::text() const {
  if (tests_ == 0) return {};
  return fmt::format("{} (in {})", note_, counted(tests_, "test"));
}

Selection::Selection(const Request& request, const ResultsWriter* store)
    : store_(store), shard_(request.store ? request.store->shard : Shard{}) {
  const ExperimentPlan& plan = request.plan;
  const std::uint64_t each = (plan.tests + shard_.count - shard_.index) / shard_.count;
  wanted_ = plan.cells() * each - (store != nullptr ? store->had() : 0);
}

ExperimentOutcome run_selection(const Request& request, const Selection& selection,
                                const Listeners& listeners, const ProgressFunction& progress) {
  std::optional<CoverageFeedback>& feedback = listeners.collected.feedback;
  std::atomic<std::uint64_t> done = 0;
  TestRunners runners(*request.prepared);
  const auto test = [&](const TestKey& key) -> Result<TestResult> {
    if (!selection.has(key)) {
      if (listeners.trace != nullptr) listeners.trace->add(number_of(request.plan, key), {});
      return TestResult{};
    }
    auto result = run_planned_test(request, key, runners, listeners);
    if (!result && feedback) feedback->give_up();
    if (result) done.fetch_add(1, std::memory_order_relaxed);
    return result;
  };
  const auto own_progress = [&](const Progress&) {
    const bool broken = listeners.store != nullptr && listeners.store->failure();
    Proceed proceed = progress({.done = done, .total = selection.size()});
    if (broken) proceed = Proceed::no;
    if (proceed == Proceed::no && feedback) feedback->give_up();
    return proceed;
  };
  ExperimentPlan plan = request.plan;
  plan.summed_up = listeners.store == nullptr;
  ExperimentOutcome outcome = run_experiment(plan, test, own_progress);
  outcome.progress = {.done = done, .total = selection.size()};
  return outcome;
}

bool add_earlier_tests(const Request& request, const ExperimentDescription& description,
                       Collected& collected, Console& console) {
  const bool wanted = request.situations || collected.carry_over;
  if (!wanted || !request.store || !request.store->resume) return true;
  std::error_code ignored;
  if (!std::filesystem::exists(request.store->path, ignored)) return true;
  const std::string& path = request.store->path;
  const auto store = ResultsReader::open(path, commands_for(path, description));
  if (!store.ok()) {
    console.report(store.diagnostics());
    return false;
  }
  Diagnostics trouble;
  std::optional<StoredTest> last;
  const auto end_chain = [&] {
    // Only the last one of a chain is needed.
    if (collected.carry_over && last) {
      add_left_over(*store.value(), *last, *collected.carry_over, trouble);
    }
  };
  const auto failure = store.value()->for_each_test({}, [&](const StoredTest& stored) {
    if (request.situations) add_situations(request, *store.value(), stored, collected, trouble);
    if (last && !follows(*last, stored)) end_chain();
    last = stored;
    return trouble.has_errors() ? Proceed::no : Proceed::yes;
  });
  if (!failure && !trouble.has_errors()) end_chain();
  if (failure) trouble.append(*failure);
  if (trouble.has_errors()) console.report(trouble);
  return !trouble.has_errors();
}

}  // namespace jaywalk::command::compare
