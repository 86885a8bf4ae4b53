// SPDX-License-Identifier: Apache-2.0
// The world alone, driven action by action, against tests worked out by hand. In all of them the
// AV starts at cell 0 and drives 6 cells a tick; the zone of tick t is rows 2 to 5, cells 6t - 5 to
// 6t.

#include "env/crossing/crossing.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

class CrossingTest : public testing::Test {
 protected:
  Crossing world(std::vector<Position> start, int head_start = 0) const {
    return Crossing(parameters_, vocabulary_, std::move(start), head_start);
  }

  ActionRequest move(std::size_t agent, Direction direction) const {
    const Value& way = ways_[static_cast<std::size_t>(direction)];
    return {static_cast<AgentId>(agent), vocabulary_.move(), {&way, 1}};
  }

  static std::vector<ActionResult> tick(Crossing& crossing,
                                        const std::vector<ActionRequest>& actions) {
    std::vector<ActionResult> results(actions.size());
    crossing.execute(actions, results);
    crossing.advance();
    return results;
  }

  /// Everybody stays where they are until the test ends.
  static void let_pass(Crossing& crossing) {
    while (!crossing.finished()) tick(crossing, {});
  }

  /// An agent's percepts, as the arguments of each predicate's last literal.
  std::map<std::string, std::vector<double>> percepts(const Crossing& crossing, int agent) const {
    Percepts percepts;
    crossing.perceive(static_cast<AgentId>(agent), percepts);
    std::map<std::string, std::vector<double>> result;
    for (std::size_t i = 0; i < percepts.size(); ++i) {
      std::vector<double>& args = result[std::string(symbols_.functor(percepts.predicate(i)))];
      args.clear();
      for (const Value value : percepts.args(i)) {
        if (value.is_number()) args.push_back(value.as_number());
      }
    }
    return result;
  }

  SymbolTable symbols_;
  CrossingVocabulary vocabulary_{symbols_};
  CrossingParameters parameters_;
  std::vector<Value> ways_{vocabulary_.atom(Direction::left), vocabulary_.atom(Direction::right),
                           vocabulary_.atom(Direction::forward), vocabulary_.atom(Direction::back)};
};

// From (1,12): tick 1 stays, cost 1; tick 2 steps to (2,12), cost 5. The zone of tick 2 is cells 7
// to 12, so its last cell is hit. Score 100 - 1 - 5.
TEST_F(CrossingTest, SucceedsInTickTwoAtTheEarliest) {
  Crossing crossing = world({{1, 12}});
  tick(crossing, {});
  EXPECT_FALSE(crossing.finished());
  tick(crossing, {move(0, Direction::right)});
  EXPECT_TRUE(crossing.finished());
  EXPECT_TRUE(crossing.result().success);
  EXPECT_EQ(crossing.result().ticks, 2);
  EXPECT_EQ(crossing.result().hit_cell, 12);
  EXPECT_DOUBLE_EQ(crossing.result().score(), 94);
}

// One cell further on the same step comes a tick too early: the AV reaches cell 13 in tick 3. The
// pedestrian waits on the road: costs 1 + 5 + 5.
TEST_F(CrossingTest, DoesNotSeeAPedestrianBeyondTheZone) {
  Crossing crossing = world({{1, 13}});
  tick(crossing, {});
  tick(crossing, {move(0, Direction::right)});
  EXPECT_FALSE(crossing.finished());
  tick(crossing, {});
  EXPECT_EQ(crossing.result().ticks, 3);
  EXPECT_EQ(crossing.result().hit_cell, 13);
  EXPECT_DOUBLE_EQ(crossing.result().score(), 89);
}

// Nobody moves: 11 ticks on the pavement. f(10) = 60, f(11) = 66 is beyond 65.
TEST_F(CrossingTest, FailsInTickElevenWhenNobodyCrosses) {
  Crossing crossing = world({{0, 20}, {11, 60}});
  let_pass(crossing);
  EXPECT_FALSE(crossing.result().success);
  EXPECT_EQ(crossing.result().ticks, 11);
  EXPECT_EQ(crossing.result().hit_cell, std::nullopt);
  EXPECT_DOUBLE_EQ(crossing.result().score(), -11);
}

