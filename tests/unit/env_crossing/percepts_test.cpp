// SPDX-License-Identifier: Apache-2.0
// Each percept of percepts.def: what it says and when. The rows of the case study are 0 and 1
// pavement, 2 to 5 the AV's lane, 6 to 9 the other one, 10 and 11 pavement.

#include "tests/helpers/constants.h"
#include "tests/unit/env_crossing/agents.h"

namespace jaywalk {
namespace {

class PerceptsOfTheCrossing : public CrossingAgents {};

TEST_F(PerceptsOfTheCrossing, CountTicksFromOne) {
  Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "tick"), "tick(1)");
  tick(crossing, {});
  EXPECT_EQ(seen(crossing, 0, "tick"), "tick(2)");
}

TEST_F(PerceptsOfTheCrossing, HaveOnesOwnPlaceInPartsOfCells) {
  Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "at"), "at(1,30)");
  tick(crossing, {move(0, Direction::forward, 0.25)});
  EXPECT_EQ(seen(crossing, 0, "at"), "at(1,30.25)");
}

TEST_F(PerceptsOfTheCrossing, HaveTheCellOfTheAv) {
  parameters_.av.start = -4;
  Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "av"), "av(-4)");
  tick(crossing, {});
  EXPECT_EQ(seen(crossing, 0, "av"), "av(2)");
}

TEST_F(PerceptsOfTheCrossing, HaveTheEndOfTheStoppingDistanceWhereThatCounts) {
  parameters_.av.stopping_distance = 8;
  parameters_.zone.origin = ZoneOrigin::stopping_distance;
  EXPECT_EQ(seen(world({{1, 30}}), 0, "av"), "av(8)");
}

TEST_F(PerceptsOfTheCrossing, SayWhoOneIsAmongHowMany) {
  const Crossing crossing = world({{1, 30}, {1, 31}, {10, 5}});
  EXPECT_EQ(seen(crossing, 2, "id"), "id(3)");
  EXPECT_EQ(seen(crossing, 2, "pedestrians"), "pedestrians(3)");
}

TEST_F(PerceptsOfTheCrossing, SayHowFarAStepLeads) {
  parameters_.pedestrians.speed = 0.75;
  parameters_.actors = {
      {.name = "rider", .kind = ActorKind::cyclist, .start = {7, 40}, .speed = 3}};
  const Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "walking_speed"), "walking_speed(0.75)");
  EXPECT_EQ(seen(crossing, 1, "walking_speed"), "walking_speed(3)");
}

TEST_F(PerceptsOfTheCrossing, HaveEachLaneWithItsWay) {
  const Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "lane"), "lane(2,5,forward) lane(6,9,back)");
  EXPECT_EQ(seen(crossing, 0, "pavement"), "pavement(0,1) pavement(10,11)");
  EXPECT_EQ(seen(crossing, 0, "grid"), "grid(12,66)");
}

TEST_F(PerceptsOfTheCrossing, HaveObstaclesWhereThereAreAny) {
  EXPECT_EQ(seen(world({{1, 30}}), 0, "obstacle"), "");
  parameters_.obstacles = {{{1, 1}, {20, 22}}, {{10, 11}, {40, 40}}};
  EXPECT_EQ(seen(world({{0, 30}}), 0, "obstacle"), "obstacle(1,1,20,22) obstacle(10,11,40,40)");
}

TEST_F(PerceptsOfTheCrossing, HaveTheWaysThatAreBlocked) {
  EXPECT_EQ(seen(world({{1, 20}}), 0, "blocked"), "");
  parameters_.obstacles = {{{1, 1}, {20, 22}}};
  parameters_.pedestrians.speed = 0.4;
  Crossing crossing = world({{0, 21}, {1, 19}, {0, 19}});
  EXPECT_EQ(seen(crossing, 0, "blocked"), "blocked(right)") << "the body would be 0.1 m in it";
  EXPECT_EQ(seen(crossing, 1, "blocked"), "blocked(forward)");
  EXPECT_EQ(seen(crossing, 2, "blocked"), "") << "not where the grid ends";
  tick(crossing,
       {move(0, Direction::right, 0.3), move(1, Direction::left), move(2, Direction::forward)});
  EXPECT_EQ(seen(crossing, 0, "blocked"), "blocked(right)");
  EXPECT_EQ(seen(crossing, 1, "blocked"), "blocked(forward)") << "at the corner";
  EXPECT_EQ(seen(crossing, 2, "blocked"), "blocked(right)");
}

