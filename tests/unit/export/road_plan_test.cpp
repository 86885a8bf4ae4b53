// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/openscenario/road_plan.h"

#include <numbers>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/export/crossings.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RoadPlan, OfBandsIsOneRoadWithALaneForEach) {
  const RoadPlan plan = plan_roads({});
  EXPECT_DOUBLE_EQ(plan.width_m, 18);
  EXPECT_DOUBLE_EQ(plan.length_m, 99);
  ASSERT_EQ(plan.roads.size(), 1U);
  const PlannedRoad& road = plan.roads[0];
  EXPECT_EQ(road.name, "road");
  EXPECT_EQ(road.id, 1);
  EXPECT_DOUBLE_EQ(road.length_m, 99);
  EXPECT_DOUBLE_EQ(road.heading_rad, std::numbers::pi / 2);
  ASSERT_EQ(road.lanes.size(), 4U);
  EXPECT_EQ(road.lanes[0].type, LaneType::sidewalk);
  EXPECT_DOUBLE_EQ(road.lanes[0].width_m, 3);
  EXPECT_EQ(road.lanes[1].type, LaneType::driving);
  EXPECT_TRUE(road.lanes[1].forward);
  EXPECT_DOUBLE_EQ(road.lanes[2].width_m, 6);
  EXPECT_FALSE(road.lanes[2].forward);
  EXPECT_FALSE(road.from || road.to);
  EXPECT_THAT(plan.junctions, IsEmpty());
  EXPECT_THAT(plan.unsaid, IsEmpty());
}

TEST(RoadPlan, PutsTheReferenceLineBetweenTheDirections) {
  const PlannedRoad road = plan_roads({}).roads[0];
  EXPECT_EQ(road.left, 2U);
  EXPECT_DOUBLE_EQ(road.x_m, 9) << "pavement and forward lane lie to its left";
  EXPECT_DOUBLE_EQ(road.y_m, 0);
}

TEST(RoadPlan, PutsTheReferenceLineAtTheFarLeftWhereNobodyDrivesForward) {
  CrossingParameters world;
  world.bands = {{BandKind::pavement, 2}, {BandKind::lane, 4, Direction::back}};
  const PlannedRoad road = plan_roads(world).roads[0];
  EXPECT_EQ(road.left, 0U);
  EXPECT_DOUBLE_EQ(road.x_m, 0);
}

TEST(LaneId, CountsAwayFromTheReferenceLineAndHasNoZero) {
  const PlannedRoad road = plan_roads({}).roads[0];
  EXPECT_EQ(lane_id(road, 0), 2);
  EXPECT_EQ(lane_id(road, 1), 1);
  EXPECT_EQ(lane_id(road, 2), -1);
  EXPECT_EQ(lane_id(road, 3), -2);
}

TEST(LaneId, OfARoadWithoutALeftSideIsNegative) {
  PlannedRoad road;
  road.lanes.resize(2);
  EXPECT_EQ(lane_id(road, 0), -1);
  EXPECT_EQ(lane_id(road, 1), -2);
}

TEST(RoadPlan, LaysACrosswalkOverAllLanesAndNoPavement) {
  const RoadPlan plan = plan_roads(crosswalk_world(CrosswalkKind::zebra, {20, 22}));
  ASSERT_EQ(plan.roads[0].objects.size(), 1U);
  const PlannedObject& zebra = plan.roads[0].objects[0];
  EXPECT_EQ(zebra.type, ObjectType::crosswalk);
  EXPECT_EQ(zebra.name, "crosswalk1");
  EXPECT_EQ(zebra.rows, (Interval{2, 9}));
  EXPECT_EQ(zebra.cells, (Interval{20, 22}));
  EXPECT_THAT(plan.signals, IsEmpty()) << "a zebra has no lights";
}

TEST(RoadPlan, HasALightForEachDirectionBeforeASignalledCrosswalk) {
  const RoadPlan plan = plan_roads(crosswalk_world(CrosswalkKind::signalled, {20, 22}));
  const std::vector<PlannedSignal>& lights = plan.roads[0].signals;
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_TRUE(lights[0].forward);
  EXPECT_DOUBLE_EQ(lights[0].s_m, 30) << "where those meet it who drive forward";
  EXPECT_DOUBLE_EQ(lights[0].t_m, 6) << "at the left of the lanes";
  EXPECT_FALSE(lights[1].forward);
  EXPECT_DOUBLE_EQ(lights[1].s_m, 34.5);
  EXPECT_DOUBLE_EQ(lights[1].t_m, -6);
  ASSERT_EQ(plan.signals.size(), 1U);
  EXPECT_EQ(plan.signals[0].name, "signal1");
  EXPECT_THAT(plan.signals[0].signals, ElementsAre(lights[0].id, lights[1].id));
}

