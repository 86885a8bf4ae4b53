// SPDX-License-Identifier: Apache-2.0
// Results of tests on the motorway: how they end, which agents they credit, their costs; and laws
// that hold of every drive.

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/motorway/world.h"
#include "interpreter/support/random.h"
#include "tests/unit/env_motorway/motorway.h"

namespace jaywalk::motorway {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MotorwayOutcome : public MotorwayTest {};

TEST_F(MotorwayOutcome, EndsWhereTheRoadDoes) {
  parameters_.length_m = 160;
  Motorway motorway = with({vehicle(1, 0)});
  idle(motorway, 3);
  EXPECT_FALSE(motorway.finished()) << "at 145 m";
  idle(motorway, 1);
  EXPECT_TRUE(motorway.finished());
  EXPECT_EQ(motorway.result().end, "road_end");
  EXPECT_EQ(motorway.result().all_ticks, 4);
  EXPECT_EQ(motorway.describe_result(), "precondition not met in 4 ticks, score -4.00");
}

TEST_F(MotorwayOutcome, EndsWhenItsTimeIsUp) {
  parameters_.time_limit_s = 2;
  Motorway motorway = with({vehicle(1, 0)});
  idle(motorway, 3);
  EXPECT_FALSE(motorway.finished());
  idle(motorway, 1);
  EXPECT_EQ(motorway.result().end, "time_limit");
}

TEST_F(MotorwayOutcome, EndsAtOnceWithoutAnAftermath) {
  parameters_.aftermath = 0;
  Motorway motorway = with({vehicle(2, 120)});
  idle(motorway, 1);
  EXPECT_EQ(motorway.result().end, "precondition");
  EXPECT_EQ(motorway.result().all_ticks, 1);
}

TEST_F(MotorwayOutcome, CreditsEverybodyWhoIsThereFirst) {
  parameters_.headway_s = 2;
  Motorway motorway = with({vehicle(2, 120), vehicle(1, 120), vehicle(2, 135)});
  idle(motorway, 1);
  EXPECT_THAT(motorway.result().met_by, ElementsAre(0, 2));
  EXPECT_THAT(motorway.describe_result(), HasSubstr("precondition met in tick 1 by v1, v3, score"));
  // 100 less 1 for two of them, -1 for the other.
  EXPECT_DOUBLE_EQ(motorway.result().score(), (99 - 1 + 99) / 3.0);
}

TEST_F(MotorwayOutcome, CreditsNobodyWhoComesLater) {
  Motorway motorway = with({vehicle(2, 120), vehicle(1, 124)});
  idle(motorway, 1);
  act(motorway, MotorwayAction::change_lane, {vocabulary_.right()}, 1);
  idle(motorway, 3);
  EXPECT_THAT(motorway.result().met_by, ElementsAre(0));
  EXPECT_EQ(motorway.result().agents[1].reward, 0);
}

TEST_F(MotorwayOutcome, CountsCuttingInFromTheEdgeOfTheLane) {
  // The right side is 0.9 m from the middle: it is over the line after 0.85 m of a change.
  Motorway motorway = with({vehicle(1, 124)});
  act(motorway, MotorwayAction::change_lane, {vocabulary_.right()});
  EXPECT_TRUE(motorway.result().success) << "0.875 m in the first tick";
  parameters_.drivers.change_s = 2.1;
  Motorway slower = with({vehicle(1, 124)});
  act(slower, MotorwayAction::change_lane, {vocabulary_.right()});
  EXPECT_FALSE(slower.result().success) << "0.833 m";
}

TEST_F(MotorwayOutcome, CountsNobodyBesideOrBehindTheAv) {
  for (const double front : {104.4, 100.0, 50.0}) {
    parameters_.time_limit_s = 1;
    Motorway motorway = with({vehicle(2, front)});
    idle(motorway, 2);
    EXPECT_FALSE(motorway.result().success) << front;
  }
}

TEST_F(MotorwayOutcome, MeasuresTheHeadwayByTheAvsOwnSpeed) {
  // 28 m ahead: within a second of 30 m/s, not of 25.
  for (const auto& [speed, met] : {std::pair{30.0, true}, std::pair{25.0, false}}) {
    parameters_.av.speed_mps = speed;
    Motorway motorway = with({vehicle(2, 132.5, speed)});
    idle(motorway, 1);
    EXPECT_EQ(motorway.result().success, met) << speed;
  }
}

TEST_F(MotorwayOutcome, NamesWhomTheAvTouchesOnceEach) {
  parameters_.aftermath = 100;
  Motorway motorway = with({vehicle(2, 106, 20), vehicle(2, 130, 10)});
  for (int i = 0; i < 8 && !motorway.finished(); ++i) idle(motorway, 1);
  ASSERT_EQ(motorway.result().collisions.size(), 1U) << "a collision ends the test";
  EXPECT_EQ(motorway.result().end, "collision");
  // A test that has time for more knows each of them once.
  for (int i = 0; i < 4; ++i) idle(motorway, 1);
  ASSERT_EQ(motorway.result().collisions.size(), 2U);
  EXPECT_EQ(motorway.result().collisions[0].body, 0U);
  EXPECT_EQ(motorway.result().collisions[1].body, 1U);
}

TEST_F(MotorwayOutcome, CountsOnlyActionsThatWereDone) {
  Motorway motorway = with({vehicle(1, 0), vehicle(3, 0)});
  act(motorway, MotorwayAction::keep);
  act(motorway, MotorwayAction::change_lane, {vocabulary_.left()});
  act(motorway, MotorwayAction::accelerate, {Value::number(1)});
  EXPECT_EQ(motorway.result().agents[0].actions, 2U);
  EXPECT_EQ(motorway.result().agents[1].actions, 0U);
  EXPECT_FALSE(motorway.last_action_failed(0));
  EXPECT_FALSE(motorway.last_action_failed(7)) << "nobody has that number";
}

TEST_F(MotorwayOutcome, RefusesWordsAndValuesThatMeanNothing) {
  Motorway motorway = with({vehicle(2, 500)});
  EXPECT_THAT(act(motorway, MotorwayAction::change_lane, {Value::number(1)}),
              HasSubstr("expected left or right"));
  EXPECT_THAT(act(motorway, MotorwayAction::accelerate, {vocabulary_.left()}),
              HasSubstr("a number, at least 0"));
  EXPECT_THAT(act(motorway, MotorwayAction::brake, {Value::number(std::nan(""))}),
              HasSubstr("a number, at least 0"));
  const ActionRequest fly{AgentId{0}, symbols_.predicate("fly", 0), {}};
  std::vector<ActionResult> results(1);
  motorway.execute({&fly, 1}, results);
  EXPECT_FALSE(results[0].succeeded);
  EXPECT_THAT(results[0].reason, HasSubstr("unknown action, expected accelerate(A)"));
  EXPECT_DOUBLE_EQ(motorway.vehicles()[0].speed_mps, 30) << "and nothing came of any of them";
}

TEST_F(MotorwayOutcome, ForgetsAnAccelerationWithItsTick) {
  Motorway motorway = with({vehicle(1, 0)});
  act(motorway, MotorwayAction::accelerate, {Value::number(2)});
  idle(motorway, 5);
  EXPECT_NEAR(motorway.vehicles()[0].speed_mps, 31, 1e-9);
}

TEST_F(MotorwayOutcome, IsTheSameInTicksOfAnyLength) {
  // A change of lanes, then steady braking, in ticks of half a second and of a fifth of that.
  const auto after_four_seconds = [this](double tick_s) {
    parameters_.tick_s = tick_s;
    Motorway motorway = with({vehicle(1, 300)});
    act(motorway, MotorwayAction::change_lane, {vocabulary_.right()});
    idle(motorway, static_cast<int>(std::lround(2 / tick_s)) - 1);
    for (long i = std::lround(2 / tick_s); i > 0; --i) {
      act(motorway, MotorwayAction::brake, {Value::number(3)});
    }
    return std::pair{motorway.vehicles()[0], motorway.av_front_m()};
  };
  const auto [coarse, coarse_av_m] = after_four_seconds(0.5);
  const auto [fine, fine_av_m] = after_four_seconds(0.1);
  EXPECT_NEAR(coarse.x_m, fine.x_m, 1e-9);
  EXPECT_NEAR(coarse.speed_mps, 24, 1e-9);
  EXPECT_NEAR(fine.speed_mps, 24, 1e-9);
  EXPECT_NEAR(coarse.front_m, fine.front_m, 1e-9);
  EXPECT_NEAR(coarse_av_m, fine_av_m, 1e-9);
}

/// Vehicles that act at random from a seed; every tick is looked at.
class RandomDrives : public MotorwayTest, public testing::WithParamInterface<std::uint64_t> {
 protected:
  static constexpr std::uint32_t kAgents = 6;
  void one_tick(Motorway& motorway, SplitMix64& random) {
    std::vector<std::vector<Value>> args(kAgents);
    std::vector<ActionRequest> requests;
    for (std::uint32_t i = 0; i < kAgents; ++i) {
      const auto action = static_cast<MotorwayAction>(random.below(kMotorwayActions.size()));
      if (action == MotorwayAction::change_lane) {
        args[i].push_back(random.below(2) == 0 ? vocabulary_.left() : vocabulary_.right());
      } else if (action != MotorwayAction::keep) {
        args[i].push_back(Value::number(random.share() * 12));
      }
      requests.push_back({AgentId{i}, vocabulary_.action(action), args[i]});
    }
    std::vector<ActionResult> results(kAgents);
    motorway.execute(requests, results);
    motorway.advance();
  }
};

TEST_P(RandomDrives, KeepVehiclesOnTheRoadWithinTheirLimitsAndWrecksWhereTheyAre) {
  const auto spec = std::make_shared<MotorwaySpec>(parameters_);
  Motorway motorway = with(spec->spawn({.agents = kAgents, .seed = GetParam()}));
  SplitMix64 random(GetParam());
  for (int tick = 1; tick <= 60; ++tick) {
    const std::vector<MotorwayVehicle> before(motorway.vehicles().begin(),
                                              motorway.vehicles().end());
    one_tick(motorway, random);
    EXPECT_EQ(motorway.ticks(), tick);
    for (std::size_t i = 0; i < kAgents; ++i) {
      const MotorwayVehicle& now = motorway.vehicles()[i];
      EXPECT_GE(now.front_m, before[i].front_m) << "nobody reverses";
      EXPECT_GE(now.speed_mps, 0);
      EXPECT_LE(now.speed_mps, parameters_.drivers.greatest_speed_mps + 1e-9);
      EXPECT_LE(now.speed_mps - before[i].speed_mps, 3 * 0.5 + 1e-9);
      EXPECT_GE(now.speed_mps - before[i].speed_mps, -8 * 0.5 - 1e-9);
      EXPECT_GE(now.x_m, 1.75 - 1e-9);
      EXPECT_LE(now.x_m, 8.75 + 1e-9);
      if (!now.changing && !now.crashed) {
        EXPECT_DOUBLE_EQ(now.x_m, middle_of_lane(parameters_, now.lane));
      }
      if (!before[i].crashed) continue;
      EXPECT_TRUE(now.crashed);
      EXPECT_EQ(now.x_m, before[i].x_m);
      EXPECT_LE(now.speed_mps, std::max(0.0, before[i].speed_mps - 8 * 0.5) + 1e-9);
    }
  }
}

TEST_P(RandomDrives, ComeOutTheSameAgain) {
  const auto spec = std::make_shared<MotorwaySpec>(parameters_);
  const auto run = [&] {
    Motorway motorway = with(spec->spawn({.agents = kAgents, .seed = GetParam()}));
    SplitMix64 random(GetParam() + 1);
    for (int tick = 0; tick < 30; ++tick) one_tick(motorway, random);
    return motorway.scene();
  };
  EXPECT_EQ(run(), run());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomDrives, testing::Range<std::uint64_t>(1, 7));

}  // namespace
}  // namespace jaywalk::motorway
