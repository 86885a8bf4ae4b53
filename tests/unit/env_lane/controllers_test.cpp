// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "env/lane/controller.h"
#include "env/lane/controllers/path_follower.h"

namespace jaywalk::lane {
namespace {

/// A controller with its default values on a road along y; the lane's middle is at x = 2.
class EachLaneKeeper : public testing::TestWithParam<std::string_view> {
 protected:
  [[nodiscard]] Command command(VehicleState state, double limit_mps = 15) const {
    const ControllerKind& kind = *find_controller(GetParam());
    std::vector<double> values;
    for (const NumberParameter& parameter : kind.parameters) values.push_back(parameter.value);
    return kind
        .make({.road = road_,
               .vehicle = vehicle_,
               .values = values,
               .speed_limit_mps = limit_mps,
               .start_m = 2.5})
        ->command(state);
  }

  static VehicleState at(double x, double turned = 0, double speed = 10) {
    return {.x_m = x, .y_m = 60, .heading_rad = std::numbers::pi / 2 + turned, .speed_mps = speed};
  }

  Road road_ = *make_road({{0, 0}, {0, 180}});
  VehicleParameters vehicle_;
};

TEST_P(EachLaneKeeper, SteersStraightInTheMiddleOfItsLane) {
  EXPECT_NEAR(command(at(2)).steering_rad, 0, 1e-6);
}

TEST_P(EachLaneKeeper, SteersBackToTheMiddle) {
  EXPECT_GT(command(at(3)).steering_rad, 0.005) << "to the left, from its right";
  EXPECT_LT(command(at(1)).steering_rad, -0.005);
}

TEST_P(EachLaneKeeper, SteersAgainstAWrongHeading) {
  EXPECT_LT(command(at(2, 0.1)).steering_rad, -0.005);
  EXPECT_GT(command(at(2, -0.1)).steering_rad, 0.005);
}

TEST_P(EachLaneKeeper, SteersAlikeToEitherSide) {
  EXPECT_NEAR(command(at(2.7)).steering_rad, -command(at(1.3)).steering_rad, 1e-6);
}

TEST_P(EachLaneKeeper, SteersNoFurtherThanTheCarCan) {
  vehicle_.most_steering_rad = 0.01;
  EXPECT_DOUBLE_EQ(command(at(3.5)).steering_rad, 0.01);
  EXPECT_DOUBLE_EQ(command(at(0.5)).steering_rad, -0.01);
}

TEST_P(EachLaneKeeper, AcceleratesUpToTheSpeedLimit) {
  EXPECT_GT(command(at(2, 0, 10)).acceleration, 0);
  EXPECT_NEAR(command(at(2, 0, 15)).acceleration, 0, 1e-6);
  EXPECT_LT(command(at(2, 0, 17)).acceleration, 0);
}

TEST_P(EachLaneKeeper, AcceleratesAndBrakesAsHardAsItsParametersAllow) {
  std::map<std::string_view, double> values;
  for (const NumberParameter& each : find_controller(GetParam())->parameters) {
    values[each.name] = each.value;
  }
  EXPECT_DOUBLE_EQ(command(at(2, 0, 0)).acceleration, values.at("most_acceleration"));
  EXPECT_DOUBLE_EQ(command(at(2, 0, 60)).acceleration, -values.at("most_braking"));
}

TEST_P(EachLaneKeeper, HasDefaultsWithinTheirBounds) {
  std::set<std::string_view> names;
  for (const NumberParameter& parameter : find_controller(GetParam())->parameters) {
    EXPECT_GE(parameter.value, parameter.least) << parameter.name;
    EXPECT_LE(parameter.value, parameter.most) << parameter.name;
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " twice";
    EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachLaneKeeper, testing::ValuesIn([] {
                           std::vector<std::string_view> names;
                           for (const ControllerKind& kind : controllers()) {
                             names.push_back(kind.name);
                           }
                           return names;
                         }()));

TEST(Stanley, SteersByItsHeadingAndThePlaceOfItsFrontAxle) {
  const Road road = *make_road({{0, 0}, {0, 180}});
  const VehicleParameters vehicle;
  const ControllerKind& kind = *find_controller("stanley");
  std::vector<double> values;
  for (const NumberParameter& parameter : kind.parameters) values.push_back(parameter.value);
  const VehicleState turned{
      .x_m = 2, .y_m = 60, .heading_rad = std::numbers::pi / 2 + 0.1, .speed_mps = 10};
  // The vehicle is on the left side of the lane's middle, by the sine of the angle; gain 2.5,
  // softening 1.
  const double left = vehicle.front_axle_m * std::sin(0.1);
  EXPECT_NEAR(kind.make({road, vehicle, values, 15, 2.5})->command(turned).steering_rad,
              -0.1 - std::atan(2.5 * left / (1 + 10)), 1e-6);
}

TEST(FindController, IsNullForAnUnknownName) {
  EXPECT_EQ(find_controller("nobody"), nullptr);
  EXPECT_EQ(find_controller("stanley")->name, "stanley");
}

/// A follower of the line from (0, 0) to (100, 0), with all its parameters at 1.
class PathFollowerTest : public testing::Test {
 protected:
  Road road_ = *make_road({{0, 0}, {0, 180}});
  VehicleParameters vehicle_;
  std::vector<double> values_ = std::vector<double>(PathFollower::kParameters, 1);
  PathFollower follower() const {
    Polyline line;
    for (int i = 0; i <= 100; ++i) line.push_back({static_cast<double>(i), 0});
    return PathFollower({road_, vehicle_, values_, 10, 0}, line);
  }
};

TEST_F(PathFollowerTest, KnowsHowFarItIsToTheLeft) {
  PathFollower follows = follower();
  follows.move_to({30.2, 1.5});
  EXPECT_EQ(follows.near(), 30U);
  EXPECT_DOUBLE_EQ(follows.lateral_m(), 1.5);
  follows.move_to({31, -0.5});
  EXPECT_DOUBLE_EQ(follows.lateral_m(), -0.5);
  EXPECT_DOUBLE_EQ(follows.heading(), 0);
}

TEST_F(PathFollowerTest, TakesItsParametersFromTheLastValues) {
  values_.insert(values_.begin(), {100, 200});  // a controller's own
  values_[2 + PathFollower::kLatency] = 0.25;
  values_[2 + PathFollower::kSteeringLag] = 0.5;
  values_[2 + PathFollower::kSteeringRate] = 0.75;
  const Actuator actuator = follower().actuator();
  EXPECT_EQ(actuator.latency_s, 0.25);
  EXPECT_EQ(actuator.steering_lag_s, 0.5);
  EXPECT_EQ(actuator.steering_rate, 0.75);
}

TEST_F(PathFollowerTest, BoundsSteeringAndAcceleration) {
  values_[PathFollower::kMostAcceleration] = 3;
  values_[PathFollower::kMostBraking] = 2;
  values_[PathFollower::kSpeedGain] = 10;
  PathFollower follows = follower();
  follows.move_to({10, 0});
  EXPECT_DOUBLE_EQ(follows.command(9, 0).steering_rad, vehicle_.most_steering_rad);
  EXPECT_DOUBLE_EQ(follows.command(-9, 0).steering_rad, -vehicle_.most_steering_rad);
  EXPECT_DOUBLE_EQ(follows.command(0, 0).acceleration, 3);
  EXPECT_DOUBLE_EQ(follows.command(0, 40).acceleration, -2);
}

}  // namespace
}  // namespace jaywalk::lane