TEST(RoadPlan, HasNoLightForADirectionThatNobodyDrives) {
  CrossingParameters world = crosswalk_world(CrosswalkKind::signalled, {20, 22});
  world.bands = {{BandKind::pavement, 2}, {BandKind::lane, 4, Direction::forward}};
  const RoadPlan plan = plan_roads(world);
  ASSERT_EQ(plan.roads[0].signals.size(), 1U);
  EXPECT_TRUE(plan.roads[0].signals[0].forward);
}

TEST(RoadPlan, CallsLightsAsTheAgentIsCalledThatSwitchesThem) {
  CrossingParameters world = crosswalk_world(CrosswalkKind::signalled, {20, 22});
  world.crosswalks.push_back({CrosswalkKind::signalled, {40, 41}});
  world.actors = {{.name = "lamp", .kind = ActorKind::signal, .crosswalk = 1}};
  const RoadPlan plan = plan_roads(world);
  ASSERT_EQ(plan.signals.size(), 2U);
  EXPECT_EQ(plan.signals[0].name, "signal1");
  EXPECT_EQ(plan.signals[1].name, "lamp");
}

TEST(RoadPlan, GivesEachLightANumberOfItsOwn) {
  CrossingParameters world;
  for (int i = 0; i < 4; ++i) {
    world.crosswalks.push_back({CrosswalkKind::signalled, {10 * i + 5, 10 * i + 6}});
  }
  const RoadPlan plan = plan_roads(world);
  std::set<int> ids;
  for (const PlannedSignal& light : plan.roads[0].signals) ids.insert(light.id);
  EXPECT_EQ(ids.size(), 8U);
}

TEST(RoadPlan, KeepsLightsOnTheRoadWhereTheCrosswalkEndsIt) {
  const RoadPlan plan = plan_roads(crosswalk_world(CrosswalkKind::signalled, {64, 70}));
  EXPECT_DOUBLE_EQ(plan.roads[0].signals[1].s_m, 99);
}

TEST(RoadPlan, PutsObstaclesWhereTheyStand) {
  CrossingParameters world;
  world.obstacles = {{{0, 1}, {3, 5}}, {{10, 11}, {7, 7}}};
  const std::vector<PlannedObject> objects = plan_roads(world).roads[0].objects;
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "obstacle1");
  EXPECT_EQ(objects[1].name, "obstacle2");
  EXPECT_EQ(objects[1].type, ObjectType::obstacle);
  EXPECT_EQ(objects[1].cells, (Interval{7, 7}));
}

TEST(RoadPlan, SaysThatACrosswalkHasNoLaneToCross) {
  CrossingParameters world = crosswalk_world(CrosswalkKind::zebra, {2, 3});
  world.bands = {{BandKind::pavement, 4}};
  EXPECT_THAT(plan_roads(world).unsaid, ElementsAre("crosswalk1 has no lane to cross"));
}

TEST(JunctionPlan, CutsTheRoadInTwoAndAddsASideRoadOnEitherSide) {
  const RoadPlan plan = plan_roads(junction_world());
  ASSERT_EQ(plan.roads.size(), 4U);
  ASSERT_EQ(plan.junctions.size(), 1U);
  const int junction = plan.junctions[0].id;
  EXPECT_DOUBLE_EQ(plan.roads[0].length_m, 8);
  EXPECT_EQ(plan.roads[0].to, junction);
  EXPECT_EQ(plan.roads[0].from, std::nullopt);
  EXPECT_DOUBLE_EQ(plan.roads[1].y_m, 12) << "after the two cells of the junction";
  EXPECT_DOUBLE_EQ(plan.roads[1].length_m, 8);
  EXPECT_EQ(plan.roads[1].from, junction);
  EXPECT_EQ(plan.roads[2].to, junction) << "the AV's left leads into it";
  EXPECT_EQ(plan.roads[3].from, junction);
  EXPECT_DOUBLE_EQ(plan.roads[2].length_m, 4);
  EXPECT_DOUBLE_EQ(plan.roads[2].heading_rad, 0);
  EXPECT_DOUBLE_EQ(plan.roads[3].x_m, 8);
  EXPECT_THAT(plan.unsaid, IsEmpty());
}

