#include "experiment/stored_coverage.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "experiment/plan_coverage.h"
#include "interpreter/support/start_threads.h"

namespace jaywalk {
namespace {

constexpr std::uint64_t kTestsBetweenLooks = 64;

Diagnostics interrupted() {
  Diagnostics diagnostics;
  diagnostics.error("coverage", "interrupted");
  return diagnostics;
}

/// The tests of one behaviour with one number of agents, in the order of their numbers.
struct Group {
  std::size_t behaviour = 0;
  std::uint32_t agents = 0;
  std::vector<StoredTest> tests;
};

Result<std::vector<Group>> wanted_tests(const ResultsReader& store, const CoverageWanted& wanted) {
  std::vector<Group> groups;
  const ExperimentDescription& plan = store.description();
  for (std::size_t behaviour = 0; behaviour < plan.behaviours.size(); ++behaviour) {
    if (wanted.behaviour.value_or(plan.behaviours[behaviour].name) !=
        plan.behaviours[behaviour].name) {
      continue;
    }
    for (const std::uint32_t agents : plan.agents) {
      if (wanted.agents.value_or(agents) != agents) continue;
      auto tests = store.tests({.behaviour = behaviour, .agents = agents, .limit = wanted.tests});
      if (!tests) return std::move(tests.diagnostics());
      groups.push_back({behaviour, agents, std::move(tests).value()});
    }
  }
  return groups;
}

std::uint64_t count(const std::vector<Group>& groups) {
  std::uint64_t tests = 0;
  for (const Group& group : groups) tests += group.tests.size();
  return tests;
}

}  // namespace

Result<std::vector<SituationRow>> stored_situations(const ResultsReader& store,
                                                    const CoverageWanted& wanted,
                                                    const CoverageProgress& progress) {
  auto groups = wanted_tests(store, wanted);
  if (!groups) return std::move(groups.diagnostics());
  const auto prepared = store.prepared();
  if (!prepared) return prepared.diagnostics();
  const Ground where = ground(prepared.value()->scenario().world);
  Progress now{.done = 0, .total = count(groups.value())};
  std::vector<SituationRow> rows;
  for (const Group& group : groups.value()) {
    SituationRow row{store.description().behaviours[group.behaviour].name, group.agents, {}};
    for (const StoredTest& test : group.tests) {
      if (now.done++ % kTestsBetweenLooks == 0 && progress(now) == Proceed::no) {
        return interrupted();
      }
      if (test.result.errored) continue;
      if (!test.result.succeeded) {
        row.coverage.add(SituationBins(situation_items().size()));
        continue;
      }
      const auto recording = store.recording(test.id);
      if (!recording) return recording.diagnostics();
      row.coverage.add(covered_bins(recording.value(), where));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<SourceCoverage> stored_plan_coverage(const ResultsReader& store,
                                            const CoverageWanted& wanted, unsigned threads,
                                            const CoverageProgress& progress) {
  auto groups = wanted_tests(store, wanted);
  if (!groups) return std::move(groups.diagnostics());
  const auto prepared = store.prepared();
  if (!prepared) return prepared.diagnostics();
  std::vector<TrialInput> inputs;
  BehavioursRun behaviours;
  for (const Group& group : groups.value()) {
    for (const StoredTest& test : group.tests) {
      auto input = store.input(test.id);
      if (!input) return std::move(input.diagnostics());
      if (!obstacle(*prepared.value(), input.value()).empty()) continue;
      std::uint32_t& most = behaviours[input.value().behaviour];
      most = std::max(most, input.value().agents);
      inputs.push_back(std::move(input).value());
    }
  }
  PlanCoverage coverage(*prepared.value(), behaviours);
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<bool> cancelled{false};
  const auto work = [&] {
    const PlanCoverage::Borrowed observer(coverage);
    for (std::size_t i = next++; i < inputs.size() && !cancelled; i = next++) {
      (void)run_trial(*prepared.value(), inputs[i], {.observer = observer.get()});
      ++done;
    }
  };
  {
    std::vector<std::jthread> workers;
    (void)start_threads(workers, threads, work);
    while (done < inputs.size() && !cancelled) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (progress({.done = done, .total = inputs.size()}) == Proceed::no) cancelled = true;
    }
  }
  if (cancelled) return interrupted();
  return coverage.total();
}

}  // namespace jaywalk
