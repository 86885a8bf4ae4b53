// SPDX-License-Identifier: Apache-2.0
// Whole tests of the AgentSpeak programs, worked out by hand. The AV starts at 0 and drives 6 cells
// a tick; tick t tests rows 2 to 5, cells 6t - 5 to 6t.

#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::behaviour;
using testing_scenario::outcome;
using testing_scenario::paper_from;

std::string forward(const std::string& name) {
  return "behaviours." + name + ".parameters.first_way=forward";
}

void expect(const CrossingResult& result, int ticks, int hit_cell, double score) {
  EXPECT_TRUE(result.success);
  EXPECT_EQ(result.ticks, ticks);
  EXPECT_EQ(result.hit_cell, hit_cell);
  EXPECT_DOUBLE_EQ(result.score(), score);
}

// From (1,20), forward. Tick 1: to (1,21). Tick 2: f = 6, d = 15 + 1, too far: to (1,22). Tick 3:
// f = 12, d = 10 + 1, near: to (2,22), zone 13 to 18. Tick 4: to (3,22), zone 19 to 24, hit.
// Costs 1 + 1 + 5 + 5.
TEST(HandWorked, Proximity) {
  const auto prepared = paper_from({{1, 20}}, {forward("proximity")});
  expect(outcome(*prepared, "proximity", 1), 4, 22, 88);
}

// Like the test above with the radius 17: near in tick 2 already. To (2,21), zone 7 to 12; tick 3:
// (3,21), zone 13 to 18; tick 4: (4,21), zone 19 to 24, hit. Costs 1 + 5 + 5 + 5.
TEST(HandWorked, ProximityWithAnotherRadius) {
  const auto prepared =
      paper_from({{1, 20}}, {forward("proximity"), "behaviours.proximity.parameters.radius=17"});
  expect(outcome(*prepared, "proximity", 1), 4, 21, 84);
}

// The radius 16 is the distance in tick 2: it counts only if it is inclusive.
TEST(HandWorked, ProximityWithTheRadiusItself) {
  const std::string radius = "behaviours.proximity.parameters.radius=16";
  const auto exclusive = paper_from({{1, 20}}, {forward("proximity"), radius});
  expect(outcome(*exclusive, "proximity", 1), 4, 22, 88);
  const auto inclusive = paper_from(
      {{1, 20}},
      {forward("proximity"), radius, "behaviours.proximity.parameters.radius_limit=inclusive"});
  expect(outcome(*inclusive, "proximity", 1), 4, 21, 84);
}

// From (0,30), forward. Tick 1: to (0,31). Tick 2: f = 6; two moves to row 2, so that ticks 2 to 5
// from now are spent in the zone's rows; the last of them tests 6 + 24 + 1 = 31 to 36: cross.
// Rows 1 to 5 in ticks 2 to 6; hit in tick 6 in row 5. Costs 1 + 1 + 4 * 5.
TEST(HandWorked, Intersect) {
  const auto prepared = paper_from({{0, 30}}, {forward("intersect")});
  expect(outcome(*prepared, "intersect", 1), 6, 31, 78);
}

// The same start, literally: the AV will not have passed, so cross in tick 2. For cell 40 that is
// too early: tick 7, the first whose zone (37 to 42) has the cell (0,40) -> 41, finds row 6.
TEST(HandWorked, IntersectLiteralCrossesTooEarly) {
  const auto prepared = paper_from({{0, 40}}, {forward("intersect_literal")});
  const CrossingResult result = outcome(*prepared, "intersect_literal", 1);
  EXPECT_FALSE(result.success);
  EXPECT_EQ(result.ticks, 11);
  // Tick 1 and 2 on the left pavement, 3 to 10 in rows 2 to 9, 11 in row 10.
  EXPECT_DOUBLE_EQ(result.score(), -(2 + 8 * 5 + 1));
}

// p1 as in Proximity, p2 on the other pavement: in tick 3 d = 11 against 10 + 5, which is not near.
// p1 is elected: 88 for it, four ticks of pavement for p2.
TEST(HandWorked, Election) {
  const auto prepared = paper_from({{1, 20}, {10, 20}}, {forward("election")});
  expect(outcome(*prepared, "election", 2), 4, 22, (88 - 4) / 2.0);
}

