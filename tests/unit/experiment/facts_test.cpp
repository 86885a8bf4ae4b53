// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/facts.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/report.h"

namespace jaywalk::reporting {
namespace {

using testing::ElementsAre;
using testing::Pair;

ExperimentPlan four_tests() { return {.behaviours = {"a", "b"}, .agents = {1, 3}, .tests = 4}; }

TEST(Facts, BelongToABehaviourWithANumberOfAgents) {
  FactsTable table(four_tests());
  table.add({.behaviour = 1, .agents = 3, .number = 2}, {.succeeded = true, .ticks = 7});
  EXPECT_THAT(table.facts(1, 3).succeeded, ElementsAre(false, false, true, false));
  EXPECT_THAT(table.facts(1, 3).ticks, ElementsAre(Pair(7, 1)));
  EXPECT_TRUE(table.facts(1, 1).succeeded.empty());
  EXPECT_TRUE(table.facts(0, 3).succeeded.empty());
}

TEST(Facts, CountTicksOfTheTestsThatCameToAnEnd) {
  FactsTable table(four_tests());
  table.add({.agents = 1, .number = 0}, {.ticks = 7});
  table.add({.agents = 1, .number = 1}, {.ticks = 9});
  table.add({.agents = 1, .number = 2}, {.ticks = 7});
  table.add({.agents = 1, .number = 3}, {.errored = true, .ticks = 2});
  EXPECT_THAT(table.facts(0, 1).ticks, ElementsAre(Pair(7, 2), Pair(9, 1)));
  EXPECT_THAT(table.facts(0, 1).errored, ElementsAre(false, false, false, true));
}

TEST(Facts, KeepPlacesInSquaresOfHalfAMetre) {
  FactsTable table(four_tests());
  const TestKey test{.agents = 1};
  table.add_place(test, 1.0, 2.0);
  table.add_place(test, 1.49, 2.49);
  table.add_place(test, 1.5, 2.0);
  table.add_place(test, -0.1, 0);
  EXPECT_THAT(table.facts(0, 1).places,
              ElementsAre(Pair(Pair(-1, 0), 1), Pair(Pair(2, 4), 2), Pair(Pair(3, 4), 1)));
}

TEST(Facts, PutRoundedPlacesIntoTheSquareThatWasMeant) {
  FactsTable table(four_tests());
  // 0.1 ten times is a little less than 1.
  double tenth = 0;
  for (int i = 0; i < 10; ++i) tenth += 0.1;
  table.add_place({.agents = 1}, tenth, 0);
  EXPECT_THAT(table.facts(0, 1).places, ElementsAre(Pair(Pair(2, 0), 1)));
}

TEST(Facts, HoldPlacesThatAreFarOutsideOfAnyWorld) {
  FactsTable table(four_tests());
  table.add_place({.agents = 1}, 1e300, -1e300);
  EXPECT_THAT(table.facts(0, 1).places, ElementsAre(Pair(Pair(2'000'000, -2'000'000), 1)));
}

TEST(Facts, TakePlacesFromRecordings) {
  Recording recording(1,
                      {{"av", ActorKind::vehicle, 4, 2}, {"p", ActorKind::pedestrian, 0.5, 0.5}});
  recording.add(Scene{{0, 0, 5, 0}, {3, 20, 0, 0}});
  recording.add(Scene{{0, 5, 5, 0}, {2.5, 20, 0, 0}});
  recording.add(RecordedEvent{.tick = 1, .actor = 1, .kind = "precondition", .text = {}});
  recording.add(RecordedEvent{.tick = 1, .actor = 1, .kind = "collision", .text = {}});
  recording.add(RecordedEvent{.tick = 0, .actor = {}, .kind = "precondition", .text = {}});
  FactsTable table(four_tests());
  table.add({.agents = 1}, {.succeeded = true, .ticks = 1}, recording);
  EXPECT_THAT(table.facts(0, 1).places, ElementsAre(Pair(Pair(5, 40), 1)));
  table.add({.agents = 1, .number = 1}, {.errored = true}, recording);
  EXPECT_THAT(table.facts(0, 1).places, ElementsAre(Pair(Pair(5, 40), 1)))
      << "nothing is known of a test that ended errored";
}

Comparison comparison_of(const std::vector<std::pair<std::string, std::uint32_t>>& rows) {
  Comparison comparison;
  for (const auto& [behaviour, agents] : rows) {
    comparison.summaries.push_back({.behaviour = behaviour, .agents = agents});
  }
  return comparison;
}

TEST(ComparisonRows, AreFoundByBehaviourAndAgents) {
  const Comparison comparison = comparison_of({{"b", 3}, {"b", 1}, {"a", 10}});
  EXPECT_THAT(behaviours_of(comparison), ElementsAre("b", "a"));
  EXPECT_THAT(agents_of(comparison), ElementsAre(1, 3, 10));
  EXPECT_EQ(find_summary(comparison, "b", 1), &comparison.summaries[1]);
  EXPECT_EQ(find_summary(comparison, "a", 1), nullptr);
  EXPECT_EQ(find_summary(comparison, "c", 1), nullptr);
}

TEST(Sections, HaveNamesThatCanBeAnchors) {
  for (const Section& section : sections()) {
    EXPECT_FALSE(section.title.empty()) << section.name;
    EXPECT_TRUE(std::ranges::all_of(section.name, [](char c) {
      return (c >= 'a' && c <= 'z') || c == '_';
    })) << section.name;
  }
}

}  // namespace
}  // namespace jaywalk::reporting
