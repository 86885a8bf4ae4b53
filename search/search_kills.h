// SPDX-License-Identifier: Apache-2.0
#pragma once

// Searches for defects as rows of the kill matrix, beside behaviours
// (experiment/compare/kills/kills.h): a generator's tests with each defective AV. Read
// search_experiment.h first.

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "experiment/compare/kills/kills.h"
#include "search/search_experiment.h"

namespace jaywalk::search {

/// Counts searches as they end, from several threads at once, so that their tests need not be kept.
class SearchKills {
 public:
  /// REQUIRES: the experiment has defects, and outlives it.
  explicit SearchKills(const SearchExperiment& experiment);

  /// `search`: its index in the results. REQUIRES: each once.
  void add(std::size_t search, const SearchRun& run);

  /// A row for each generator, under its own name. The first kill is the median over the
  /// repetitions; a cell has no tests as long as some repetition is not complete.
  /// REQUIRES: no thread adds at the same time.
  [[nodiscard]] KillMatrix matrix() const;

  /// Tests and how many defects they kill together.
  struct Team {
    std::vector<TestInput> tests;
    std::size_t killed = 0;
  };
  /// The test that kills most defects, and the two that do so together; of equals the first by
  /// their numbers. `generator`: the row of the matrix. Fewer if fewer are of use.
  [[nodiscard]] std::vector<Team> best_tests(std::size_t generator) const;

 private:
  struct Count {
    bool complete = false;
    std::uint64_t tests = 0;
    std::uint64_t kills = 0;
    std::uint64_t healthy_failures = 0;
    std::optional<std::uint64_t> first;
  };
  [[nodiscard]] KillCell cell_of(std::size_t generator) const;

  const SearchPlan& plan_;
  std::size_t defects_;
  std::vector<Count> counts_;
  std::mutex mutex_;
  /// For each generator: the defects that each input kills.
  std::vector<std::map<std::vector<double>, std::vector<bool>>> killers_;
};

}  // namespace jaywalk::search
