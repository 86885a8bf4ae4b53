// SPDX-License-Identifier: Apache-2.0
#include "env/lane/vehicle.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/lane/out_of_bounds.h"
#include "env/scene.h"

namespace jaywalk::lane {
namespace {

void run(VehicleState& state, const Command& command, double seconds) {
  for (double t = 0; t < seconds; t += 0.005) advance(state, command, {}, {}, 0.005);
}

TEST(Vehicle, AcceleratesStraightOn) {
  VehicleState state;
  run(state, {.acceleration = 2}, 5);
  EXPECT_NEAR(state.speed_mps, 10, 0.2);
  EXPECT_NEAR(state.x_m, 25, 0.6);
  EXPECT_DOUBLE_EQ(state.y_m, 0);
}

TEST(Vehicle, NeverRollsBackwards) {
  VehicleState state;
  run(state, {.acceleration = -8}, 2);
  EXPECT_DOUBLE_EQ(state.speed_mps, 0);
  EXPECT_DOUBLE_EQ(state.x_m, 0);
}

TEST(Vehicle, TurnsSlowlyOnTheCircleOfItsSteeringAngle) {
  VehicleState state;
  state.speed_mps = 1.5;
  state.steering_rad = 0.1;
  run(state, {.steering_rad = 0.1}, 2);
  const double radius = VehicleParameters{}.wheelbase_m() / std::tan(0.1);
  EXPECT_NEAR(state.yaw_rate, state.speed_mps / radius, 1e-3);
}

TEST(Vehicle, CannotCornerBeyondTheTyresGrip) {
  VehicleState state;
  state.speed_mps = 25;
  double most = 0;
  for (int i = 0; i < 400; ++i) {
    advance(state, {.steering_rad = 0.5}, {}, {}, 0.005);
    if (i > 200) most = std::max(most, std::fabs(state.lateral_acceleration()));
  }
  EXPECT_LT(most, 1.3 * kGravityMps2);
  EXPECT_GT(most, 0.5 * kGravityMps2);
}

TEST(Tyre, SaturatesAtItsFriction) {
  const VehicleParameters p;
  const double load = 5000;
  EXPECT_DOUBLE_EQ(lateral_force(p, 0, load), 0);
  EXPECT_NEAR(lateral_force(p, -0.001, load), p.tyre_stiffness * 0.001 * load, 1);
  double most = 0;
  for (double slip = 0; slip < 0.5; slip += 0.001) {
    most = std::max(most, lateral_force(p, -slip, load));
  }
  EXPECT_NEAR(most, p.lateral_friction * load, 0.01 * load);
}

class OutOfBounds : public testing::Test {
 protected:
  double share(double x, double heading = std::numbers::pi / 2) {
    VehicleState state;
    state.x_m = x;
    state.y_m = 60;
    state.heading_rad = heading;
    return out_of_bounds_share(road_, state, {}, 50);
  }

 private:
  Road road_ = *make_road({{100, 10}, {100, 110}});
};

TEST_F(OutOfBounds, IsTheShareOfTheBoxOutsideOfTheRightLane) {
  EXPECT_NEAR(share(102), 0, 1e-9);
  EXPECT_NEAR(share(100), 0.5, 1e-9);
  EXPECT_NEAR(share(104), 0.5, 1e-9);
  EXPECT_NEAR(share(98), 1, 1e-9);
  EXPECT_NEAR(share(104 + 2.04 / 4), 0.75, 1e-9);
}

TEST_F(OutOfBounds, CountsACarAcrossTheLane) {
  // 4.69 m across a lane of 4 m.
  EXPECT_NEAR(share(102, 0), 0.69 / 4.69, 1e-9);
}

}  // namespace
}  // namespace jaywalk::lane
