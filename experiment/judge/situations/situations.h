#pragma once

// Situation coverage: which of the situations that are to be tested the tests have met. The items
// and their bins are the rows of situations.def. Read judge/signals/signals.h first.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/judge/signals/signals.h"

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

/// The bins that a test covers, by the items; unset: none of that item's.
using SituationBins = std::vector<std::optional<std::uint32_t>>;

/// REQUIRES: recording and ground of one test, with its events.
[[nodiscard]] SituationBins covered_bins(const Recording& recording, const Ground& ground);

/// Which bins tests can meet at all, by item, then bin; empty: not known.
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
  /// Those that can be covered; all of them where that is not known. What is covered can be,
  /// whatever `reachable` says.
  [[nodiscard]] std::uint64_t bins(const ReachableBins& reachable) const;
  /// How coverage grew: after so many tests, so many bins; one entry for each growth.
  struct Growth {
    std::uint64_t tests = 0;
    std::uint64_t covered = 0;
  };
  [[nodiscard]] const std::vector<Growth>& growth() const { return growth_; }
  /// How many bins were covered after so many tests.
  [[nodiscard]] std::uint64_t covered_after(std::uint64_t tests) const;

 private:
  std::vector<std::vector<std::uint64_t>> counts_;
  std::uint64_t tests_ = 0;
  std::uint64_t covered_ = 0;
  std::uint64_t bins_ = 0;
  std::vector<Growth> growth_;
};

}  // namespace jaywalk