// Cell 65 is tested in tick 11, though the AV's way ends there; costs are ten on the pavement, one
// on the road.
TEST_F(CrossingTest, StillTestsTheLastCell) {
  Crossing crossing = world({{1, 65}});
  for (int i = 0; i < 10; ++i) tick(crossing, {});
  EXPECT_FALSE(crossing.finished());
  tick(crossing, {move(0, Direction::right)});
  EXPECT_TRUE(crossing.result().success);
  EXPECT_EQ(crossing.result().ticks, 11);
  EXPECT_DOUBLE_EQ(crossing.result().score(), 100 - 10 - 5);
}

TEST_F(CrossingTest, EndsWhereTheRoadEndsIfThatIsBeforeTheGrid) {
  parameters_.road_end = 60;
  Crossing at_the_end = world({{2, 60}});
  let_pass(at_the_end);
  EXPECT_TRUE(at_the_end.result().success);
  EXPECT_EQ(at_the_end.result().ticks, 10);
  Crossing beyond = world({{2, 61}});
  let_pass(beyond);
  EXPECT_FALSE(beyond.result().success);
  EXPECT_EQ(beyond.result().ticks, 10);
}

// All are in the zone of tick 1 (cells 1 to 6): two in cell 3, one in cell 4, one beside the lane.
// Scores: 95, 95, -5 and -1; their mean is 46.
TEST_F(CrossingTest, RewardsEverybodyInTheFirstCellHitAndNobodyElse) {
  Crossing crossing = world({{2, 3}, {5, 3}, {3, 4}, {1, 3}});
  tick(crossing, {});
  const CrossingResult& result = crossing.result();
  EXPECT_EQ(result.hit_cell, 3);
  EXPECT_EQ(result.met_by, (std::vector<std::size_t>{0, 1}));
  EXPECT_DOUBLE_EQ(result.agents[0].reward, 100);
  EXPECT_DOUBLE_EQ(result.agents[1].reward, 100);
  EXPECT_DOUBLE_EQ(result.agents[2].reward, 0);
  EXPECT_DOUBLE_EQ(result.agents[3].cost, 1);
  EXPECT_DOUBLE_EQ(result.score(), 46);
}

// The same test: now 95, 95, 95 and -1.
TEST_F(CrossingTest, RewardsTheWholeZoneWhenAsked) {
  parameters_.scoring.rewarded = Rewarded::zone;
  Crossing crossing = world({{2, 3}, {5, 3}, {3, 4}, {1, 3}});
  tick(crossing, {});
  EXPECT_DOUBLE_EQ(crossing.result().score(), (3 * 95 - 1) / 4.0);
}

// As SucceedsInTickTwoAtTheEarliest, in the draft's money: 20 - 1 - (1 + 7).
TEST_F(CrossingTest, AddsTheCostOfTheRoadWhenAsked) {
  parameters_.scoring = {1, 7, RoadCost::add, 20, Rewarded::first_hit};
  Crossing crossing = world({{1, 12}});
  tick(crossing, {});
  tick(crossing, {move(0, Direction::right)});
  EXPECT_DOUBLE_EQ(crossing.result().score(), 11);
}

TEST_F(CrossingTest, TestsTheRowsOfTheZoneOnly) {
  for (const int row : {1, 6}) {
    Crossing beside = world({{row, 3}});
    tick(beside, {});
    EXPECT_FALSE(beside.result().success) << row;
  }
  for (const int row : {2, 5}) {
    Crossing within = world({{row, 3}});
    tick(within, {});
    EXPECT_TRUE(within.result().success) << row;
  }
  parameters_.zone.rows = ZoneRows::av;
  Crossing beside_av = world({{2, 3}});
  tick(beside_av, {});
  EXPECT_FALSE(beside_av.result().success);
}

