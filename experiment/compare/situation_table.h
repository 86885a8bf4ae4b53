// SPDX-License-Identifier: Apache-2.0
#pragma once

// The situations that an experiment's tests have met. Read situations.h first.

#include <cstdint>
#include <mutex>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/judge/situations/situations.h"

namespace jaywalk {

/// Collects the covered bins of tests from several threads; the coverage depends on the tests
/// alone.
class SituationTable {
 public:
  /// REQUIRES: the plan outlives it.
  explicit SituationTable(const ExperimentPlan& plan);

  /// REQUIRES: a test of the plan.
  void add(const TestKey& test, const SituationBins& bins);
  /// The coverage of the first `tests` tests of a behaviour with a number of agents; tests that
  /// were not added cover nothing. REQUIRES: no thread adds one of these tests at the same time.
  [[nodiscard]] SituationCoverage coverage(std::size_t behaviour, std::uint32_t agents,
                                           std::uint64_t tests) const;
  /// Tests from `first` up to, not including, `last` are added to a coverage.
  void add_to(SituationCoverage& coverage, std::size_t behaviour, std::uint32_t agents,
              std::uint64_t first, std::uint64_t last) const;

 private:
  struct Cell {
    std::once_flag started;
    std::vector<std::uint8_t> bins;  // of test after test, by item
  };
  [[nodiscard]] std::size_t cell_index(std::size_t behaviour, std::uint32_t agents) const;

  const ExperimentPlan& plan_;
  std::vector<Cell> cells_;
};

}  // namespace jaywalk
