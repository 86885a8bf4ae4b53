// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/experiment.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "experiment/test_run/tested_vehicles.h"
#include "interpreter/support/start_threads.h"

namespace jaywalk {
namespace {

/// Tests are handed out in chunks: large enough that threads rarely meet, small enough that they
/// end together and that Ctrl-C takes effect at once.
constexpr std::uint64_t kChunk = 16;

/// How many vehicles a test runs with one after another, which reuses cached data. Models may each
/// have a simulator, which takes long to start, so all tests of one model run before those of the
/// next; so do chains.
std::size_t vehicles_together(const ExperimentPlan& plan) {
  const bool apart = plan.order == TestOrder::chained || compares_models(plan.vehicles);
  return apart ? 1 : plan.vehicles.size();
}

/// How many numbers of tests a chunk has.
std::uint64_t chunk_of(const ExperimentPlan& plan) {
  const std::uint64_t least = 1;
  if (plan.order == TestOrder::chained) return std::max(plan.tests, least);
  return std::max(kChunk / vehicles_together(plan), least);
}

constexpr auto kProgressInterval = std::chrono::milliseconds(100);

/// The tests of one behaviour with one number of agents. Memory is held only while they run.
struct Cell {
  std::once_flag started;
  std::vector<TestResult> results;
  std::atomic<std::uint64_t> remaining{0};
  std::optional<Summary> summary;
};

/// Shared by the workers of one experiment. Chunks are numbered in the order in which tests are run
/// and handed out in that order; a chunk that has been handed out is finished up to its first
/// failure, unless the user cancels. Hence the first failing test is the same for any number of
/// threads.
class Work {
 public:
  Work(const ExperimentPlan& plan, const TestFunction& test)
      : plan_(plan),
        test_(test),
        vehicles_(vehicles_together(plan)),
        chunk_(chunk_of(plan)),
        chunks_per_row_((plan.tests + chunk_ - 1) / chunk_),
        cells_(plan.cells()) {
    for (Cell& cell : cells_) cell.remaining = plan.tests;
  }

  /// Runs chunks until none is left. An exception is kept for the thread that waits.
  void run_chunks() {
    std::exception_ptr thrown;
    try {
      const std::uint64_t count = chunks_per_row_ * plan_.cells() / vehicles_;
      while (!failed_ && !cancelled_) {
        // Chained tests have chunks as long as a cell, so that one thread runs all of a chain.
        const std::uint64_t chunk = next_chunk_.fetch_add(1);
        if (chunk >= count || !run_chunk(chunk)) break;
      }
    } catch (...) {
      thrown = std::current_exception();
      cancelled_ = true;
    }
    const std::lock_guard lock(mutex_);
    if (thrown) thrown_ = thrown;
    ++workers_done_;
    changed_.notify_one();
  }

  void wait(unsigned workers, const ProgressFunction& progress) {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kProgressInterval, [&] { return workers_done_ == workers; })) {
      // The callback may be slow, so it is not called under the mutex that workers need to end.
      lock.unlock();
      if (progress(this->progress()) == Proceed::no) cancelled_ = true;
      lock.lock();
    }
  }

  ExperimentOutcome outcome() {
    if (thrown_) std::rethrow_exception(thrown_);
    ExperimentOutcome outcome{.progress = progress()};
    for (Cell& cell : cells_) {
      if (cell.summary) outcome.summaries.push_back(std::move(*cell.summary));
    }
    if (failed_chunk_) {
      outcome.failed_test = failed_test_;
      outcome.failure = std::move(failure_);
    }
    return outcome;
  }

  [[nodiscard]] Progress progress() const {
    return {.done = done_, .total = plan_.tests * cells_.size()};
  }

 private:
  bool run_chunk(std::uint64_t chunk) {
    const std::uint64_t index = chunk / chunks_per_row_;
    const std::size_t row = index % plan_.rows();
    const std::size_t vehicle = index / plan_.rows() * vehicles_;
    const std::uint64_t first = chunk % chunks_per_row_ * chunk_;
    const std::uint64_t last = std::min(first + chunk_, plan_.tests);
    TestKey key{.behaviour = row / plan_.agents.size(),
                .agents = plan_.agents[row % plan_.agents.size()]};
    for (key.number = first; key.number < last; ++key.number) {
      for (key.vehicle = vehicle; key.vehicle < vehicle + vehicles_; ++key.vehicle) {
        if (!run(key, chunk)) return false;
      }
    }
    return true;
  }

  bool run(const TestKey& key, std::uint64_t chunk) {
    if (cancelled_) return false;
    Result<TestResult> result = test_(key);
    if (!result) {
      fail(chunk, key, std::move(result.diagnostics()));
      return false;
    }
    Cell& cell = cells_[plan_.cell_of(key)];
    // The measures are of the first vehicle.
    if (plan_.summed_up && key.vehicle == 0) {
      std::call_once(cell.started, [&] { cell.results.resize(plan_.tests); });
      cell.results[key.number] = result.value();
    }
    done_.fetch_add(1, std::memory_order_relaxed);
    // The worker that finishes the cell's last test sums the cell up.
    if (cell.remaining.fetch_sub(1) == 1) finish(cell, key);
    return true;
  }

  void finish(Cell& cell, const TestKey& key) {
    if (plan_.summed_up && key.vehicle == 0) {
      cell.summary = summarise(cell.results);
      cell.summary->behaviour = plan_.behaviours[key.behaviour];
      cell.summary->agents = key.agents;
    }
    std::vector<TestResult>().swap(cell.results);
  }

  void fail(std::uint64_t chunk, const TestKey& key, Diagnostics why) {
    failed_ = true;
    const std::lock_guard lock(mutex_);
    // If tests fail in several threads, the first one in the plan is reported.
    if (failed_chunk_ && *failed_chunk_ < chunk) return;
    failed_chunk_ = chunk;
    failed_test_ = key;
    failure_ = std::move(why);
  }

  const ExperimentPlan& plan_;
  const TestFunction& test_;
  std::size_t vehicles_;
  std::uint64_t chunk_;
  std::uint64_t chunks_per_row_;
  std::vector<Cell> cells_;
  std::atomic<std::uint64_t> next_chunk_{0};
  std::atomic<std::uint64_t> done_{0};
  std::atomic<bool> failed_{false};
  std::atomic<bool> cancelled_{false};

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  unsigned workers_done_ = 0;
  std::exception_ptr thrown_;
  std::optional<std::uint64_t> failed_chunk_;
  TestKey failed_test_;
  Diagnostics failure_;
};

}  // namespace

std::size_t ExperimentPlan::cell_of(const TestKey& test) const {
  const auto column = std::ranges::find(agents, test.agents) - agents.begin();
  return (test.vehicle * behaviours.size() + test.behaviour) * agents.size() +
         static_cast<std::size_t>(column);
}

ExperimentOutcome run_experiment(const ExperimentPlan& plan, const TestFunction& test,
                                 const ProgressFunction& progress) {
  assert(plan.threads > 0 && plan.tests <= kMaxTests);
  Work work(plan, test);
  {
    std::vector<std::jthread> workers;
    const std::size_t count = start_threads(workers, plan.threads, [&work] { work.run_chunks(); });
    work.wait(static_cast<unsigned>(count), progress);
  }
  progress(work.progress());
  return work.outcome();
}

}  // namespace jaywalk