// The zone 9 to 14 ahead: in tick 1 cells 9 to 14, and what is nearer is not tested.
TEST_F(CrossingTest, MovesTheZoneAheadWhenAsked) {
  parameters_.zone.ahead = Interval{9, 14};
  for (const int cell : {8, 15}) {
    Crossing outside = world({{2, cell}});
    tick(outside, {});
    EXPECT_FALSE(outside.result().success) << cell;
  }
  for (const int cell : {9, 14}) {
    Crossing inside = world({{2, cell}});
    tick(inside, {});
    EXPECT_TRUE(inside.result().success) << cell;
  }
}

// Started 8 cells back and measured from the end of 8 cells of stopping distance: the same zone.
TEST_F(CrossingTest, MeasuresFromTheEndOfTheStoppingDistanceWhenAsked) {
  parameters_.av.start = -8;
  parameters_.av.stopping_distance = 8;
  parameters_.zone.origin = ZoneOrigin::stopping_distance;
  Crossing crossing = world({{2, 6}});
  EXPECT_EQ(crossing.av_edge(), -8);
  EXPECT_EQ(crossing.av_cell(), 0);
  tick(crossing, {});
  EXPECT_TRUE(crossing.result().success);
  EXPECT_EQ(crossing.av_edge(), -2);
}

TEST_F(CrossingTest, MovesEveryoneByOneStep) {
  Crossing crossing = world({{5, 30}, {5, 30}, {5, 30}, {5, 30}, {5, 30}});
  tick(crossing, {move(0, Direction::left),
                  move(1, Direction::right),
                  move(2, Direction::forward),
                  move(3, Direction::back),
                  {AgentId{4}, vocabulary_.stay(), {}}});
  const std::vector<Position> expected{{4, 30}, {6, 30}, {5, 31}, {5, 29}, {5, 30}};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), crossing.positions().begin()));
}

TEST_F(CrossingTest, FailsMovesThatLeaveTheGrid) {
  Crossing crossing = world({{0, 0}, {11, 65}});
  const std::vector<ActionResult> near_corner =
      tick(crossing, {move(0, Direction::left), move(1, Direction::right)});
  EXPECT_FALSE(near_corner[0].succeeded);
  EXPECT_EQ(near_corner[0].reason, "a step left from (0,0) leaves the grid");
  EXPECT_FALSE(near_corner[1].succeeded);
  const std::vector<ActionResult> far_corner =
      tick(crossing, {move(0, Direction::back), move(1, Direction::forward)});
  EXPECT_FALSE(far_corner[0].succeeded);
  EXPECT_FALSE(far_corner[1].succeeded);
  EXPECT_EQ(crossing.positions()[0], (Position{0, 0}));
}

TEST_F(CrossingTest, FailsWhatIsNotAnAction) {
  Crossing crossing = world({{5, 30}});
  const Value up = Value::atom(symbols_.predicate("up", 0));
  const Value two = Value::number(2);
  const std::vector<ActionResult> results =
      tick(crossing, {{AgentId{0}, symbols_.predicate("jump", 0), {}},
                      {AgentId{0}, vocabulary_.move(), {&up, 1}}});
  EXPECT_EQ(results[0].reason,
            "unknown action, expected move(Way), move(Way,Cells), stay or show(Colour)");
  EXPECT_EQ(results[1].reason, "unknown way to move, expected left, right, forward or back");
  EXPECT_FALSE(tick(crossing, {{AgentId{0}, vocabulary_.move(), {&two, 1}}})[0].succeeded);
  EXPECT_EQ(crossing.positions()[0], (Position{5, 30}));
}

TEST_F(CrossingTest, FailsASecondStepInATick) {
  Crossing crossing = world({{5, 30}});
  const std::vector<ActionResult> results =
      tick(crossing, {move(0, Direction::left), move(0, Direction::left)});
  EXPECT_TRUE(results[0].succeeded);
  EXPECT_EQ(results[1].reason, "a second step in the same tick");
  EXPECT_TRUE(tick(crossing, {move(0, Direction::left)})[0].succeeded);
}

