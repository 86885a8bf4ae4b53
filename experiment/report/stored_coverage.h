// SPDX-License-Identifier: Apache-2.0
#pragma once

// Coverage of the tests in a store: of situations from their recordings, of the agents' programs by
// running them again. Situation coverage as text, CSV and JSON.

#include <functional>
#include <string>
#include <vector>

#include "experiment/judge/situations/situations.h"
#include "experiment/results/reader.h"
#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {

/// The coverage of one behaviour with one number of agents.
struct SituationRow {
  std::string behaviour;
  std::uint32_t agents = 0;
  SituationCoverage coverage;
  /// Which bins its tests can cover at all; empty: not known.
  ReachableBins reachable;

  [[nodiscard]] std::uint64_t bins() const { return coverage.bins(reachable); }
};

/// Which tests; empty fields: all.
struct CoverageWanted {
  std::optional<std::string> behaviour;
  std::optional<std::uint32_t> agents;
  /// The most tests of each behaviour and number of agents; the first ones are taken.
  std::optional<std::uint64_t> tests;
};

/// Called now and then; may end it, and there is no result then.
using CoverageProgress = std::function<Proceed(const Progress&)>;

/// A row for each behaviour and number of agents. Tests that are not in the store cover nothing.
[[nodiscard]] Result<std::vector<SituationRow>> stored_situations(const ResultsReader& store,
                                                                  const CoverageWanted& wanted,
                                                                  const CoverageProgress& progress);

/// Runs the tests again and returns the coverage of their programs. The result does not depend on
/// the number of threads.
[[nodiscard]] Result<SourceCoverage> stored_plan_coverage(const ResultsReader& store,
                                                          const CoverageWanted& wanted,
                                                          unsigned threads,
                                                          const CoverageProgress& progress);

/// The reachable bins for a number of agents; scenarios know them only for tests with one agent.
[[nodiscard]] ReachableBins reachable_with(const ReachableBins& reachable, std::uint32_t agents);

/// For each row how many bins are covered of those that can be, and how that grew; for each item
/// the bins and how often each was covered by all rows together; what no row's tests can cover is
/// no hole.
[[nodiscard]] std::string situation_text(const std::vector<SituationRow>& rows);
/// A line for each row, item and bin: behaviour,agents,tests,item,bin,name,times.
[[nodiscard]] std::string situation_csv(const std::vector<SituationRow>& rows);
[[nodiscard]] std::string situation_json(const std::vector<SituationRow>& rows);

}  // namespace jaywalk
