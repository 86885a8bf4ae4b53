// SPDX-License-Identifier: Apache-2.0
// Laws of the car under any commands: it behaves alike to either side and in every direction, no
// quicker than its actuators, no harder than its tyres and its engine.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/lane/out_of_bounds.h"
#include "env/lane/vehicle.h"
#include "env/scene.h"
#include "interpreter/support/random.h"

namespace jaywalk::lane {
namespace {

constexpr double kStepS = 0.005;

/// Commands at random, one for each tenth of a second.
std::vector<Command> random_commands(std::uint64_t seed) {
  SplitMix64 random(seed);
  std::vector<Command> commands(30);
  for (Command& each : commands) {
    each = {.acceleration = 14 * random.share() - 8, .steering_rad = 0.8 * random.share() - 0.4};
  }
  return commands;
}

/// Every state on the way of a car that gets these commands.
std::vector<VehicleState> states(VehicleState state, const std::vector<Command>& commands,
                                 const VehicleParameters& parameters = {}) {
  std::vector<VehicleState> all;
  for (const Command& command : commands) {
    for (int i = 0; i < 20; ++i) {
      advance(state, command, parameters, {}, kStepS);
      all.push_back(state);
    }
  }
  return all;
}

class AnyDrive : public testing::TestWithParam<std::uint64_t> {
 protected:
  [[nodiscard]] std::vector<Command> commands() const { return random_commands(GetParam()); }
};

TEST_P(AnyDrive, IsMirroredByCommandsToTheOtherSide) {
  std::vector<Command> mirrored = commands();
  for (Command& each : mirrored) each.steering_rad = -each.steering_rad;
  const auto left = states({.speed_mps = 15}, commands());
  const auto right = states({.speed_mps = 15}, mirrored);
  for (std::size_t i = 0; i < left.size(); ++i) {
    ASSERT_NEAR(right[i].y_m, -left[i].y_m, 1e-9) << i;
    ASSERT_NEAR(right[i].x_m, left[i].x_m, 1e-9) << i;
    ASSERT_NEAR(right[i].yaw_rate, -left[i].yaw_rate, 1e-9) << i;
  }
}

TEST_P(AnyDrive, IsTheSameInEveryDirection) {
  constexpr double kTurn = 1.1;
  const auto here = states({.speed_mps = 12}, commands());
  const auto there =
      states({.x_m = 50, .y_m = -7, .heading_rad = kTurn, .speed_mps = 12}, commands());
  const double c = std::cos(kTurn);
  const double s = std::sin(kTurn);
  for (std::size_t i = 0; i < here.size(); ++i) {
    ASSERT_NEAR(there[i].x_m, 50 + c * here[i].x_m - s * here[i].y_m, 1e-6) << i;
    ASSERT_NEAR(there[i].y_m, -7 + s * here[i].x_m + c * here[i].y_m, 1e-6) << i;
    ASSERT_NEAR(there[i].speed_mps, here[i].speed_mps, 1e-9) << i;
  }
}

TEST_P(AnyDrive, TurnsItsWheelsNoQuickerAndNoFurtherThanTheyGo) {
  VehicleState last{.speed_mps = 10};
  std::vector<Command> wild = commands();
  for (Command& each : wild) each.steering_rad *= 8;
  for (const VehicleState& now : states(last, wild)) {
    ASSERT_LE(std::fabs(now.steering_rad - last.steering_rad), 0.4 * kStepS + 1e-12);
    ASSERT_LE(std::fabs(now.steering_rad), VehicleParameters{}.most_steering_rad);
    last = now;
  }
}

TEST_P(AnyDrive, NeverRollsBack) {
  VehicleState last{.speed_mps = 2};
  for (const VehicleState& now : states(last, commands())) {
    ASSERT_GE(now.speed_mps, 0);
    ASSERT_LE(now.speed_mps - last.speed_mps, 11.5 * kStepS + 0.05);
    last = now;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyDrive, testing::Range<std::uint64_t>(1, 7));

/// The speed after some seconds of full throttle.
double speed_after(double seconds, const VehicleParameters& parameters = {}) {
  VehicleState state;
  for (double t = 0; t < seconds; t += kStepS) {
    advance(state, {.acceleration = 100}, parameters, {}, kStepS);
  }
  return state.speed_mps;
}

TEST(Engine, HasConstantPowerAboveItsSwitchSpeed) {
  // There v dv/dt is constant: v² grows evenly, by twice 11.5 · 7.319 a second.
  const double from = speed_after(3);
  const double to = speed_after(5);
  EXPECT_NEAR((to * to - from * from) / 2, 2 * 11.5 * 7.319, 4);
}

TEST(Engine, AcceleratesEvenlyBelowIt) {
  VehicleParameters strong;
  strong.most_acceleration = 4;
  strong.switch_speed_mps = 50;
  EXPECT_NEAR(speed_after(4, strong) - speed_after(2, strong), 8, 0.1);
}

TEST(Brakes, StopWithinWhatTheTyresHold) {
  const double grip = VehicleParameters{}.longitudinal_friction * kGravityMps2;
  // From 19.8 m/s² on the rear axle leaves the ground.
  for (const double braking : {15.0, 20.0, 100.0}) {
    VehicleState state{.speed_mps = 20};
    while (state.speed_mps > 0 && state.x_m < 100) {
      advance(state, {.acceleration = -braking}, {}, {}, kStepS);
    }
    // v² / 2a with all that the tyres hold, down to 3 m/s, where the kinematic model begins.
    EXPECT_GT(state.x_m, (20 * 20 - 3 * 3) / (2 * grip)) << braking;
    EXPECT_LT(state.x_m, 1.5 * 20 * 20 / (2 * grip)) << braking;
  }
}

TEST(Brakes, KeepTheCarSteerableWithItsRearAxleInTheAir) {
  VehicleState state{.speed_mps = 20};
  for (int i = 0; i < 100; ++i) {
    advance(state, {.acceleration = -20, .steering_rad = 0.2}, {}, {}, kStepS);
  }
  EXPECT_TRUE(std::isfinite(state.x_m) && std::isfinite(state.yaw_rate));
  EXPECT_GT(state.y_m, 0) << "to the left";
}

TEST(Actuators, FollowACommandWithTheirLag) {
  // A first-order lag of 80 ms reaches 63 % after 80 ms, while no rate limits it.
  VehicleState state{.speed_mps = 10};
  const Actuator actuator{.steering_lag_s = 0.08, .steering_rate = 100};
  for (int i = 0; i < 16; ++i) advance(state, {.steering_rad = 0.01}, {}, actuator, kStepS);
  EXPECT_NEAR(state.steering_rad, 0.01 * (1 - std::exp(-1)), 2e-4);
}

TEST(Tyre, IsAsStrongToEitherSideAndHarderUnderMoreLoad) {
  const VehicleParameters p;
  for (double slip = 0.01; slip < 1; slip += 0.05) {
    EXPECT_DOUBLE_EQ(lateral_force(p, slip, 4000), -lateral_force(p, -slip, 4000));
    EXPECT_LT(lateral_force(p, slip, 4000), 0) << "against the slip";
    EXPECT_DOUBLE_EQ(lateral_force(p, slip, 8000), 2 * lateral_force(p, slip, 4000));
  }
}

/// A road straight up, its right lane 100 m to 104 m from the left.
const Road& straight_road() {
  static const Road road = *make_road({{100, 10}, {100, 110}});
  return road;
}

TEST(OutOfBoundsShare, IsTheShareOfPointsOfTheBoxThatLieOutside) {
  SplitMix64 random(2);
  const VehicleParameters p;
  for (int i = 0; i < 30; ++i) {
    const VehicleState state{.x_m = 97 + 10 * random.share(),
                             .y_m = 60,
                             .heading_rad = 2 * std::numbers::pi * random.share()};
    // A grid of points within the box.
    constexpr int kParts = 100;
    int outside = 0;
    for (int a = 0; a < kParts; ++a) {
      for (int b = 0; b < kParts; ++b) {
        const double along = p.length_m * ((a + 0.5) / kParts - 0.5);
        const double left = p.width_m * ((b + 0.5) / kParts - 0.5);
        const double x =
            state.x_m + std::cos(state.heading_rad) * along - std::sin(state.heading_rad) * left;
        outside += x < 100 || x > 104 ? 1 : 0;
      }
    }
    EXPECT_NEAR(out_of_bounds_share(straight_road(), state, p, 50), outside / 1e4, 0.01) << i;
  }
}

TEST(OutOfBoundsShare, GrowsTheFurtherTheCarIsAside) {
  double last = -1;
  for (double x = 102; x < 107; x += 0.1) {
    const double share = out_of_bounds_share(
        straight_road(), {.x_m = x, .y_m = 60, .heading_rad = std::numbers::pi / 2}, {}, 50);
    EXPECT_GE(share, last - 1e-12) << x;
    EXPECT_LE(share, 1);
    last = share;
  }
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(OutOfBoundsShare, CountsWhatIsBeyondTheRoadsEnds) {
  const double half = VehicleParameters{}.length_m / 2;
  const auto share_at = [](double y, std::size_t near) {
    return out_of_bounds_share(
        straight_road(), {.x_m = 102, .y_m = y, .heading_rad = std::numbers::pi / 2}, {}, near);
  };
  EXPECT_NEAR(share_at(10, 0), 0.5, 1e-9);
  EXPECT_NEAR(share_at(10 + half, 2), 0, 1e-9);
  EXPECT_NEAR(share_at(110, 100), 0.5, 1e-9);
}

TEST(OutOfBoundsShare, LooksNoFurtherThanFourteenPointsAway) {
  const VehicleState state{.x_m = 102, .y_m = 60, .heading_rad = std::numbers::pi / 2};
  // Fourteen points after the 36th are at 60 m: the rear half of the car is seen there.
  EXPECT_NEAR(out_of_bounds_share(straight_road(), state, {}, 36), 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(out_of_bounds_share(straight_road(), state, {}, 20), 1);
}

}  // namespace
}  // namespace jaywalk::lane