TEST_F(CrossingTest, ShowsEachAgentTheStateBeforeTheTick) {
  Crossing crossing = world({{1, 30}, {10, 50}});
  tick(crossing, {move(1, Direction::left)});
  std::map<std::string, std::vector<double>> seen = percepts(crossing, 1);
  EXPECT_EQ(seen["tick"], (std::vector<double>{2}));
  EXPECT_EQ(seen["at"], (std::vector<double>{9, 50}));
  EXPECT_EQ(seen["av"], (std::vector<double>{6}));
  EXPECT_EQ(seen["id"], (std::vector<double>{2}));
  EXPECT_EQ(seen["pedestrians"], (std::vector<double>{2}));
  EXPECT_FALSE(seen.contains("precondition_met"));
}

TEST_F(CrossingTest, ShowsWhatTheWorldIsLike) {
  std::map<std::string, std::vector<double>> seen = percepts(world({{1, 30}}), 0);
  EXPECT_EQ(seen["grid"], (std::vector<double>{12, 66}));
  EXPECT_EQ(seen["pavement"], (std::vector<double>{10, 11}));
  EXPECT_EQ(seen["lane"], (std::vector<double>{6, 9}));
  EXPECT_EQ(seen["av_rows"], (std::vector<double>{3, 4}));
  EXPECT_EQ(seen["av_length"], (std::vector<double>{3}));
  EXPECT_EQ(seen["av_speed"], (std::vector<double>{6}));
  EXPECT_EQ(seen["zone_rows"], (std::vector<double>{2, 5}));
  EXPECT_EQ(seen["zone_ahead"], (std::vector<double>{1, 6}));
  EXPECT_EQ(seen["road_end"], (std::vector<double>{65}));
  EXPECT_EQ(seen["tick_length"], (std::vector<double>{1}));
  EXPECT_EQ(seen["cell_length"], (std::vector<double>{1.5}));
}

// With an aftermath of one tick all agents learn which one met the precondition, and no more costs
// are charged.
TEST_F(CrossingTest, ReportsThePreconditionToTheAgentsInTheAftermath) {
  parameters_.aftermath = 1;
  Crossing crossing = world({{1, 30}, {2, 3}});
  tick(crossing, {});
  EXPECT_FALSE(crossing.finished());
  EXPECT_EQ(percepts(crossing, 0)["precondition_met"], (std::vector<double>{2}));
  tick(crossing, {});
  EXPECT_TRUE(crossing.finished());
  EXPECT_EQ(crossing.result().ticks, 1);
  EXPECT_DOUBLE_EQ(crossing.result().agents[1].cost, 5);
}

// A hit in the last cell of the sweep leaves no cells of the tick over; one two cells earlier
// leaves two.
TEST_F(CrossingTest, LeavesOverWhatTheAvHasNotDrivenOfTheLastTick) {
  parameters_.av.carry_over = true;
  for (const auto& [cell, left] : {std::pair{12, 0}, {10, 2}, {7, 5}}) {
    Crossing crossing = world({{1, cell}});
    tick(crossing, {});
    tick(crossing, {move(0, Direction::right)});
    ASSERT_TRUE(crossing.result().success) << cell;
    EXPECT_EQ(crossing.left_over(), left) << cell;
  }
}

// The road ends in the fifth of the six cells of tick 11. A head start moves that forward; with
// five cells the tenth tick ends just there.
TEST_F(CrossingTest, LeavesOverWhatIsBeyondTheRoadsEnd) {
  parameters_.av.carry_over = true;
  int head_start = 0;
  for (const int left : {1, 2, 3, 4, 5, 0}) {
    Crossing crossing = world({{0, 0}}, head_start);
    EXPECT_EQ(crossing.av_cell(), head_start);
    EXPECT_EQ(crossing.av_edge(), head_start);
    EXPECT_EQ(crossing.zone_cells(), (Interval{head_start + 1, head_start + 6}));
    EXPECT_EQ(percepts(crossing, 0)["av"], std::vector<double>{static_cast<double>(head_start)});
    let_pass(crossing);
    EXPECT_EQ(crossing.result().ticks, head_start == 5 ? 10 : 11);
    EXPECT_EQ(crossing.left_over(), left);
    head_start = crossing.left_over();
  }
}

