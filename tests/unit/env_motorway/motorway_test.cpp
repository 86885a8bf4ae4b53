// SPDX-License-Identifier: Apache-2.0
#include "env/motorway/motorway.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/motorway/world.h"
#include "tests/helpers/constants.h"
#include "tests/unit/env_motorway/motorway.h"

namespace jaywalk::motorway {
namespace {

using testing::HasSubstr;

TEST_F(MotorwayTest, TellsDriversOfThemselvesTheAvAndEachOther) {
  const Motorway motorway = with({vehicle(1, 90), vehicle(3, 120, 25), vehicle(3, 400)});
  EXPECT_EQ(perceived(motorway, "tick"), (Rows{{1}}));
  EXPECT_EQ(perceived(motorway, "lane"), (Rows{{1}}));
  EXPECT_EQ(perceived(motorway, "front"), (Rows{{90}}));
  EXPECT_EQ(perceived(motorway, "av"), (Rows{{2, 10, 30}}));
  EXPECT_EQ(perceived(motorway, "vehicle"), (Rows{{2, 3, 30, 25}})) << "150 m are in sight";
  EXPECT_EQ(perceived(motorway, "vehicle", 1), (Rows{{1, 1, -30, 30}}));
  EXPECT_EQ(perceived(motorway, "changing"), Rows{});
  EXPECT_EQ(perceived(motorway, "id", 2), (Rows{{3}}));
}

TEST_F(MotorwayTest, VehiclesGatherAndLoseSpeedWithinTheirLimits) {
  Motorway motorway = with({vehicle(1, 0)});
  // Half a second of 2 m/s2: 30.5 · 0.5 on average.
  EXPECT_EQ(act(motorway, MotorwayAction::accelerate, {Value::number(2)}), "");
  EXPECT_NEAR(motorway.vehicles()[0].speed_mps, 31, 1e-9);
  EXPECT_NEAR(motorway.vehicles()[0].front_m, 15.25, 1e-9);
  EXPECT_EQ(act(motorway, MotorwayAction::keep), "");
  EXPECT_NEAR(motorway.vehicles()[0].speed_mps, 31, 1e-9);
  // Eight at most are asked of the brakes, three of the engine.
  EXPECT_EQ(act(motorway, MotorwayAction::brake, {Value::number(100)}), "");
  EXPECT_NEAR(motorway.vehicles()[0].speed_mps, 27, 1e-9);
  EXPECT_EQ(act(motorway, MotorwayAction::accelerate, {Value::number(100)}), "");
  EXPECT_NEAR(motorway.vehicles()[0].speed_mps, 28.5, 1e-9);
  EXPECT_THAT(act(motorway, MotorwayAction::brake, {Value::number(-1)}), HasSubstr("at least 0"));
  EXPECT_TRUE(motorway.last_action_failed(0));
  EXPECT_EQ(motorway.result().agents[0].actions, 4U);
  for (int i = 0; i < 20; ++i) act(motorway, MotorwayAction::brake, {Value::number(8)});
  EXPECT_EQ(motorway.vehicles()[0].speed_mps, 0) << "nobody reverses";
}

TEST_F(MotorwayTest, AChangeOfLanesTakesItsTime) {
  Motorway motorway = with({vehicle(1, 0)});
  EXPECT_THAT(act(motorway, MotorwayAction::change_lane, {vocabulary_.left()}),
              HasSubstr("no lane to the left of lane 1"));
  // 3.5 m in 2 s, of which a tick is a quarter.
  EXPECT_EQ(act(motorway, MotorwayAction::change_lane, {vocabulary_.right()}), "");
  EXPECT_NEAR(motorway.vehicles()[0].x_m, 1.75 + 0.875, 1e-9);
  EXPECT_EQ(perceived(motorway, "lane"), (Rows{{1}}));
  EXPECT_EQ(perceived(motorway, "changing"), (Rows{{2}}));
  EXPECT_THAT(act(motorway, MotorwayAction::change_lane, {vocabulary_.right()}),
              HasSubstr("changing to lane 2 already"));
  idle(motorway, 1);
  EXPECT_EQ(perceived(motorway, "lane"), (Rows{{2}}));
  idle(motorway, 1);
  EXPECT_NEAR(motorway.vehicles()[0].x_m, 5.25, 1e-9);
  EXPECT_EQ(perceived(motorway, "changing"), Rows{});
  ASSERT_EQ(motorway.events().size(), 1U);
  EXPECT_EQ(motorway.events()[0].text, "to lane 2");
  EXPECT_EQ(motorway.events()[0].tick, 2);
  EXPECT_EQ(motorway.events()[0].actor, 1U);
}

TEST_F(MotorwayTest, ThePreconditionIsToBeCloseBeforeTheAv) {
  // 1 s of 30 m/s: the rear, 4.5 m behind the front, is 30 m before the AV's front or less.
  for (const auto& [front, met] : {std::pair{134.4, true}, {134.6, false}, {104.6, true}}) {
    Motorway motorway = with({vehicle(2, front)});
    idle(motorway, 1);
    EXPECT_EQ(motorway.result().success, met) << front;
  }
  Motorway beside = with({vehicle(1, 120)});
  idle(beside, 10);
  EXPECT_FALSE(beside.result().success);
  EXPECT_EQ(beside.result().agents[0].cost, 10);
}

TEST_F(MotorwayTest, TheTestGoesOnAfterThePreconditionAndCostsNothingThen) {
  Motorway motorway = with({vehicle(2, 120), vehicle(1, 120)});
  idle(motorway, 1);
  EXPECT_EQ(perceived(motorway, "precondition_met"), (Rows{{1}}));
  idle(motorway, parameters_.aftermath - 1);
  EXPECT_FALSE(motorway.finished());
  idle(motorway, 1);
  EXPECT_TRUE(motorway.finished());
  EXPECT_EQ(motorway.result().end, "precondition");
  EXPECT_EQ(motorway.result().ticks, 1);
  EXPECT_EQ(motorway.result().all_ticks, 11);
  EXPECT_EQ(motorway.result().agents[0].reward, 100);
  EXPECT_EQ(motorway.result().agents[1].reward, 0);
  EXPECT_EQ(motorway.result().agents[1].cost, 1);
}

TEST_F(MotorwayTest, TheAvThatDoesNotBrakeRunsIntoWhoCutsIn) {
  Motorway motorway = with({vehicle(2, 110, 20)});
  // The rear is 5.5 m before the AV, which closes by 10 m/s: 0.55 s, in the second tick.
  idle(motorway, 1);
  EXPECT_TRUE(motorway.result().collisions.empty());
  idle(motorway, 1);
  ASSERT_EQ(motorway.result().collisions.size(), 1U);
  EXPECT_EQ(motorway.result().collisions[0].tick, 2);
  EXPECT_NEAR(motorway.result().collisions[0].impact_mps, 10, 1e-9);
  EXPECT_EQ(motorway.result().end, "collision");
}

TEST_F(MotorwayTest, AModelThatBrakesDoesNot) {
  parameters_.av.vehicle.model = "idm";
  Motorway motorway = with({vehicle(2, 130, 25)});
  motorway.begin({});
  idle(motorway, 11);
  EXPECT_TRUE(motorway.result().collisions.empty());
  EXPECT_LT(motorway.av_speed_mps(), 29);
}

TEST_F(MotorwayTest, AgentsVehiclesThatTouchCrash) {
  // The first closes by 10 m/s on the second, whose rear is 3 m before it.
  Motorway motorway = with({vehicle(3, 300, 30), vehicle(3, 307.5, 20), vehicle(1, 300)});
  idle(motorway, 1);
  EXPECT_EQ(perceived(motorway, "crashed"), (Rows{{1}, {2}}));
  EXPECT_EQ(perceived(motorway, "crashed", 2), (Rows{{1}, {2}})) << "it is in sight";
  ASSERT_EQ(motorway.events().size(), 2U);
  EXPECT_EQ(motorway.events()[0].kind, "crash");
  EXPECT_EQ(motorway.events()[0].text, "with v2");
  EXPECT_EQ(motorway.events()[1].actor, 2U);
  EXPECT_FALSE(motorway.finished()) << "the AV has still to pass them";
  // They brake to a stand with all that their brakes have, whatever their drivers want.
  EXPECT_THAT(act(motorway, MotorwayAction::accelerate, {Value::number(3)}), HasSubstr("crashed"));
  EXPECT_TRUE(motorway.last_action_failed(0));
  idle(motorway, 8);
  EXPECT_EQ(motorway.vehicles()[0].speed_mps, 0);
  EXPECT_EQ(motorway.vehicles()[1].speed_mps, 0);
  EXPECT_EQ(motorway.events().size(), 2U) << "each crash is told once";
  EXPECT_EQ(motorway.vehicles()[2].speed_mps, 30);
}

TEST_F(MotorwayTest, WhoIsRunIntoWhileChangingLanesChangesNoFurther) {
  Motorway motorway = with({vehicle(1, 300), vehicle(2, 300)});
  EXPECT_EQ(act(motorway, MotorwayAction::change_lane, {vocabulary_.right()}), "");
  idle(motorway, 1);
  ASSERT_EQ(perceived(motorway, "crashed").size(), 2U);
  const double x = motorway.vehicles()[0].x_m;
  EXPECT_NEAR(x + 1.8, 5.25, 0.2) << "side at side, within a step";
  idle(motorway, 10);
  EXPECT_EQ(motorway.vehicles()[0].x_m, x);
}

TEST_F(MotorwayTest, AWreckInTheAvsLaneIsAHazard) {
  Motorway motorway = with({vehicle(2, 300, 0), vehicle(2, 296, 0)});
  idle(motorway, 20);
  EXPECT_TRUE(motorway.result().success);
  EXPECT_EQ(motorway.result().end, "collision");
}

TEST_F(MotorwayTest, ParametersHaveToFitTogether) {
  const auto said = [this](auto change) {
    MotorwayParameters changed = parameters_;
    change(changed);
    std::string text;
    for (const ParameterProblem& each : problems(changed)) {
      text += each.path + ": " + each.message + '\n';
    }
    return text;
  };
  EXPECT_EQ(said([](MotorwayParameters&) {}), "");
  EXPECT_EQ(said([](MotorwayParameters& p) { p.av.lane = 4; }),
            "world.av.lane: the AV's lane 4 is none of the 3\n");
  EXPECT_EQ(said([](MotorwayParameters& p) { p.av.width_m = 4; }),
            "world.av.width: an AV of 4 m does not fit a lane of 3.5 m\n");
  EXPECT_EQ(said([](MotorwayParameters& p) { p.length_m = 100; }),
            "world.av.start: the road of 100 m ends before the AV's start\n");
  EXPECT_THAT(said([](MotorwayParameters& p) { p.drivers.greatest_speed_mps = 20; }),
              HasSubstr("world.drivers.greatest_speed: "));
  EXPECT_THAT(said([](MotorwayParameters& p) {
                p.av.vehicle.defects = {{"latency", 1}};
              }),
              HasSubstr("world.av.defect"));
}

class MotorwayStarts : public MotorwayTest {
 protected:
  void expect_room(std::uint32_t agents) {
    const auto spec = std::make_shared<MotorwaySpec>(parameters_);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const auto vehicles = spec->spawn({.agents = agents, .seed = seed});
      ASSERT_EQ(vehicles.size(), agents);
      for (std::size_t i = 0; i < vehicles.size(); ++i) {
        EXPECT_GE(vehicles[i].lane, 1);
        EXPECT_LE(vehicles[i].lane, parameters_.lanes);
        EXPECT_EQ(vehicles[i].x_m, middle_of_lane(parameters_, vehicles[i].lane));
        const bool in_avs_lane = vehicles[i].lane == parameters_.av.lane;
        EXPECT_TRUE(!in_avs_lane || std::fabs(vehicles[i].front_m - parameters_.av.start_m) > 14)
            << seed;
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_TRUE(vehicles[i].lane != vehicles[j].lane ||
                      std::fabs(vehicles[i].front_m - vehicles[j].front_m) > 14)
              << seed << ": " << i << " over " << j;
        }
      }
    }
  }
};

