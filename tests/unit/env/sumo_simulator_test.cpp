#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "env/simulator/simulators.h"
#include "env/simulator/sumo/sumo_process.h"
#include "env/simulator/sumo/traci_client.h"
#include "tests/unit/env/sumo_street.h"

namespace jaywalk {
namespace {

constexpr double kForwardRad = std::numbers::pi / 2;

/// Tests that need the program.
class WithSumo : public testing::Test {
 protected:
  void SetUp() override {
    std::string version;
    if (!sumo_version(version).empty()) GTEST_SKIP() << "the package 'sumo' is not installed";
  }

  /// The AV's fronts after each tick, with somebody who goes from row to row.
  struct Drive {
    std::vector<double> fronts_m;
    std::vector<double> speeds_mps;
    std::string error;
  };

  static SimulatorParameters with(const std::string& model) {
    SimulatorParameters parameters;
    parameters.name = "sumo";
    parameters.settings["model"] = text(model);
    return parameters;
  }

  static SimulatedTest test_of(std::uint64_t number, const SimulatedRoad& road,
                               const VehicleParameters& vehicle, std::span<const Actor> actors,
                               std::span<const ActorState> starts) {
    return {.test = number,
            .seed = 5,
            .behaviour = "walking",
            .agents = 1,
            .tick_s = 1,
            .road = road,
            .av = {"av", ActorKind::vehicle, 4.5, 3},
            .av_start = {.x_m = 6, .y_m = -0.75, .speed_mps = 9, .heading_rad = kForwardRad},
            .cruise_mps = 9,
            .vehicle = vehicle,
            .actors = actors,
            .starts = starts};
  }