TEST(JunctionPlan, GivesSideRoadsThePavementsThatBuildingsEnd) {
  const PlannedRoad side = plan_roads(junction_world()).roads[2];
  ASSERT_EQ(side.lanes.size(), 4U);
  EXPECT_EQ(side.lanes[0].type, LaneType::sidewalk);
  EXPECT_EQ(side.lanes[1].type, LaneType::driving);
  EXPECT_TRUE(side.lanes[1].forward) << "of the further cell, to the left of its way";
  EXPECT_FALSE(side.lanes[2].forward);
  EXPECT_EQ(side.lanes[3].type, LaneType::sidewalk);
}

TEST(JunctionPlan, JoinsEachLaneThatArrivesWithThoseOfTheOtherRoadsThatLeave) {
  const RoadPlan plan = plan_roads(junction_world());
  std::set<std::pair<int, int>> ways;
  std::set<int> ids;
  for (const Connection& each : plan.junctions[0].connections) {
    EXPECT_NE(each.from.road, each.to.road) << "nobody turns round";
    ways.insert({each.from.road, each.to.road});
    ids.insert(each.road);
  }
  EXPECT_EQ(ways.size(), 12U) << "from each of four roads to the three others";
  EXPECT_EQ(ids.size(), plan.junctions[0].connections.size());
}

TEST(JunctionPlan, EndsConnectionsInTheMiddleOfLanes) {
  const RoadPlan plan = plan_roads(junction_world());
  bool found = false;
  for (const Connection& each : plan.junctions[0].connections) {
    if (each.from.road != 1 || each.to.road != 2) continue;
    found = true;
    EXPECT_TRUE(each.from.at_end);
    EXPECT_EQ(each.from.lane, 1);
    EXPECT_DOUBLE_EQ(each.from.x_m, 5) << "the middle of row 2";
    EXPECT_DOUBLE_EQ(each.from.y_m, 8);
    EXPECT_DOUBLE_EQ(each.from.width_m, 2);
  }
  EXPECT_TRUE(found);
}

TEST(JunctionPlan, MakesBuildingsOfBlockedCells) {
  const RoadPlan plan = plan_roads(junction_world());
  std::vector<std::pair<Interval, Interval>> buildings;
  for (const PlannedRoad& road : plan.roads) {
    for (const PlannedObject& each : road.objects) {
      EXPECT_EQ(each.type, ObjectType::building);
      buildings.emplace_back(each.rows, each.cells);
    }
  }
  EXPECT_THAT(buildings, testing::UnorderedElementsAre(std::pair(Interval{0, 0}, Interval{0, 2}),
                                                       std::pair(Interval{0, 0}, Interval{7, 9}),
                                                       std::pair(Interval{5, 5}, Interval{0, 2}),
                                                       std::pair(Interval{5, 5}, Interval{7, 9})));
}

TEST(JunctionPlan, JoinsBlockedCellsIntoRectangles) {
  CrossingParameters world = junction_world();
  world.map[1] = "###.<>.###";
  const RoadPlan plan = plan_roads(world);
  std::size_t of_two_rows = 0;
  for (const PlannedRoad& road : plan.roads) {
    for (const PlannedObject& each : road.objects) of_two_rows += each.rows == Interval{0, 1};
  }
  EXPECT_EQ(of_two_rows, 2U);
}

TEST(JunctionPlan, DropsAJunctionWithoutAWayThroughIt) {
  CrossingParameters world = junction_world();
  world.map = {"..........", "..........", ">>>>>>>>xx", "<<<<<<<<xx", "..........", ".........."};
  const RoadPlan plan = plan_roads(world);
  EXPECT_THAT(plan.junctions, IsEmpty());
  ASSERT_EQ(plan.roads.size(), 1U);
  EXPECT_EQ(plan.roads[0].to, std::nullopt);
  EXPECT_THAT(plan.unsaid, testing::Contains("a junction of the map has no way through it"));
}

TEST(JunctionPlan, SaysHowManyCellsOfTheMapTheRoadsLeaveOut) {
  CrossingParameters world = junction_world();
  world.map[1] = ".>..<>....";
  EXPECT_THAT(plan_roads(world).unsaid,
              ElementsAre(HasSubstr("1 cells of road are left out and 0 cells of pavement become "
                                    "road, the first in row 1, cell 1")));
}

TEST(JunctionPlan, SaysWhichPavementBecomesRoad) {
  CrossingParameters world = junction_world();
  world.map[3] = "<<<<xx<.<<";
  EXPECT_THAT(plan_roads(world).unsaid,
              ElementsAre(HasSubstr("0 cells of road are left out and 1 cells of pavement become "
                                    "road, the first in row 3, cell 7")));
}

}  // namespace
}  // namespace jaywalk
