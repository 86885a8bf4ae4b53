// SPDX-License-Identifier: Apache-2.0
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

#include "env/simulator/simulator.h"
#include "env/simulator/sumo/sumo_network.h"
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

  /// The AV's fronts after each tick, with a pedestrian who goes from row to row.
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
  // A pedestrian who crosses behind an obstacle is seen later.
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

/// A street of two lanes and one that comes back, with a signalled crosswalk from 60 to 64.5 m.
class AtASignal : public WithSumo {
 protected:
  static SimulatedRoad signalled_street() {
    SimulatedRoad road = street();
    road.bands[2].right_m = 12;
    road.bands.insert(road.bands.begin() + 2, {AreaKind::lane, 9, 12, false});
    road.bands[3] = {AreaKind::lane, 12, 15, true};
    road.ground.crosswalks = {
        {.zebra = false, .parts = {{3, 15, 60, 64.5}}, .begins_m = 60, .signals = {"light"}}};
    return road;
  }

  struct Passage {
    std::vector<SimulatedScene> scenes;
    std::vector<double> fronts_m;
    std::string error;
  };

  /// The light shows a colour in each tick; a pedestrian may stand at `stands`.
  static Passage pass(Simulator& simulator, const std::vector<std::string>& colours,
                      const SimulatedRoad& road = signalled_street(), Point stands = {1, 90}) {
    const VehicleParameters vehicle;
    const std::array actors{Actor{"p1", ActorKind::pedestrian, 0.5, 0.5}};
    const std::array starts{ActorState{.x_m = stands.x_m, .y_m = stands.y_m}};
    const std::array bodies{SimulatedBody{0, starts.front(), starts.front()}};
    Passage passage;
    SimulatedStart start;
    passage.error = simulator.begin(test_of(0, road, vehicle, actors, starts), start);
    for (std::size_t i = 0; i < colours.size() && passage.error.empty(); ++i) {
      const std::array signals{ShownSignal{0, colours[i]}};
      std::vector<SimulatedScene> scenes;
      passage.error = simulator.advance({.tick = i + 1,
                                         .begin_s = static_cast<double>(i),
                                         .length_s = 1,
                                         .bodies = bodies,
                                         .signals = signals},
                                        scenes);
      for (const SimulatedScene& each : scenes) {
        passage.scenes.push_back(each);
        passage.fronts_m.push_back(each.av.state.y_m + 2.25);
      }
    }
    return passage;
  }

  static std::vector<std::string> ticks(std::size_t count, const std::string& colour,
                                        std::size_t green = 0) {
    std::vector<std::string> colours(count, colour);
    colours.resize(count + green, "green");
    return colours;
  }
};

TEST_F(AtASignal, VehiclesWaitBeforeTheStopLineUntilItIsGreen) {
  for (const std::string model : {"Krauss", "IDM", "EIDM", "ACC", "CACC", "Wiedemann"}) {
    for (const std::string colour : {"red", "amber"}) {
      const auto simulator = make_sumo(with(model));
      const Passage passage = pass(*simulator, ticks(14, colour, 6));
      ASSERT_EQ(passage.error, "") << model;
      EXPECT_LE(passage.fronts_m[139], 60) << model << ' ' << colour;
      EXPECT_GT(passage.fronts_m[139], 55) << model << ' ' << colour;
      EXPECT_NEAR(passage.scenes[139].av.state.speed_mps, 0, 0.3) << model << ' ' << colour;
      EXPECT_GT(passage.fronts_m.back(), 70) << model << ' ' << colour;
    }
    const auto simulator = make_sumo(with(model));
    const Passage green = pass(*simulator, ticks(8, "green"));
    const Passage open = pass(*simulator, ticks(8, "green"), street());
    ASSERT_EQ(green.error + open.error, "") << model;
    EXPECT_NEAR(green.fronts_m.back(), open.fronts_m.back(), 0.01)
        << model << ": green holds nobody up";
  }
}

TEST_F(AtASignal, AmberStopsWhoCanAndLetsPassWhoCannot) {
  const auto simulator = make_sumo(with("Krauss"));
  std::vector<std::string> late = ticks(6, "green");
  late.resize(9, "amber");
  const Passage near = pass(*simulator, late);
  ASSERT_EQ(near.error, "");
  EXPECT_NEAR(near.fronts_m[59], 55.5, 1e-6);
  EXPECT_GT(near.fronts_m.back(), 64.5);
}

