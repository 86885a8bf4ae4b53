// SPDX-License-Identifier: Apache-2.0
// What SUMO is given, and which settings it takes; SUMO itself is not started.

#include "env/simulator/sumo/sumo_network.h"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/simulator/simulator.h"
#include "env/simulator/sumo/sumo_map.h"
#include "env/simulator/sumo/sumo_process.h"
#include "tests/unit/env/sumo_street.h"

namespace jaywalk {
namespace {

constexpr double kForwardRad = std::numbers::pi / 2;

// Which lane is outermost depends on the side of traffic and the direction of the edge.
TEST(SumoNetwork, HasLanesFromTheOuterSideOnEitherSideOfTraffic) {
  SimulatedRoad road = street();
  road.bands.insert(road.bands.begin() + 1, {AreaKind::lane, 2, 3, false});
  const SumoNetworkPlan left = plan_sumo_network(road, -10, 100);
  EXPECT_TRUE(left.left_hand);
  ASSERT_EQ(left.lanes.size(), 3U);
  EXPECT_EQ(left.lanes[0].edges, left.lanes[1].edges);
  EXPECT_EQ(left.lanes[0].index, 0);
  EXPECT_EQ(left.lanes[1].index, 1);
  for (RoadBand& band : road.bands) band.oncoming = !band.oncoming;
  const SumoNetworkPlan right = plan_sumo_network(road, -10, 100);
  EXPECT_FALSE(right.left_hand);
  EXPECT_EQ(right.lanes[0].index, 0);
  EXPECT_TRUE(right.lanes[0].oncoming);
}

SimulatedRoad with_crosswalk(SimulatedRoad road, bool zebra, double begins_m) {
  road.ground.crosswalks.push_back(
      {zebra, {{3, 15, begins_m, begins_m + 4.5}}, begins_m, {"light"}});
  return road;
}

TEST(SumoNetwork, HasALightBeforeEachSignalledCrosswalkFromEitherSide) {
  const SumoNetworkPlan plan = plan_sumo_network(with_crosswalk(street(), false, 30), -10, 100);
  ASSERT_EQ(plan.lights.size(), 2U);
  ASSERT_EQ(plan.lanes.size(), 2U);
  EXPECT_EQ(plan.lanes[0].edges.size(), 2U);
  EXPECT_THAT(plan.lanes[0].begins_m, testing::ElementsAre(0, 40 + kLightM));
  EXPECT_THAT(plan.lanes[1].begins_m, testing::ElementsAre(0, 100 - 34.5 + kLightM));
  EXPECT_THAT(plan.lights[0].crosswalks, testing::ElementsAre(0));
  EXPECT_EQ(plan.lights[0].lanes, 1U);
}

// What SUMO draws depends on its network to the last byte.
TEST(SumoNetwork, HasNothingOfLightsWithoutSignals) {
  SimulatedRoad road = with_crosswalk(street(), true, 30);
  road.bands.erase(road.bands.begin());
  road.bands.erase(road.bands.begin() + 1);
  const SumoNetworkPlan plan = plan_sumo_network(road, -10, 100);
  EXPECT_TRUE(plan.lights.empty());
  EXPECT_EQ(plan.nodes,
            "<nodes>\n"
            "<node id=\"road1a\" x=\"6\" y=\"-10\"/>\n<node id=\"road1b\" x=\"6\" y=\"100\"/>\n"
            "<node id=\"pavement2a\" x=\"16.5\" y=\"-10\"/>\n"
            "<node id=\"pavement2b\" x=\"16.5\" y=\"100\"/>\n</nodes>\n");
  EXPECT_EQ(plan.edges,
            "<edges>\n"
            "<edge id=\"road1\" from=\"road1a\" to=\"road1b\" numLanes=\"1\" speed=\"100\" "
            "spreadType=\"center\">\n<lane index=\"0\" width=\"6\" disallow=\"pedestrian\"/>\n"
            "</edge>\n"
            "<edge id=\"pavement2\" from=\"pavement2a\" to=\"pavement2b\" numLanes=\"1\" "
            "speed=\"100\" spreadType=\"center\">\n"
            "<lane index=\"0\" width=\"3\" allow=\"pedestrian\"/>\n</edge>\n</edges>\n");
}

TEST(SumoNetwork, HasOneLightForCrosswalksThatBeginTogether) {
  SimulatedRoad road = with_crosswalk(street(), false, 60);
  road = with_crosswalk(std::move(road), false, 30);
  road = with_crosswalk(std::move(road), false, 30.5);
  const SumoNetworkPlan plan = plan_sumo_network(road, -10, 100);
  ASSERT_EQ(plan.lights.size(), 4U);
  EXPECT_THAT(plan.lights[0].crosswalks, testing::ElementsAre(1, 2));
  EXPECT_THAT(plan.lights[1].crosswalks, testing::ElementsAre(0));
  EXPECT_THAT(plan.lanes[0].begins_m, testing::ElementsAre(0, 40 + kLightM, 70 + kLightM));
}

TEST(SumoWay, HasItsPlacesOnItsEdges) {
  const SumoWay way{.edges = {"a", "b"}, .begins_m = {0, 40 + kLightM}};
  const auto place = [&](double position_m) {
    const WayPlace found = place_on(way, position_m);
    return std::pair(found.edge, found.along_m);
  };
  EXPECT_EQ(place(-3), std::pair(std::size_t{0}, -3.0));
  EXPECT_EQ(place(40), std::pair(std::size_t{0}, 40.0));
  EXPECT_EQ(place(40 + kLightM / 2).first, 0U);
  EXPECT_NEAR(place(40 + kLightM / 2).second, 40, 1e-9);
  EXPECT_EQ(place(50).first, 1U);
  EXPECT_NEAR(place(50).second, 10 - kLightM, 1e-9);
  EXPECT_EQ(place_on({.edges = {"a"}, .begins_m = {}}, 7).along_m, 7);
}

TEST(RoadFrame, LaysTheRoadAlongALine) {
  // East for 100 m, then north.
  const RoadFrame frame({{0, 0}, {100, 0}, {100, 100}}, 20, 6);
  const RoadFrame::Pose east = frame.to_map({.x_m = 8, .y_m = 30, .heading_rad = kForwardRad});
  EXPECT_NEAR(east.x_m, 50, 1e-9);
  EXPECT_NEAR(east.y_m, -2, 1e-9);  // two metres to the right of the line
  EXPECT_NEAR(east.heading_rad, 0, 1e-9);
  const RoadFrame::Pose north = frame.to_map({.x_m = 6, .y_m = 130, .heading_rad = kForwardRad});
  EXPECT_NEAR(north.x_m, 100, 1e-9);
  EXPECT_NEAR(north.y_m, 50, 1e-9);
  EXPECT_NEAR(north.heading_rad, kForwardRad, 1e-9);
}

TEST(RoadFrame, FindsWhatItHasPut) {
  const RoadFrame frame({{0, 0}, {100, 0}, {100, 100}}, 20, 6);
  for (const RoadFrame::Pose world : {RoadFrame::Pose{3, -40, 0}, RoadFrame::Pose{9, 50, 1},
                                      RoadFrame::Pose{8, 110, 2}, RoadFrame::Pose{1, 400, 3}}) {
    const RoadFrame::Pose again = frame.to_world(frame.to_map(world));
    EXPECT_NEAR(again.x_m, world.x_m, 1e-9);
    EXPECT_NEAR(again.y_m, world.y_m, 1e-9);
    EXPECT_NEAR(again.heading_rad, world.heading_rad, 1e-9);
  }
}

TEST(SumoSettings, AreCheckedWhereTheirTableCannot) {
  SimulatorParameters parameters;
  parameters.settings["route"] = text("a b");
  SettingValue flows;
  flows.maps = {{{"every", "0"}, {"sped", "9"}}, {{"model", "Kraus"}, {"lane", "1"}}};
  parameters.settings["traffic"] = flows;
  std::string said;
  for (const SettingProblem& each : check_sumo(parameters, nullptr)) said += each.message + '\n';
  EXPECT_EQ(said,
            "'route' is of a map, 'net'\n"
            "'every' of a flow is a number from 0.5 to 3600\n"
            "unknown key 'sped' of a flow\n"
            "unknown model 'Kraus' of a flow\n");
}

TEST(Sumo, IsNamedByItsPackageWhereItIsMissing) {
  const std::string problem = run_sumo_tool({"jaywalk_no_such_program"});
  EXPECT_NE(problem.find("jaywalk_no_such_program"), std::string::npos);
  EXPECT_NE(problem.find("Debian package 'sumo'"), std::string::npos);
}

/// What SUMO cannot simulate of a street on which the AV drives from 4.5 to 7.5 m; no more than one
/// thing each time.
std::string unfit(const SimulatorParameters& parameters, SimulatedRoad road) {
  const SimulatedSite site{.road = std::move(road),
                           .av = {"av", ActorKind::vehicle, 4.5, 3},
                           .av_start = {.x_m = 6},
                           .vehicle = {}};
  std::string said;
  for (const SettingProblem& each : check_sumo(parameters, &site)) {
    said += fmt::format("{}{}: {}\n", each.of_world ? "world." : "", each.key, each.message);
  }
  return said;
}

TEST(Sumo, RefusesWhatItsVehiclesWouldNotSee) {
  SimulatorParameters parameters{.name = "sumo", .settings = {}};
  EXPECT_EQ(unfit(parameters, street()), "");
  SimulatedRoad road = street();
  road.ground.crosswalks.push_back({.zebra = false, .parts = {}, .begins_m = 30, .signals = {}});
  EXPECT_EQ(unfit(parameters, road), "") << "its network has a light there";
  parameters.settings["net"] = text("town.xml");
  parameters.settings["route"] = text("in up");
  EXPECT_EQ(unfit(parameters, road),
            "world.crosswalks: on a given map SUMO's vehicles see the map's signals alone\n");
  parameters.settings.clear();
  road.ground.crosswalks.front().zebra = true;
  EXPECT_EQ(unfit(parameters, road), "");
  road.ground.obstacles = {{3, 4.5, 40, 45}, {9, 10.5, 40, 45}};
  EXPECT_EQ(unfit(parameters, road), "") << "beside where the AV drives";
  road.ground.obstacles = {{6, 7.5, 40, 45}};
  EXPECT_EQ(unfit(parameters, road),
            "world.obstacles: SUMO's vehicles would drive through the obstacle at 40 m\n");
}

TEST(Sumo, RefusesTicksThatAreNoWholeMilliseconds) {
  const SimulatorParameters parameters{.name = "sumo", .settings = {}};
  const SimulatedSite site{.road = street(),
                           .av = {"av", ActorKind::vehicle, 4.5, 3},
                           .av_start = {.x_m = 6},
                           .vehicle = {},
                           .tick_s = 0.0505};
  const auto problems = check_sumo(parameters, &site);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().key, "tick");
}

TEST(Sumo, RefusesRoadsThatAreNoNetwork) {
  SimulatorParameters parameters{.name = "sumo", .settings = {}};
  SimulatedRoad road = street();
  road.bands.clear();
  EXPECT_THAT(unfit(parameters, road), testing::StartsWith("world.map: "));
  road = street();
  road.bands[1].oncoming = true;
  EXPECT_THAT(unfit(parameters, road), testing::StartsWith("world.av.rows: "));
  SettingValue flows;
  flows.maps = {{{"lane", "3"}}};
  parameters.settings["traffic"] = flows;
  EXPECT_EQ(unfit(parameters, street()), "traffic: a flow has lane 3, but there are only 2\n");
  flows.maps = {{{"lane", "2"}}};
  parameters.settings["traffic"] = flows;
  road = street();
  road.ground.obstacles = {{11, 12, 20, 25}};
  EXPECT_THAT(unfit(parameters, road), testing::StartsWith("world.obstacles: "));
}

}  // namespace
}  // namespace jaywalk