// Both could be elected in tick 3 with d = 11: the lower id is, alone.
TEST(HandWorked, ElectionOfTheLowestIdAmongEquals) {
  const auto prepared = paper_from({{1, 20}, {1, 20}}, {forward("election")});
  const CrossingResult result = outcome(*prepared, "election", 2);
  expect(result, 4, 22, (88 - 4) / 2.0);
  EXPECT_EQ(result.met_by, (std::vector<std::size_t>{0}));
}

// p2 is nearer though its id is higher: in tick 2 f = 6, p1 at (1,23) d = 18; p2 at (1,19) d = 14:
// elected, to (2,19); tick 3: (3,19), zone 13 to 18; tick 4: (4,19), zone 19 to 24, hit.
// p2: 100 - 1 - 5 - 5 - 5, p1: -4.
TEST(HandWorked, ElectionOfTheNearest) {
  const auto prepared = paper_from({{1, 22}, {1, 18}}, {forward("election")});
  const CrossingResult result = outcome(*prepared, "election", 2);
  expect(result, 4, 19, (84 - 4) / 2.0);
  EXPECT_EQ(result.met_by, (std::vector<std::size_t>{1}));
}

// p1 as in Intersect, elected in tick 2 with entry in 5 ticks. p2 at (1,24) -> 25 in tick 2: one
// move to row 2; ticks 1 to 4 from now test 7-12, 13-18, 19-24, 25-30: entry in 4 ticks, so p2 it
// is. It crosses in ticks 2 to 5: hit in tick 5. p2: 100 - 1 - 4 * 5, p1: -5.
TEST(HandWorked, ElectionByIntersect) {
  const auto prepared = paper_from({{0, 30}, {1, 24}}, {forward("election_by_intersect")});
  const CrossingResult result = outcome(*prepared, "election_by_intersect", 2);
  expect(result, 5, 25, (79 - 5) / 2.0);
  EXPECT_EQ(result.met_by, (std::vector<std::size_t>{1}));
}

// Crossing at once from (1,12): row 2 in tick 1, row 3 in tick 2, whose zone is 7 to 12. 100 - 5
// - 5.
TEST(HandWorked, RandomBehaviourThatAlwaysCrosses) {
  const auto prepared =
      paper_from({{1, 12}}, {"behaviours.random_behaviour.parameters.crossing_probability=1"});
  expect(outcome(*prepared, "random_behaviour", 1), 2, 12, 90);
}

TEST(HandWorked, RandomBehaviourThatNeverCrosses) {
  const auto prepared =
      paper_from({{1, 12}}, {"behaviours.random_behaviour.parameters.crossing_probability=0"});
  const CrossingResult result = outcome(*prepared, "random_behaviour", 1);
  EXPECT_FALSE(result.success);
  EXPECT_DOUBLE_EQ(result.score(), -11);
}

std::vector<int> rows_of_a_crosser(Position start) {
  const auto prepared =
      paper_from({start}, {"behaviours.random_behaviour.parameters.crossing_probability=1"});
  std::vector<int> rows;
  TestOptions options;
  options.observe = [&](const World& world, const Mas&) {
    rows.push_back(find_crossing(world)->positions()[0].x);
  };
  const TestRun result = run_test(
      *prepared, {.behaviour = behaviour(*prepared, "random_behaviour"), .agents = 1}, options);
  EXPECT_TRUE(result.completed);
  return rows;
}

// Cell 65 is reached by the zone in tick 11 alone, so that both cross undisturbed.
TEST(HandWorked, RandomBehaviourTurnsRoundOnTheFarPavement) {
  EXPECT_EQ(rows_of_a_crosser({1, 65}), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 10}));
  EXPECT_EQ(rows_of_a_crosser({10, 65}), (std::vector<int>{10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 2, 3}));
}

// A walker at the end of the grid turns round: from (1,65) down to (1,55).
TEST(HandWorked, WalkersTurnRoundAtTheEndOfTheGrid) {
  const auto prepared =
      paper_from({{1, 64}}, {"behaviours.random_behaviour.parameters.crossing_probability=0",
                             "behaviours.random_behaviour.parameters.first_way=forward"});
  std::vector<int> cells;
  TestOptions options;
  options.observe = [&](const World& world, const Mas&) {
    cells.push_back(find_crossing(world)->positions()[0].y);
  };
  (void)run_test(*prepared, {.behaviour = behaviour(*prepared, "random_behaviour"), .agents = 1},
                 options);
  EXPECT_EQ(cells, (std::vector<int>{64, 65, 64, 63, 62, 61, 60, 59, 58, 57, 56, 55}));
}

}  // namespace
}  // namespace jaywalk
