// SPDX-License-Identifier: Apache-2.0
#pragma once

// Failures of agents that explain the measures: dropped intentions, pedestrians that never acted,
// tests that ended errored. A misspelt action gives an accuracy of 0 %; this says why. Read
// interpreter/agent/drops.h first.

#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/test_run/test_result.h"

namespace jaywalk {

/// An error that ended several tests.
struct SharedError {
  std::string message;
  std::uint64_t tests = 0;
  /// The number of the first of them.
  std::uint64_t first_test = 0;

  friend bool operator==(const SharedError&, const SharedError&) = default;
};

/// A reason that several agents had.
struct SharedCause {
  /// The cause as the first agent in the first test had it; `times` is the sum over all agents.
  DropCause cause;
  std::uint64_t agents = 0;
};

/// The failures in all tests of a behaviour with one number of agents, or with several.
struct Troubles {
  /// Counts over all tests, this one and the next three.
  std::uint64_t agents = 0;
  std::uint64_t pedestrians = 0;
  std::uint64_t idle = 0;
  /// Agents that dropped at least one intention.
  std::uint64_t dropping = 0;
  /// The causes, those with most agents first.
  std::vector<SharedCause> causes;
  /// The number of tests that ended errored, and their errors, the most frequent one first.
  std::uint64_t errored = 0;
  std::vector<SharedError> errors;

  [[nodiscard]] bool never_acted() const { return pedestrians > 0 && idle == pedestrians; }
};

/// Sums up tests; the sum depends on the tests alone, whatever their order.
class TroublesSum {
 public:
  /// `test` is the test's number; each once.
  void add(std::uint64_t test, const TestTroubles& troubles);
  [[nodiscard]] Troubles sum() const;

 private:
  struct Entry {
    SharedCause shared;
    std::uint64_t first_test = 0;
  };
  void add_cause(std::uint64_t test, const DropCause& cause);

  Troubles totals_;  // without causes and errors
  std::vector<Entry> entries_;
  std::map<std::string, SharedError> errors_;  // by message
};

/// The sum of the failures with several numbers of agents.
[[nodiscard]] Troubles together(std::span<const Troubles> parts);

/// Collects from several threads.
class TroublesTable {
 public:
  explicit TroublesTable(const ExperimentPlan& plan)
      : agents_(plan.agents), cells_(plan.behaviours.size() * plan.agents.size()) {}

  /// REQUIRES: a test of the plan; each once.
  void add(const TestKey& test, const TestTroubles& troubles);
  [[nodiscard]] Troubles troubles(std::size_t behaviour, std::uint32_t agents) const;

 private:
  struct Cell {
    mutable std::mutex mutex;
    TroublesSum sum;
  };
  [[nodiscard]] std::size_t cell_index(std::size_t behaviour, std::uint32_t agents) const;

  std::vector<std::uint32_t> agents_;
  std::vector<Cell> cells_;
};

}  // namespace jaywalk
