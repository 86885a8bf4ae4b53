#include "tools/jaywalk/comparison/compare_tests.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include <fmt/format.h>

#include "experiment/results/reader.h"
#include "experiment/test_run/test_run.h"
#include "experiment/test_run/tested_vehicles.h"
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

/// The measured values of a test; only the times if it ended errored.
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

/// Reports a test to the listeners if it ran with the first vehicle, which all measures are about.
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

/// Runs a test, judges it and hands it to the store, if there is one.
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
  // Tests with a defect have no measure of CPU time, and reading the clock is expensive.
  const bool is_timed = test.vehicle == 0 || compares_models(request.plan.vehicles);
  TestOptions options{.record = recorded ? &recording : nullptr,
                      .names = &request.description.names,
                      .measure_cpu = is_timed};
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
  FirstTests& first_tests = listeners.collected.first_tests;
  const auto why_not = first_tests.why_not_started(test);
  if (!why_not) return not_run(test, request.plan.behaviours[test.behaviour], "given up");
  TestRun run = why_not->empty() ? runners.run(setup, options) : errored_test(*why_not, options);
  if (run.interrupted) {
    return not_run(test, request.plan.behaviours[test.behaviour], run.message);
  }
  first_tests.finished(test, run.completed ? std::string() : run.message);
  if (trace) {
    trace->end(run);
    listeners.trace->add(number_of(request.plan, test), trace->lines());
  }
  const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
  if (carry_over) carry_over->finished(test, run.left_over);
  const TestResult result = measured(run, wall.count());
  listeners.collected.notes.add(number_of(request.plan, test), run.notes);
  note_measured(request, test, result, run, recording, listeners);
  std::vector<AssessmentRow> assessments;
  TestAssessment found;
  if (asks(request.criteria) && result.errored) {
    listeners.collected.kills.add_errored(test);
  } else if (asks(request.criteria)) {
    found = assess(request.criteria, recording, request.ground);
    // Assessments that go into a store are summed up from there.
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

/// A test that another part of the experiment has, but that decides whether others are started.
Result<TestResult> probe(const Request& request, const TestKey& test, TestRunners& runners,
                         const Listeners& listeners) {
  const TestRun run =
      runners.run({.behaviour = test.behaviour,
                   .agents = test.agents,
                   .seed = request.seed,
                   .test = test.number,
                   .vehicle = test.vehicle},
                  {.names = &request.description.names, .interrupted = listeners.interrupted});
  if (run.interrupted) {
    return not_run(test, request.plan.behaviours[test.behaviour], run.message);
  }
  listeners.collected.first_tests.finished(test, run.completed ? std::string() : run.message);
  return TestResult{};
}

/// Stored first tests decide about the others of their row as they did when they were run. Errored
/// ones that run again decide anew.
void add_first_tests(const Request& request, const ResultsReader& store, FirstTests& first_tests,
                     Diagnostics& trouble) {
  const ExperimentPlan plan = plan_of(store.description());
  for (std::uint64_t place = 0; place < plan.cells() * FirstTests::kCount; ++place) {
    const std::uint64_t row = place / FirstTests::kCount % plan.rows();
    const TestKey test{.behaviour = row / plan.agents.size(),
                       .agents = plan.agents[row % plan.agents.size()],
                       .number = place % FirstTests::kCount,
                       .vehicle = place / FirstTests::kCount / plan.rows()};
    if (test.number >= plan.tests) continue;
    const std::int64_t id = test_id(store.description(), test);
    const auto stored = store.test(id);
    const bool errored = stored.ok() && stored.value().result.errored;
    if (!stored.ok() || (errored && request.store->retry_errors)) continue;  // it is run now
    const auto error = errored ? store.error(id) : std::string();
    if (!error.ok()) return trouble.append(error.diagnostics());
    first_tests.finished(test, error.value());
  }
}

/// The store is of the experiment that the user gives, whose commands may be started.
bool is_of(const std::string& path, const ExperimentDescription& description) {
  const auto store = ResultsReader::open(path);
  if (!store.ok()) return false;
  ExperimentDescription stored = store.value()->description();
  stored.tests = description.tests;  // there may be more now
  return difference(stored, description).empty();
}

}  // namespace

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
  FirstTests& first_tests = listeners.collected.first_tests;
  TestRunners runners(*request.prepared);
  const auto give_up = [&] {
    first_tests.give_up();
    if (feedback) feedback->give_up();
  };
  const auto test = [&](const TestKey& key) -> Result<TestResult> {
    const bool selected = selection.has(key);
    if (!selected && listeners.trace != nullptr) {
      listeners.trace->add(number_of(request.plan, key), {});
    }
    if (!selected && (selection.in_shard(key) || !first_tests.is_wanted(key))) return TestResult{};
    auto result = selected ? run_planned_test(request, key, runners, listeners)
                           : probe(request, key, runners, listeners);
    if (!result) give_up();
    if (result && selected) done.fetch_add(1, std::memory_order_relaxed);
    return result;
  };
  const auto own_progress = [&](const Progress&) {
    const bool broken = listeners.store != nullptr && listeners.store->failure();
    Proceed proceed = progress({.done = done, .total = selection.size()});
    if (broken) proceed = Proceed::no;
    if (proceed == Proceed::no) give_up();
    return proceed;
  };
  ExperimentPlan plan = request.plan;
  plan.summed_up = listeners.store == nullptr;
  ExperimentOutcome outcome = run_experiment(plan, test, own_progress);
  outcome.progress = {.done = done, .total = selection.size()};
  return outcome;
}

bool add_earlier_tests(const Request& request, Collected& collected, Console& console) {
  if (!request.store || !request.store->resume) return true;
  const std::string& path = request.store->path;
  if (!is_of(path, request.description)) return true;  // it is made, or refused, later
  const auto store = ResultsReader::open(path, Commands::allowed);
  if (!store.ok()) {
    console.report(store.diagnostics());
    return false;
  }
  Diagnostics trouble;
  add_first_tests(request, *store.value(), collected.first_tests, trouble);
  std::optional<StoredTest> last;
  const auto end_chain = [&] {
    // Only the last one of a chain is needed.
    if (collected.carry_over && last) {
      add_left_over(*store.value(), *last, *collected.carry_over, trouble);
    }
  };
  if (request.situations || collected.carry_over) {
    const auto failure = store.value()->for_each_test({}, [&](const StoredTest& stored) {
      if (request.situations) add_situations(request, *store.value(), stored, collected, trouble);
      if (last && !follows(*last, stored)) end_chain();
      last = stored;
      return trouble.has_errors() ? Proceed::no : Proceed::yes;
    });
    if (!failure && !trouble.has_errors()) end_chain();
    if (failure) trouble.append(*failure);
  }
  if (trouble.has_errors()) console.report(trouble);
  return !trouble.has_errors();
}

}  // namespace jaywalk::command::compare
