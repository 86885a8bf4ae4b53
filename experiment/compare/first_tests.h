// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rows that come to nothing: if the first tests of a row (a behaviour, a number of agents, a
// vehicle) all end errored for the same reason, its other tests are not started, but count as
// errored, too. Which these are depends on the tests alone: a test waits until it is known whether
// it is to start. Tests are handed out in the order of their numbers (run_experiment), so the first
// ones never wait.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/experiment.h"

namespace jaywalk {

class FirstTests {
 public:
  /// How many tests of a row decide about the others.
  static constexpr std::uint64_t kCount = 8;

  /// REQUIRES: the plan outlives it.
  explicit FirstTests(const ExperimentPlan& plan) : plan_(plan), cells_(plan.cells()) {}

  /// It is one of the first tests of a row of which nothing is decided yet.
  [[nodiscard]] bool is_wanted(const TestKey& test) const;
  /// Why the test is not started; empty: it is. Waits until all of the first tests, or one that
  /// settles it, are finished; nothing if that was given up.
  [[nodiscard]] std::optional<std::string> why_not_started(const TestKey& test);
  /// The test has ended: `error` says why it is errored, empty if it is not. Each test once.
  void finished(const TestKey& test, const std::string& error);
  /// Ends all waiting: a test has failed, or the user wants to stop.
  void give_up();

 private:
  struct Cell {
    std::atomic<bool> goes_on = false;
    std::uint64_t errored = 0;
    std::string error;
  };

  const ExperimentPlan& plan_;
  std::mutex mutex_;  // guards the cells' counts and errors
  std::condition_variable changed_;
  std::vector<Cell> cells_;
  bool given_up_ = false;
};

}  // namespace jaywalk
