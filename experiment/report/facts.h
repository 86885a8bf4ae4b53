// SPDX-License-Identifier: Apache-2.0
#pragma once

// Data of single tests that a report needs beside their sums: which succeeded (to compare
// behaviours test by test), how long they took, and where pedestrians met the precondition.

#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/measures/significance.h"
#include "experiment/judge/recording.h"

namespace jaywalk::reporting {

/// A square of the ground: multiples of kSquare_m to the right and ahead.
using Square = std::pair<int, int>;
inline constexpr double kSquare_m = 0.5;

/// The facts of the tests of one behaviour with one number of agents.
struct CellFacts {
  /// By the number of the test, as the next.
  std::vector<bool> succeeded;
  std::vector<bool> errored;
  /// The ticks of all tests but those that ended errored.
  Counts ticks;
  /// How many pedestrians met the precondition where.
  std::map<Square, std::uint64_t> places;
};

/// Collects facts from several threads; the result depends on the tests alone.
class FactsTable {
 public:
  explicit FactsTable(const ExperimentPlan& plan);

  /// REQUIRES: a test of the plan, numbered from 0; each once.
  void add(const TestKey& test, const TestResult& result);
  /// A pedestrian of the test met the precondition there.
  void add_place(const TestKey& test, double x_m, double y_m);
  void add(const TestKey& test, const TestResult& result, const Recording& recording);

  /// REQUIRES: no thread adds at the same time.
  [[nodiscard]] const CellFacts& facts(std::size_t behaviour, std::uint32_t agents) const;

 private:
  struct Cell {
    std::mutex mutex;
    CellFacts facts;
  };
  [[nodiscard]] std::size_t cell_index(std::size_t behaviour, std::uint32_t agents) const;

  std::vector<std::uint32_t> agents_;
  std::uint64_t tests_;
  std::vector<Cell> cells_;
};

}  // namespace jaywalk::reporting
