// How the models of automated vehicles drive, each on a straight road with one pedestrian.

#include "env/vehicle/vehicle.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

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

TEST(CarefulDriver, BrakesWithThreeQuartersOfGravityAfterPointFourSeconds) {
  Drive drive{.model = "careful-competent", .pedestrian_at_m = 60, .steps_in_at_s = 1};
  drive.run(3);
  EXPECT_NEAR(drive.first_braking_s, 1.4, kPeriodS);
  EXPECT_NEAR(drive.hardest, 0.774 * 9.80665, 1e-9);
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
