// SPDX-License-Identifier: Apache-2.0
// How the models of automated vehicles drive, each on a straight road with one pedestrian.

#include "env/vehicle/vehicle.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "env/vehicle/careful_driver.h"

namespace jaywalk {
namespace {

constexpr double kPeriodS = 0.05;
constexpr double kCruiseMps = 9;

/// A vehicle with its front at 0 and a pedestrian who steps into its lane at some moment.
struct Drive {
  std::string model;
  double pedestrian_at_m = 40;
  double steps_in_at_s = 0;
  double leaves_at_s = 1e9;

  double stopped_at_m = 0;
  double lowest_mps = kCruiseMps;
  double last_mps = 0;
  double first_braking_s = -1;
  double hardest = 0;
  bool hit = false;

  void run(double seconds) {
    VehicleParameters parameters;
    parameters.model = model;
    const auto controller = make_controller(parameters);
    double front = 0;
    double speed = kCruiseMps;
    for (double time = 0; time < seconds; time += kPeriodS) {
      std::vector<SeenActor> actors;
      if (time >= steps_in_at_s && time < leaves_at_s) {
        actors.push_back({1, ActorKind::pedestrian, pedestrian_at_m - front, 5, 5.5, 0, 0});
        hit = hit || front > pedestrian_at_m;
      }
      const double acceleration = controller
                                      ->decide({.time_s = time,
                                                .period_s = kPeriodS,
                                                .speed_mps = speed,
                                                .cruise_mps = kCruiseMps,
                                                .left_m = 4.5,
                                                .right_m = 7.5,
                                                .lane_left_m = 3,
                                                .lane_right_m = 9,
                                                .actors = actors,
                                                .stop_lines = {}})
                                      .acceleration_mps2;
      if (acceleration < -0.5 && first_braking_s < 0) first_braking_s = time;
      hardest = std::max(hardest, -acceleration);
      speed = std::clamp(speed + acceleration * kPeriodS, 0.0, kCruiseMps);
      front += speed * kPeriodS;
      lowest_mps = std::min(lowest_mps, speed);
    }
    stopped_at_m = front;
    last_mps = speed;
  }
};

class Models : public testing::TestWithParam<const char*> {};

TEST_P(Models, StopForWhomTheySeeInTime) {
  Drive drive{.model = GetParam(), .pedestrian_at_m = 40};
  drive.run(30);
  EXPECT_FALSE(drive.hit);
  EXPECT_LT(drive.last_mps, 0.3);
  EXPECT_LT(drive.stopped_at_m, 40);
}

TEST_P(Models, DriveOnWhenTheWayIsClear) {
  Drive drive{.model = GetParam(), .pedestrian_at_m = 25, .leaves_at_s = 6};
  drive.run(30);
  EXPECT_LT(drive.lowest_mps, 8);
  EXPECT_NEAR(drive.last_mps, kCruiseMps, 0.5);
}

TEST_P(Models, CannotStopForWhomTheyMeetTooLate) {
  Drive drive{.model = GetParam(), .pedestrian_at_m = 40, .steps_in_at_s = 4.2};
  drive.run(10);
  EXPECT_TRUE(drive.hit) << "2 m ahead at 9 m/s";
}

TEST_P(Models, KeepTheirSpeedOnAnEmptyRoad) {
  Drive drive{.model = GetParam(), .steps_in_at_s = 1e9};
  drive.run(10);
  EXPECT_DOUBLE_EQ(drive.lowest_mps, kCruiseMps);
}

INSTANTIATE_TEST_SUITE_P(Vehicle, Models,
                         testing::Values("braking", "careful-competent", "aeb", "idm"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(CarefulDriver, PerceivesThenWaitsThenBrakesHarderAndHarder) {
  CarefulDriver driver;
  const SeenActor actor{.id = 1, .gap_m = 60, .left_m = 5, .right_m = 5.5};
  const auto braking = [&](double time_s) {
    return -driver
                .decide({.time_s = time_s,
                         .period_s = kPeriodS,
                         .speed_mps = kCruiseMps,
                         .cruise_mps = kCruiseMps,
                         .left_m = 4.5,
                         .right_m = 7.5,
                         .lane_left_m = 3,
                         .lane_right_m = 9,
                         .actors = {&actor, 1},
                         .stop_lines = {}})
                .acceleration_mps2;
  };
  for (int i = 0; i < 40; ++i) {
    // The mean of what grows from 1.15 s on, at 12.65 m/s3, to 0.774 g.
    const double middle = (i + 0.5) * kPeriodS;
    const double grown = 12.65 * (middle - 1.15);
    const double expected = std::clamp(grown, 0.0, 0.774 * 9.80665);
    EXPECT_NEAR(braking(i * kPeriodS), expected, 0.01) << i * kPeriodS << " s";
  }
}

TEST(CarefulDriver, TakesEighteenMetresToStopFromTwentyMilesPerHour) {
  // 10.35 m until braking begins, 4.94 m while it grows, 2.98 m at 0.774 g.
  Drive drive{.model = "careful-competent", .pedestrian_at_m = 60};
  drive.run(4);
  EXPECT_NEAR(drive.stopped_at_m, 18.27, 0.3) << "this test's car moves in steps";
  EXPECT_DOUBLE_EQ(drive.last_mps, 0);
}

TEST(Risks, BeginWithTheEdgeOfTheBoxOverTheLane) {
  const Strip lane{3, 9};
  const auto at = [](double left, double gap) {
    return SeenActor{.id = 1, .gap_m = gap, .left_m = left, .right_m = left + 0.5};
  };
  EXPECT_FALSE(is_risk(at(2.5, 10), lane)) << "it touches the lane";
  EXPECT_TRUE(is_risk(at(2.51, 10), lane)) << "its middle is still beside the lane";
  EXPECT_FALSE(is_risk(at(9, 10), lane));
  EXPECT_FALSE(is_risk(at(5, -1), lane)) << "it is beside the vehicle";
}

TEST(Braking, WaitsForItsReactionTime) {
  Drive drive{.model = "braking", .pedestrian_at_m = 18, .steps_in_at_s = 0};
  drive.run(3);
  EXPECT_NEAR(drive.first_braking_s, 0.5, kPeriodS);
}

TEST(EmergencyBraking, WaitsUntilACollisionIsNear) {
  Drive drive{.model = "aeb", .pedestrian_at_m = 40};
  drive.run(10);
  EXPECT_NEAR(drive.first_braking_s, (40 - 1.1 * kCruiseMps) / kCruiseMps, 2 * kPeriodS);
  EXPECT_DOUBLE_EQ(drive.hardest, 9);
}

TEST(VehicleModels, MindAClosedStopLine) {
  for (const std::string model : {"braking", "careful-competent", "aeb", "idm"}) {
    VehicleParameters parameters;
    parameters.model = model;
    const auto controller = make_controller(parameters);
    double front = 0;
    double speed = kCruiseMps;
    for (int i = 0; i < 600; ++i) {
      const StopLine line{40 - front, true};
      const double acceleration = controller
                                      ->decide({.time_s = i * kPeriodS,
                                                .period_s = kPeriodS,
                                                .speed_mps = speed,
                                                .cruise_mps = kCruiseMps,
                                                .left_m = 4.5,
                                                .right_m = 7.5,
                                                .lane_left_m = 3,
                                                .lane_right_m = 9,
                                                .actors = {},
                                                .stop_lines = {&line, 1}})
                                      .acceleration_mps2;
      speed = std::clamp(speed + acceleration * kPeriodS, 0.0, kCruiseMps);
      front += speed * kPeriodS;
    }
    EXPECT_LT(speed, 0.3) << model;
    EXPECT_LT(front, 40.5) << model;
  }
}

TEST(VehicleModels, OfTheScenarioAreNamedAndDescribed) {
  for (const VehicleModel& model : vehicle_models()) {
    EXPECT_EQ(find_vehicle_model(model.name), &model);
    EXPECT_FALSE(model.summary.empty());
  }
  EXPECT_EQ(find_vehicle_model("breaking"), nullptr);
}

}  // namespace
}  // namespace jaywalk
