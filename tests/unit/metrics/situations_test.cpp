// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "drives.h"
#include "experiment/compare/situation_table.h"

namespace jaywalk {
namespace {

std::size_t item(std::string_view name) {
  const auto items = situation_items();
  return static_cast<std::size_t>(std::ranges::find(items, name, &SituationItem::name) -
                                  items.begin());
}

std::string bin(const SituationBins& bins, std::string_view name) {
  const std::size_t index = item(name);
  return bins[index] ? situation_items()[index].bins[*bins[index]] : "none";
}

/// The AV's leading edge begins at y = 2 and drives 9 m/s; a pedestrian crosses from its left.
Recording crossing_from_the_left(Place start) {
  Recording recording = drive(1, {steps({0, 0}, {0, 9}, 4), steps(start, {1.5, 0}, 4)});
  recording.add(RecordedEvent{.tick = 2, .actor = 1, .kind = "precondition", .text = {}});
  return recording;
}

TEST(Situations, AreSeenFromWhoMeetsThePreconditionFirst) {
  // At tick 2 the pedestrian is at x = -0.5; the AV's edge was at y = 11 before.
  const auto bins = covered_bins(crossing_from_the_left({-3.5, 13}), road());
  EXPECT_EQ(bin(bins, "start_side"), "left");
  EXPECT_EQ(bin(bins, "approach"), "from the left");
  EXPECT_EQ(bin(bins, "entry_ttc"), "0.2-0.4 s") << "2 m at 9 m/s";
  EXPECT_EQ(bin(bins, "impact_point"), "25 %");
  EXPECT_EQ(bin(bins, "entry_time"), "0-3 s");
  EXPECT_EQ(bin(bins, "av_speed"), "9 m/s-");
  EXPECT_EQ(bin(bins, "others"), "none");
  EXPECT_EQ(bin(bins, "side_and_ttc"), "left, 0.2-0.4 s");
}

TEST(Situations, CountTheOthersInTheRoad) {
  Recording recording = drive(1, {steps({0, 0}, {0, 9}, 4), steps({-3.5, 13}, {1.5, 0}, 4),
                                  steps({1, 30}, {0, 0}, 4), steps({-20, 30}, {0, 0}, 4)});
  recording.add(RecordedEvent{.tick = 2, .actor = 1, .kind = "precondition", .text = {}});
  EXPECT_EQ(bin(covered_bins(recording, road()), "others"), "1");
}

TEST(Situations, OfATestThatMeetsNoPreconditionAreNone) {
  const Recording recording = drive(1, {steps({0, 0}, {0, 9}, 4), steps({-5, 13}, {0, 0}, 4)});
  const auto bins = covered_bins(recording, road());
  EXPECT_TRUE(std::ranges::none_of(bins, [](const auto& bin) { return bin.has_value(); }));
}

TEST(SituationCoverage, GrowsWithEachBinThatIsNew) {
  SituationCoverage coverage;
  const auto one = covered_bins(crossing_from_the_left({-3.5, 13}), road());
  const auto other = covered_bins(crossing_from_the_left({-3.5, 15}), road());
  coverage.add(SituationBins(situation_items().size()));
  coverage.add(one);
  coverage.add(one);
  coverage.add(other);
  const std::uint64_t items = situation_items().size();
  EXPECT_EQ(coverage.tests(), 4U);
  ASSERT_EQ(coverage.growth().size(), 2U);
  EXPECT_EQ(coverage.growth()[0].tests, 2U);
  EXPECT_EQ(coverage.growth()[0].covered, items);
  // Only the time to collision differs, with the two pairs that have it.
  EXPECT_EQ(coverage.growth()[1].tests, 4U);
  EXPECT_EQ(coverage.growth()[1].covered, items + 3);
  EXPECT_EQ(coverage.covered_after(3), items);
  EXPECT_EQ(coverage.counts()[item("start_side")][0], 3U);
}

TEST(SituationTable, SumsUpInTheOrderOfTheTests) {
  const ExperimentPlan plan{.behaviours = {"a", "b"}, .agents = {1, 5}, .tests = 3};
  SituationTable table(plan);
  const auto bins = covered_bins(crossing_from_the_left({-3.5, 13}), road());
  table.add({.behaviour = 1, .agents = 5, .number = 2}, bins);
  const SituationCoverage coverage = table.coverage(1, 5, 3);
  EXPECT_EQ(coverage.tests(), 3U);
  EXPECT_EQ(coverage.growth().at(0).tests, 3U);
  EXPECT_EQ(table.coverage(0, 5, 3).covered(), 0U);
}

}  // namespace
}  // namespace jaywalk
