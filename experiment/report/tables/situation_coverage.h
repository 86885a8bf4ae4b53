#pragma once

// Situation coverage as text, CSV and JSON.

#include <string>
#include <vector>

#include "experiment/judge/situations/situations.h"

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