TEST_F(MotorwayStarts, AreInOtherLanesThanTheAvsAndApart) {
  const auto spec = std::make_shared<MotorwaySpec>(parameters_);
  std::map<int, int> lanes;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const MotorwayVehicle vehicle = spec->spawn({.agents = 1, .seed = seed})[0];
    ++lanes[vehicle.lane];
    EXPECT_GE(vehicle.front_m, 40);
    EXPECT_LE(vehicle.front_m, 140);
    EXPECT_EQ(vehicle.speed_mps, 30);
  }
  EXPECT_EQ(lanes.size(), 2U);
  EXPECT_GT(lanes[1], 60);
  EXPECT_GT(lanes[3], 60);
  expect_room(5);
}

TEST_F(MotorwayStarts, AreApartEvenWhereThereIsNoRoomForAll) { expect_room(60); }

TEST_F(MotorwayStarts, AreNotWhereTheAvIsOnARoadOfOneLane) {
  parameters_.lanes = 1;
  parameters_.av.lane = 1;
  expect_room(3);
}

TEST_F(MotorwayTest, IsConstantWhereItSaysSo) {
  Motorway motorway = with({vehicle(1, 90), vehicle(3, 120, 25)});
  const std::vector<std::string> said = test::constant_texts(motorway, symbols_);
  EXPECT_EQ(said.size(), 6U);
  for (int ticks = 0; ticks < 20; ++ticks) {
    EXPECT_EQ(test::constant_texts(motorway, symbols_), said);
    EXPECT_EQ(test::perceived_constants(motorway, 0, symbols_), said);
    EXPECT_EQ(test::perceived_constants(motorway, 1, symbols_), said);
    act(motorway, MotorwayAction::brake, {Value::number(4)});
  }
}

}  // namespace
}  // namespace jaywalk::motorway
