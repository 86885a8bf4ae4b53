// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/stored_coverage.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>

#include "experiment/test_run/plan_coverage.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/start_threads.h"

namespace jaywalk {
namespace {

Diagnostics interrupted() {
  Diagnostics diagnostics;
  diagnostics.error("coverage", "interrupted");
  return diagnostics;
}

/// The tests of one behaviour with one number of agents, in the order of their numbers.
std::vector<TestFilter> wanted_cells(const ResultsReader& store, const CoverageWanted& wanted) {
  std::vector<TestFilter> cells;
  const ExperimentDescription& plan = store.description();
  for (std::size_t behaviour = 0; behaviour < plan.behaviours.size(); ++behaviour) {
    if (wanted.behaviour.value_or(plan.behaviours[behaviour].name) !=
        plan.behaviours[behaviour].name) {
      continue;
    }
    for (const std::uint32_t agents : plan.agents) {
      if (wanted.agents.value_or(agents) != agents) continue;
      cells.push_back({.behaviour = behaviour, .agents = agents, .limit = wanted.tests});
    }
  }
  return cells;
}

Result<std::uint64_t> count(const ResultsReader& store, const std::vector<TestFilter>& cells) {
  std::uint64_t tests = 0;
  for (const TestFilter& cell : cells) {
    const auto more = store.count(cell);
    if (!more) return more.diagnostics();
    tests += more.value();
  }
  return tests;
}

/// Adds a test's covered bins to the row, or the reason why they are unknown to `trouble`.
void add_test(const ResultsReader& store, const StoredTest& test, const Ground& where,
              SituationRow& row, Diagnostics& trouble) {
  if (test.result.errored) return;
  if (!test.result.succeeded) {
    row.coverage.add(SituationBins(situation_items().size()));
    return;
  }
  const auto recording = store.recording(test.id);
  if (!recording) {
    trouble.append(recording.diagnostics());
    return;
  }
  row.coverage.add(covered_bins(recording.value(), where));
}

/// Tests that can be run again: no more than their ids, for there may be millions.
struct Reruns {
  std::vector<std::int64_t> ids;
  BehavioursRun behaviours;
};

Result<Reruns> find_reruns(const ResultsReader& store, const std::vector<TestFilter>& cells,
                           const PreparedScenario& prepared) {
  Reruns reruns;
  Diagnostics trouble;
  for (const TestFilter& cell : cells) {
    auto failure = store.for_each_test(cell, [&](const StoredTest& test) {
      const auto setup = store.setup(test.id);
      if (!setup) {
        trouble.append(setup.diagnostics());
        return Proceed::no;
      }
      if (!problem(prepared, setup.value()).empty()) return Proceed::yes;
      std::uint32_t& most = reruns.behaviours[setup.value().behaviour];
      most = std::max(most, setup.value().agents);
      reruns.ids.push_back(test.id);
      return Proceed::yes;
    });
    if (failure) return std::move(*failure);
    if (trouble.has_errors()) return trouble;
  }
  return reruns;
}

}  // namespace

Result<std::vector<SituationRow>> stored_situations(const ResultsReader& store,
                                                    const CoverageWanted& wanted,
                                                    const CoverageProgress& progress) {
  const std::vector<TestFilter> cells = wanted_cells(store, wanted);
  const auto total = count(store, cells);
  if (!total) return total.diagnostics();
  const auto prepared = store.prepared();
  if (!prepared) return prepared.diagnostics();
  const Ground where = prepared.value()->scenario().world->ground();
  const ReachableBins& reachable = prepared.value()->scenario().experiment.reachable;
  Progress now{.done = 0, .total = total.value()};
  std::vector<SituationRow> rows;
  for (const TestFilter& cell : cells) {
    SituationRow row{store.description().behaviours[*cell.behaviour].name,
                     *cell.agents,
                     {},
                     reachable_with(reachable, *cell.agents)};
    Diagnostics trouble;
    auto failure = store.for_each_test(cell, [&](const StoredTest& test) {
      ++now.done;
      if (progress(now) == Proceed::no) {
        trouble = interrupted();
      } else {
        add_test(store, test, where, row, trouble);
      }
      return trouble.has_errors() ? Proceed::no : Proceed::yes;
    });
    if (failure) return std::move(*failure);
    if (trouble.has_errors()) return trouble;
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<SourceCoverage> stored_plan_coverage(const ResultsReader& store,
                                            const CoverageWanted& wanted, unsigned threads,
                                            const CoverageProgress& progress) {
  const auto prepared = store.prepared();
  if (!prepared) return prepared.diagnostics();
  const auto reruns = find_reruns(store, wanted_cells(store, wanted), *prepared.value());
  if (!reruns) return reruns.diagnostics();
  const std::vector<std::int64_t>& ids = reruns.value().ids;
  PlanCoverage coverage(*prepared.value(), reruns.value().behaviours);
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<bool> cancelled{false};
  std::mutex mutex;  // guards the store and what follows
  Diagnostics trouble;
  const auto input_of = [&](std::int64_t id) -> std::optional<TestSetup> {
    const std::lock_guard lock(mutex);
    auto setup = store.setup(id);
    if (setup) return std::move(setup).value();
    trouble.append(setup.diagnostics());
    cancelled = true;
    return std::nullopt;
  };
  const auto work = [&] {
    const PlanCoverage::Borrowed observer(coverage);
    for (std::size_t i = next++; i < ids.size() && !cancelled; i = next++) {
      if (const auto setup = input_of(ids[i])) {
        (void)run_test(*prepared.value(), *setup, {.observer = observer.get(), .interrupted = [&] {
                                                     return cancelled.load();
                                                   }});
      }
      ++done;
    }
  };
  {
    std::vector<std::jthread> workers;
    (void)start_threads(workers, threads, work);
    while (done < ids.size() && !cancelled) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (progress({.done = done, .total = ids.size()}) == Proceed::no) cancelled = true;
    }
  }
  if (trouble.has_errors()) return trouble;
  if (cancelled) return interrupted();
  return coverage.total();
}

}  // namespace jaywalk