  /// Somebody 60 m ahead begins to cross with the first tick after `waits`, up to `last_x_m`.
  static Drive drive(Simulator& simulator, double waits, double last_x_m, std::uint64_t number = 0,
                     std::vector<Rectangle> obstacles = {}) {
    SimulatedRoad road = street();
    road.ground.obstacles = std::move(obstacles);
    const VehicleParameters vehicle;
    const std::array actors{Actor{"p1", ActorKind::pedestrian, 0.5, 0.5}};
    const std::array starts{ActorState{.x_m = 1, .y_m = 60}};
    Drive drive;
    SimulatedStart start;
    drive.error = simulator.begin(test_of(number, road, vehicle, actors, starts), start);
    ActorState at = starts.front();
    for (std::uint64_t tick = 1; tick <= 11 && drive.error.empty(); ++tick) {
      ActorState next = at;
      next.x_m = std::clamp(1 + 1.5 * (static_cast<double>(tick) - waits), 1.0, last_x_m);
      const std::array bodies{SimulatedBody{0, at, next}};
      std::vector<SimulatedScene> scenes;
      drive.error = simulator.advance({.tick = tick,
                                       .begin_s = static_cast<double>(tick) - 1,
                                       .length_s = 1,
                                       .bodies = bodies,
                                       .signals = {}},
                                      scenes);
      if (!drive.error.empty()) break;
      EXPECT_EQ(scenes.size(), 10U);
      drive.fronts_m.push_back(scenes.back().av.state.y_m + 2.25);
      drive.speeds_mps.push_back(scenes.back().av.state.speed_mps);
      at = next;
    }
    (void)simulator.end({.why = "road_end", .impact_mps = {}});
    return drive;
  }
};

TEST_F(WithSumo, TheConstantAvDrivesAsThePapersDoes) {
  const auto simulator = make_sumo(with("constant"));
  const Drive drive = WithSumo::drive(*simulator, 0, 6);
  ASSERT_EQ(drive.error, "");
  for (std::size_t i = 0; i < drive.fronts_m.size(); ++i) {
    EXPECT_EQ(drive.fronts_m[i], 1.5 + 9 * static_cast<double>(i + 1));
    EXPECT_EQ(drive.speeds_mps[i], 9);
  }
}

TEST_F(WithSumo, OthersBrakeForWhoCrossesAndStopForWhoStands) {
  for (const std::string model : {"Krauss", "IDM", "EIDM", "ACC", "CACC"}) {
    const auto simulator = make_sumo(with(model));
    const Drive crossed = drive(*simulator, 3, 17);
    ASSERT_EQ(crossed.error, "") << model;
    EXPECT_LT(*std::ranges::min_element(crossed.speeds_mps), 3) << model;
    EXPECT_GT(crossed.fronts_m.back(), 60) << model;
    const Drive stood = drive(*simulator, 0, 6);
    ASSERT_EQ(stood.error, "") << model;
    EXPECT_LT(stood.fronts_m.back(), 60) << model;
    EXPECT_GT(stood.fronts_m.back(), 50) << model;
  }
}

TEST_F(WithSumo, NobodyBrakesForPedestriansOfWhomSumoIsNotTold) {
  SimulatorParameters parameters = with("Krauss");
  SettingValue no;
  no.number = 0;
  parameters.settings["brakes_for_pedestrians"] = no;
  const auto simulator = make_sumo(parameters);
  const Drive stood = drive(*simulator, 0, 6);
  ASSERT_EQ(stood.error, "");
  EXPECT_EQ(stood.fronts_m.back(), 1.5 + 9 * 11);
}

TEST_F(WithSumo, NobodyBrakesForWhomAnObstacleHidesFromTheAv) {
  const auto simulator = make_sumo(with("Krauss"));
  const std::vector<Rectangle> wall{{3, 9, 57, 59}};
  const Drive hidden = drive(*simulator, 0, 6, 0, wall);
  ASSERT_EQ(hidden.error, "");
  EXPECT_EQ(hidden.fronts_m[4], 1.5 + 9 * 5) << "they come into sight at 59 m, too late";
  EXPECT_GT(*std::ranges::max_element(hidden.fronts_m), 60);
  // Who crosses behind something is seen later.
  const Drive open = drive(*simulator, 2, 17);
  const Drive behind = drive(*simulator, 2, 17, 0, {{0.5, 7.5, 52, 57}});
  const auto brakes = [](const Drive& each) {
    return std::ranges::find_if(each.speeds_mps, [](double mps) { return mps < 8.9; }) -
           each.speeds_mps.begin();
  };
  EXPECT_LT(brakes(open), brakes(behind));
}

TEST_F(WithSumo, ATestIsTheSameWhateverCameBefore) {
  const auto used = make_sumo(with("Krauss"));
  (void)drive(*used, 0, 6, 1);
  (void)drive(*used, 2, 17, 2);
  const auto fresh = make_sumo(with("Krauss"));
  const Drive first = drive(*used, 3, 17, 7);
  const Drive second = drive(*fresh, 3, 17, 7);
  EXPECT_EQ(first.fronts_m, second.fronts_m);
  EXPECT_EQ(first.speeds_mps, second.speeds_mps);
}

TEST_F(WithSumo, TrafficIsOnTheRoadAndHoldsTheAvUp) {
  SimulatorParameters parameters = with("Krauss");
  SettingValue flows;
  flows.maps = {{{"lane", "1"}, {"every", "4"}, {"speed", "5"}},
                {{"lane", "2"}, {"every", "5"}, {"speed", "12"}, {"model", "IDM"}}};
  parameters.settings["traffic"] = flows;
  const auto simulator = make_sumo(parameters);
  const SimulatedRoad road = street();
  const VehicleParameters vehicle;
  SimulatedStart start;
  ASSERT_EQ(simulator->begin(test_of(0, road, vehicle, {}, {}), start), "");
  ASSERT_EQ(start.scene.traffic.size(), start.traffic.size());
  std::size_t present = 0;
  std::size_t oncoming = 0;
  for (const SimulatedVehicle& each : start.scene.traffic) {
    present += each.present;
    if (each.present && each.state.x_m > 9) {
      ++oncoming;
      EXPECT_NEAR(each.state.heading_rad, -kForwardRad, 1e-9);
      EXPECT_NEAR(each.state.x_m, 12, 1e-6);
    }
  }
  EXPECT_GT(present, oncoming);
  EXPECT_GT(oncoming, 3U);
  std::vector<SimulatedScene> scenes;
  double way_m = start.scene.av.state.y_m;
  for (std::uint64_t tick = 1; tick <= 12; ++tick) {
    ASSERT_EQ(simulator->advance({.tick = tick,
                                  .begin_s = static_cast<double>(tick) - 1,
                                  .length_s = 1,
                                  .bodies = {},
                                  .signals = {}},
                                 scenes),
              "");
  }
  way_m = scenes.back().av.state.y_m - way_m;
  EXPECT_LT(way_m, 100);
  EXPECT_NEAR(scenes.back().av.state.speed_mps, 5, 0.7);
}

TEST_F(WithSumo, OnAMapTheRoadLiesAlongTheAvsWay) {
  SimulatorParameters parameters = with("Krauss");
  parameters.settings["net"] = text(JAYWALK_SOURCE_DIR "/scenarios/maps/town.xml");
  parameters.settings["route"] = text("in up out");
  parameters.settings["begin"].number = 10;
  const auto simulator = make_sumo(parameters);
  const SimulatedRoad road = street();
  const VehicleParameters vehicle;
  const std::array actors{Actor{"p1", ActorKind::pedestrian, 0.5, 0.5}};
  const std::array starts{ActorState{.x_m = 1, .y_m = 60}};
  SimulatedStart start;
  ASSERT_EQ(simulator->begin(test_of(0, road, vehicle, actors, starts), start), "");
  EXPECT_NEAR(start.scene.av.state.y_m, -0.75, 0.01);
  std::vector<SimulatedScene> scenes;
  double before_m = -0.75;
  // Somebody stands in the AV's lane, behind the bend: for the world that is 90 m straight on.
  const std::array bodies{SimulatedBody{0, {.x_m = 6, .y_m = 95}, {.x_m = 6, .y_m = 95}}};
  for (std::uint64_t tick = 1; tick <= 16; ++tick) {
    ASSERT_EQ(simulator->advance({.tick = tick,
                                  .begin_s = static_cast<double>(tick) - 1,
                                  .length_s = 1,
                                  .bodies = bodies,
                                  .signals = {}},
                                 scenes),
              "");
    const ActorState& av = scenes.back().av.state;
    EXPECT_NEAR(av.x_m, 6, 0.6);  // it is no point: in a bend its middle is inside
    EXPECT_NEAR(av.heading_rad, kForwardRad, 0.5);
    EXPECT_GE(av.y_m, before_m);
    before_m = av.y_m;
  }
  EXPECT_LT(before_m, 95);
  EXPECT_GT(before_m, 85);
  EXPECT_NEAR(scenes.back().av.state.speed_mps, 0, 0.3);
}

TEST_F(WithSumo, DrivesOnAMapOfOpenStreetMap) {
  const std::string path = testing::TempDir() + "jaywalk_street.osm";
  std::ofstream(path) << R"(<?xml version="1.0"?><osm version="0.6">
<bounds minlat="51.0" minlon="-1" maxlat="51.01" maxlon="-0.99"/>
<node id="1" lat="51.001" lon="-0.999" version="1"/>
<node id="2" lat="51.003" lon="-0.997" version="1"/>
<node id="3" lat="51.004" lon="-0.993" version="1"/>
<way id="10" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/>
<tag k="highway" v="residential"/></way></osm>)";
  SimulatorParameters parameters = with("Krauss");
  parameters.settings["net"] = text(path);
  parameters.settings["route"] = text("10");
  parameters.settings["begin"].number = 150;
  const auto simulator = make_sumo(parameters);
  const Drive stood = drive(*simulator, 0, 6);
  ASSERT_EQ(stood.error, "");
  EXPECT_LT(stood.fronts_m.back(), 60);
  EXPECT_GT(stood.fronts_m.back(), 50);
  EXPECT_EQ(std::remove(path.c_str()), 0);
}

TEST_F(WithSumo, AMapWithoutTheRouteIsSaidToHaveNone) {
  SimulatorParameters parameters = with("Krauss");
  parameters.settings["net"] = text(JAYWALK_SOURCE_DIR "/scenarios/maps/town.xml");
  for (const auto& [route, said] : std::vector<std::pair<std::string, std::string>>{
           {"in away_back", "no lane of the edge 'in' leads through all edges of the route"},
           {"in up", "the route is"},
           {"nowhere up", "nowhere"}}) {
    parameters.settings["route"] = text(route);
    parameters.settings["begin"].number = 120;
    const auto simulator = make_sumo(parameters);
    const SimulatedRoad road = street();
    const VehicleParameters vehicle;
    SimulatedStart start;
    const std::string problem = simulator->begin(test_of(0, road, vehicle, {}, {}), start);
    EXPECT_NE(problem.find(said), std::string::npos) << problem;
  }
}

TEST_F(WithSumo, OneThatDiesCostsItsTestAlone) {
  SumoProcess sumo;
  EXPECT_NE(sumo.start({"--net-file", "/nowhere.net.xml"}, "none").find("nowhere"),
            std::string::npos);
  EXPECT_FALSE(sumo.is_running());
}

}  // namespace
}  // namespace jaywalk