TEST_F(CrossingTest, LeavesNothingOverUnlessItIsAskedTo) {
  Crossing crossing = world({{0, 0}});
  let_pass(crossing);
  EXPECT_EQ(crossing.left_over(), 0);
}

TEST_F(CrossingTest, VehiclesLeaveAtTheEndOfTheRoadAndPedestriansDoNot) {
  parameters_.end = TestEnd::road;
  parameters_.av.vehicle.range_m = 30;  // 20 cells
  parameters_.actors.push_back({.name = "car",
                                .kind = ActorKind::vehicle,
                                .start = {7, 3},
                                .way = Direction::back,
                                .speed = 5,
                                .crosswalk = 0});
  Crossing crossing = world({{0, 64}});
  const RoadUser& car = crossing.bodies()[1];
  EXPECT_TRUE(tick(crossing, {move(1, Direction::back)})[0].succeeded);
  EXPECT_EQ(car.place.y, -2);
  EXPECT_TRUE(tick(crossing, {move(0, Direction::forward)})[0].succeeded);
  EXPECT_EQ(car.place.y, -7) << "it drives on without its agent";
  EXPECT_EQ(crossing.scene()[2].speed_mps, 7.5);
  const std::vector<ActionResult> refused =
      tick(crossing, {move(0, Direction::forward), move(1, Direction::back)});
  EXPECT_EQ(refused[0].reason, "a step forward from (0,65) leaves the grid");
  EXPECT_EQ(refused[1].reason, "it has left the road");
  let_pass(crossing);
  EXPECT_EQ(car.place.y, -22) << "and stays where nobody sees it";
  EXPECT_EQ(crossing.scene()[2].speed_mps, 0);
}

// Each world is one in which the percepts of one need exist, or of none. One pedestrian stands in
// the zone beside the AV's way, the other in its way.
TEST_F(CrossingTest, GivesThePerceptsThatTheirNeedsSay) {
  const CrossingParameters bare;
  CrossingParameters zebra = bare;
  zebra.crosswalks = {{CrosswalkKind::zebra, {30, 32}}};
  CrossingParameters signalled = bare;
  signalled.crosswalks = {{CrosswalkKind::signalled, {30, 32}}};
  CrossingParameters parked = bare;
  parked.obstacles = {{.rows = {2, 2}, .cells = {13, 16}}};
  CrossingParameters sight = bare;
  sight.pedestrians.sight = 50;
  CrossingParameters features = bare;
  features.pedestrians.features = true;
  CrossingParameters aftermath = bare;
  aftermath.aftermath = 3;
  CrossingParameters until_collision = bare;
  until_collision.end = TestEnd::collision;
  CrossingParameters until_road_end = bare;
  until_road_end.end = TestEnd::road;
  std::set<std::string_view> seen_somewhere;
  for (const CrossingParameters& parameters : {bare, zebra, signalled, parked, sight, features,
                                               aftermath, until_collision, until_road_end}) {
    parameters_ = parameters;
    Crossing crossing = world({{2, 12}, {3, 40}});
    std::set<std::string> seen;
    while (!crossing.finished()) {
      for (const auto& [name, args] : percepts(crossing, 0)) seen.insert(name);
      tick(crossing, {});
    }
    const auto given = given_percepts(parameters);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::string_view name = functor(kCrossingPercepts[i]);
      const bool is_seen = seen.contains(std::string(name));
      // Where the precondition ends the test, no contact comes before.
      if (name != "collision" || parameters.end != TestEnd::precondition) {
        EXPECT_EQ(is_seen, given[i]) << name;
      }
      if (is_seen) seen_somewhere.insert(name);
    }
  }
  EXPECT_EQ(seen_somewhere.size(), kCrossingPercepts.size());
}

}  // namespace
}  // namespace jaywalk