TEST_F(PerceptsOfTheCrossing, HaveCrosswalksAndWhatTheirSignalsShow) {
  EXPECT_EQ(seen(world({{1, 30}}), 0, "crosswalk"), "");
  parameters_.crosswalks = {{CrosswalkKind::zebra, {10, 11}}, {CrosswalkKind::signalled, {40, 42}}};
  parameters_.actors = {{.name = "light", .kind = ActorKind::signal, .crosswalk = 1}};
  Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "crosswalk"),
            "crosswalk(1,10,11,zebra) crosswalk(2,40,42,signalled)");
  EXPECT_EQ(seen(crossing, 0, "signal"), "signal(2,green)") << "a zebra has none";
  tick(crossing, {show(1, SignalColour::red)});
  EXPECT_EQ(seen(crossing, 0, "signal"), "signal(2,red)");
}

TEST_F(PerceptsOfTheCrossing, HaveRoadUsersInSightAlone) {
  EXPECT_EQ(seen(world({{1, 30}, {1, 31}}), 0, "road_user"), "") << "sight is 0";
  parameters_.pedestrians.sight = 5;
  const Crossing crossing = world({{1, 30}, {1, 35}, {1, 36}, {5, 33}});
  EXPECT_EQ(seen(crossing, 0, "road_user"),
            "road_user(2,pedestrian,1,35,right,0) road_user(4,pedestrian,5,33,left,0)")
      << "5 cells away both, the third 6; before their first step they look towards the AV's way";
}

TEST_F(PerceptsOfTheCrossing, SayWhichWayRoadUsersWentAndHowFar) {
  parameters_.pedestrians.sight = 50;
  Crossing crossing = world({{1, 30}, {10, 35}});
  tick(crossing, {move(1, Direction::back, 0.5)});
  EXPECT_EQ(seen(crossing, 0, "road_user"), "road_user(2,pedestrian,10,34.5,back,0.5)");
  tick(crossing, {stay(1)});
  EXPECT_EQ(seen(crossing, 0, "road_user"), "road_user(2,pedestrian,10,34.5,back,0)");
}

TEST_F(PerceptsOfTheCrossing, HaveOtherKindsOfRoadUsersButNoSignals) {
  parameters_.pedestrians.sight = 50;
  parameters_.crosswalks = {{CrosswalkKind::signalled, {40, 42}}};
  parameters_.actors = {
      {.name = "rider", .kind = ActorKind::cyclist, .start = {7, 31}, .way = Direction::back},
      {.name = "light", .kind = ActorKind::signal}};
  EXPECT_EQ(seen(world({{1, 30}}), 0, "road_user"), "road_user(2,cyclist,7,31,back,0)");
}

TEST_F(PerceptsOfTheCrossing, HaveNoFeaturesUnlessTheseAreAskedFor) {
  const Crossing crossing = world({{1, 30}});
  for (const char* feature : {"ground_here", "ground", "kerb", "av_offset"}) {
    EXPECT_EQ(seen(crossing, 0, feature), "");
  }
}

TEST_F(PerceptsOfTheCrossing, HaveTheGroundAround) {
  parameters_.pedestrians.features = true;
  parameters_.crosswalks = {{CrosswalkKind::zebra, {40, 41}}};
  parameters_.obstacles = {{{1, 1}, {29, 29}}};
  const Crossing crossing = world({{1, 30}, {0, 0}, {2, 39}});
  EXPECT_EQ(seen(crossing, 0, "ground_here"), "ground_here(pavement)");
  EXPECT_EQ(seen(crossing, 0, "ground"),
            "ground(left,pavement) ground(right,lane) ground(forward,pavement) "
            "ground(back,blocked)");
  EXPECT_EQ(seen(crossing, 1, "ground"),
            "ground(left,blocked) ground(right,pavement) ground(forward,pavement) "
            "ground(back,blocked)")
      << "beyond the grid";
  EXPECT_EQ(seen(crossing, 2, "ground_here"), "ground_here(lane)");
  EXPECT_EQ(seen(crossing, 2, "ground"),
            "ground(left,pavement) ground(right,lane) ground(forward,crosswalk) ground(back,lane)");
}

TEST_F(PerceptsOfTheCrossing, CountTheCellsToTheRoadOnEitherSide) {
  parameters_.pedestrians.features = true;
  const Crossing crossing = world({{0, 30}, {1, 30}, {11, 30}, {4, 30}});
  EXPECT_EQ(seen(crossing, 0, "kerb"), "kerb(right,2)") << "there is none on its left";
  EXPECT_EQ(seen(crossing, 1, "kerb"), "kerb(right,1)");
  EXPECT_EQ(seen(crossing, 2, "kerb"), "kerb(left,2)");
  EXPECT_EQ(seen(crossing, 3, "kerb"), "kerb(left,0) kerb(right,0)") << "it is on the road";
}

