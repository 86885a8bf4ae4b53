// SPDX-License-Identifier: Apache-2.0
#pragma once

// Coverage feedback: pedestrians receive the bins that earlier tests covered as beliefs. The tests
// of one behaviour with one number of agents are run in generations. All tests of a generation
// receive the bins that all tests of the generations before have covered, so that the outcome does
// not depend on threads. A stored test keeps the bins that it received, and can be run again.

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/situation_table.h"
#include "experiment/test_run/covered_bins.h"

namespace jaywalk {

/// Makes the tests of a generation wait for those of the generations before. Tests are handed out
/// in the order of their numbers (run_experiment), so the first that is not finished never waits.
class CoverageFeedback {
 public:
  /// `table` has the bins that the tests cover. REQUIRES: both outlive it; a generation has tests.
  CoverageFeedback(const ExperimentPlan& plan, std::uint64_t generation,
                   const SituationTable& table);

  /// Waits for the generations before the test's; returns the bins that it receives. Nothing after
  /// give_up().
  [[nodiscard]] std::optional<std::vector<CoveredBin>> wait_for(const TestKey& test);
  /// Reports that the table has the test. Call it once for each test, also for tests of a continued
  /// store.
  void finished(const TestKey& test);
  /// Ends all waiting, because a test has failed or the user wants to stop.
  void give_up();

 private:
  struct Cell {
    std::vector<std::uint64_t> missing;  // tests by generation
    std::uint64_t complete = 0;          // generations
    SituationCoverage coverage;          // of the complete ones
    std::vector<std::vector<CoveredBin>> covered;
  };
  [[nodiscard]] Cell& cell_of(const TestKey& test);

  const ExperimentPlan& plan_;
  std::uint64_t generation_;
  const SituationTable& table_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Cell> cells_;
  bool given_up_ = false;
};

}  // namespace jaywalk