TEST_F(AtASignal, TheConstantAvDrivesThrough) {
  const auto simulator = make_sumo(with("constant"));
  const Passage passage = pass(*simulator, ticks(12, "red"));
  ASSERT_EQ(passage.error, "");
  for (std::size_t i = 0; i < passage.fronts_m.size(); ++i) {
    EXPECT_NEAR(passage.fronts_m[i], 1.5 + 0.9 * static_cast<double>(i + 1), 1e-9);
    EXPECT_EQ(passage.scenes[i].av.state.x_m, 6);
    EXPECT_NEAR(passage.scenes[i].av.state.heading_rad, kForwardRad, 1e-9);
    if (i % 10 == 9) {
      EXPECT_EQ(passage.fronts_m[i], 1.5 + 9 * static_cast<double>(i / 10 + 1));
    }
  }
}

// A light parts the lane; whoever stands before, at or behind it is seen as on one that it does not
// part.
TEST_F(AtASignal, VehiclesBrakeForPedestriansAroundIt) {
  const SimulatedRoad plain = street();
  SimulatedRoad lit = street();
  lit.ground.crosswalks = signalled_street().ground.crosswalks;
  for (const double y_m : {57.0, 59.75, 60.0, 60.1, 60.2, 60.3, 60.4, 60.5, 60.75, 63.0, 75.0}) {
    const auto simulator = make_sumo(with("Krauss"));
    const Passage with_light = pass(*simulator, ticks(14, "green"), lit, {6, y_m});
    const Passage without = pass(*simulator, ticks(14, "green"), plain, {6, y_m});
    ASSERT_EQ(with_light.error + without.error, "") << y_m;
    EXPECT_LT(with_light.fronts_m.back(), y_m - 1) << y_m;
    EXPECT_NEAR(with_light.fronts_m.back(), without.fronts_m.back(), 1) << y_m;
  }
}

TEST_F(AtASignal, TrafficStopsOnItsOwnSide) {
  SimulatorParameters parameters = with("Krauss");
  SettingValue flows;
  flows.maps = {{{"lane", "2"}, {"every", "3"}}, {{"lane", "3"}, {"every", "3"}}};
  parameters.settings["traffic"] = flows;
  const auto simulator = make_sumo(parameters);
  const Passage red = pass(*simulator, ticks(25, "red"));
  ASSERT_EQ(red.error, "");
  double nearest_m = 0;
  double nearest_back_m = 1e6;
  for (const SimulatedVehicle& each : red.scenes.back().traffic) {
    if (!each.present || each.state.speed_mps > 0.1) continue;
    const bool back = each.state.heading_rad < 0;
    const double front_m = each.state.y_m + (back ? -2.25 : 2.25);
    if (back) nearest_back_m = std::min(nearest_back_m, front_m);
    if (!back) nearest_m = std::max(nearest_m, front_m);
  }
  EXPECT_LE(nearest_m, 60);
  EXPECT_GT(nearest_m, 55);
  EXPECT_GE(nearest_back_m, 64.5);
  EXPECT_LT(nearest_back_m, 69.5);
}

TEST_F(AtASignal, ATestBeginsWithGreenAndIsTheSameWhateverCameBefore) {
  const auto used = make_sumo(with("Krauss"));
  const Passage red = pass(*used, ticks(14, "red"));
  const Passage after = pass(*used, ticks(8, "green"));
  const auto fresh = make_sumo(with("Krauss"));
  const Passage alone = pass(*fresh, ticks(8, "green"));
  ASSERT_EQ(red.error + after.error + alone.error, "");
  EXPECT_EQ(after.fronts_m, alone.fronts_m);
  EXPECT_GT(after.fronts_m.back(), 70);
  EXPECT_EQ(red.fronts_m, pass(*fresh, ticks(14, "red")).fronts_m);
}

// From behind the stop line it does not come back to it.
TEST_F(AtASignal, WhoBeginsBehindTheStopLineDrivesOn) {
  for (const double begins_m : {-9.0, 1.1, 1.5, 1.6}) {
    SimulatedRoad road = signalled_street();
    road.ground.crosswalks.front().begins_m = begins_m;
    road.ground.crosswalks.front().parts = {{3, 15, begins_m, begins_m + 3}};
    const auto simulator = make_sumo(with("constant"));
    const Passage passage = pass(*simulator, ticks(3, "red"), road);
    ASSERT_EQ(passage.error, "") << begins_m;
    EXPECT_NEAR(passage.fronts_m.back(), 1.5 + 9 * 3, kLightM) << begins_m;
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
