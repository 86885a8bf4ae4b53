// SPDX-License-Identifier: Apache-2.0
#pragma once

// Situation coverage: which of the situations worth testing the tests have met. The items and their
// bins are the rows of situations.def. Read judge/signals/signals.h first.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/grid/grid.h"
#include "experiment/judge/signals/signals.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// The moment at which a test met its precondition.
struct Situation {
  const TestView& view;
  ActorIndex pedestrian = 0;
  /// REQUIRES: at least 1.
  std::size_t tick = 1;
};

struct SituationItem {
  std::string_view name;
  std::string summary;
  std::vector<std::string> bins;
};

/// Items, then pairs, in the order of situations.def.
[[nodiscard]] std::span<const SituationItem> situation_items();

/// The bin of each item that a test covers; unset if it covers none of that item's bins.
using SituationBins = std::vector<std::optional<std::uint32_t>>;

/// REQUIRES: recording and ground of one test, with its events.
[[nodiscard]] SituationBins covered_bins(const Recording& recording, const Ground& ground);

/// Whether tests can meet a bin at all, by item, then bin; empty: not known.
using ReachableBins = std::vector<std::vector<bool>>;

namespace situation {
/// The precondition is met in the same bin of entry_time however much later than this.
inline constexpr double kLate_s = 9;

#define JAYWALK_SITUATION(name, bins, summary) \
  std::optional<std::uint32_t> name(const Situation& situation);
#define JAYWALK_SITUATION_PAIR(name, first, second)
#include "experiment/judge/situations/situations.def"
#undef JAYWALK_SITUATION
#undef JAYWALK_SITUATION_PAIR
}  // namespace situation

/// How often each bin was covered, by tests that were added in their order.
class SituationCoverage {
 public:
  SituationCoverage();

  void add(const SituationBins& test);

  [[nodiscard]] std::uint64_t tests() const { return tests_; }
  /// By item, then bin.
  [[nodiscard]] const std::vector<std::vector<std::uint64_t>>& counts() const { return counts_; }
  [[nodiscard]] std::uint64_t covered() const { return covered_; }
  [[nodiscard]] std::uint64_t bins() const { return bins_; }
  /// The number of bins that can be covered; all of them where that is not known. Covered bins
  /// count, whatever `reachable` says.
  [[nodiscard]] std::uint64_t bins(const ReachableBins& reachable) const;
  /// The growth of coverage: `covered` bins after `tests` tests; one entry for each increase.
  struct Growth {
    std::uint64_t tests = 0;
    std::uint64_t covered = 0;
  };
  [[nodiscard]] const std::vector<Growth>& growth() const { return growth_; }
  /// The number of bins covered by the first `tests` tests.
  [[nodiscard]] std::uint64_t covered_after(std::uint64_t tests) const;

 private:
  std::vector<std::vector<std::uint64_t>> counts_;
  std::uint64_t tests_ = 0;
  std::uint64_t covered_ = 0;
  std::uint64_t bins_ = 0;
  std::vector<Growth> growth_;
};

/// A pedestrian's start and what it does in each tick: a letter of `fblrs` for forward, back, left,
/// right, stay. agents/crossing/scripted.asl repeats it.
struct ScriptedWalk {
  Position start;
  std::string moves;

  friend bool operator==(const ScriptedWalk&, const ScriptedWalk&) = default;
};

inline constexpr std::string_view kWalkLetters = "fblrs";
inline constexpr std::string_view kReachHeader =
    "item,bin,name,reachable,start_row,start_cell,moves";
inline constexpr std::string_view kWalksHeader = "start_row,start_cell,moves";

/// Which situations tests can meet at all, and walks that meet them, as `jaywalk reach --csv`
/// writes them (search/model_based/reachable_situations.h); or walks alone, as people write them.
struct ReachFile {
  /// Empty if the file has walks alone.
  ReachableBins reachable;
  /// Each once, in the order of the lines.
  std::vector<ScriptedWalk> walks;
};

/// All mistakes are reported, with their places.
[[nodiscard]] Result<ReachFile> parse_reach_file(const SourcePtr& source);

}  // namespace jaywalk