TEST_F(PerceptsOfTheCrossing, MeasureTheWayToTheAv) {
  parameters_.pedestrians.features = true;
  Crossing crossing = world({{1, 8}});
  EXPECT_EQ(seen(crossing, 0, "av_offset"), "av_offset(-8)") << "av(Y) less the own cell";
  tick(crossing, {});
  EXPECT_EQ(seen(crossing, 0, "av_offset"), "av_offset(-2)");
  tick(crossing, {});
  EXPECT_EQ(seen(crossing, 0, "av_offset"), "av_offset(4)") << "it has passed";
}

TEST_F(PerceptsOfTheCrossing, HaveTheZoneAsItIsNow) {
  parameters_.zone.ahead = Interval{9, 14};
  parameters_.zone.rows = ZoneRows::av;
  const Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "zone_rows"), "zone_rows(3,4)");
  EXPECT_EQ(seen(crossing, 0, "zone_ahead"), "zone_ahead(9,14)");
  EXPECT_EQ(seen(crossing, 0, "av_rows"), "av_rows(3,4)");
  EXPECT_EQ(seen(crossing, 0, "av_speed"), "av_speed(6)");
}

TEST_F(PerceptsOfTheCrossing, SayThatThePreconditionWasMetIfTheTestGoesOn) {
  Crossing ends = world({{3, 4}});
  tick(ends, {});
  EXPECT_EQ(seen(ends, 0, "precondition_met"), "");
  parameters_.aftermath = 3;
  Crossing goes_on = world({{3, 4}, {3, 4}, {1, 30}});
  tick(goes_on, {});
  EXPECT_EQ(seen(goes_on, 2, "precondition_met"), "precondition_met(1) precondition_met(2)");
}

TEST_F(PerceptsOfTheCrossing, SayWhomTheAvHasTouched) {
  parameters_.end = TestEnd::road;
  Crossing crossing = world({{1, 30}, {3, 4}});
  EXPECT_EQ(seen(crossing, 0, "collision"), "");
  tick(crossing, {});
  EXPECT_EQ(seen(crossing, 0, "collision"), "collision(2)");
}

TEST_F(PerceptsOfTheCrossing, ArePerceivedByOtherActorsToo) {
  parameters_.actors = {{.name = "rider", .kind = ActorKind::cyclist, .start = {7, 40}}};
  const Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 1, "at"), "at(7,40)");
  EXPECT_EQ(seen(crossing, 1, "id"), "id(2)");
  EXPECT_EQ(seen(crossing, 1, "pedestrians"), "pedestrians(1)") << "it is none";
}

TEST_F(PerceptsOfTheCrossing, HaveTheirUnits) {
  parameters_.tick_s = 0.5;
  parameters_.cell_m = 0.75;
  const Crossing crossing = world({{1, 30}});
  EXPECT_EQ(seen(crossing, 0, "tick_length"), "tick_length(0.5)");
  EXPECT_EQ(seen(crossing, 0, "cell_length"), "cell_length(0.75)");
  EXPECT_EQ(seen(crossing, 0, "road_end"), "road_end(65)");
  EXPECT_EQ(seen(crossing, 0, "av_length"), "av_length(3)");
}

// With an AV that brakes, so that its speed and the zone change.
TEST_F(PerceptsOfTheCrossing, AreConstantWhereTheWorldSaysSo) {
  parameters_.pedestrians.sight = 50;
  parameters_.pedestrians.features = true;
  parameters_.av.vehicle.model = "braking";
  parameters_.obstacles = {{{1, 1}, {20, 22}}, {{10, 11}, {40, 40}}};
  parameters_.actors = {
      {.name = "rider", .kind = ActorKind::cyclist, .start = {7, 40}, .speed = 3}};
  Crossing crossing = world({{1, 30}, {10, 12}});
  const std::vector<std::string> said = test::constant_texts(crossing, symbols_);
  EXPECT_EQ(said.size(), 14U);
  bool has_braked = false;
  const std::string first_speed = seen(crossing, 0, "av_speed");
  while (!crossing.finished()) {
    EXPECT_EQ(test::constant_texts(crossing, symbols_), said);
    for (std::size_t agent = 0; agent < 3; ++agent) {
      EXPECT_EQ(test::perceived_constants(crossing, agent, symbols_), said) << agent;
    }
    has_braked = has_braked || seen(crossing, 0, "av_speed") != first_speed;
    tick(crossing, {move(0, Direction::right), move(1, Direction::left)});
  }
  EXPECT_TRUE(has_braked);
}

}  // namespace
}  // namespace jaywalk
