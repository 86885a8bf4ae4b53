// SPDX-License-Identifier: Apache-2.0
#include "env/lane/drive.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/env_lane/profiles.h"

namespace jaywalk::lane {
namespace {

Road road_of(const Polyline& points) { return *make_road(points); }

class EachController : public testing::TestWithParam<std::string_view> {};

TEST_P(EachController, StaysInItsLaneOnAStraightRoad) {
  const DriveResult result = drive(road_of({{100, 10}, {100, 180}}), profile(GetParam()));
  EXPECT_EQ(result.end, DriveEnd::arrived);
  EXPECT_NEAR(result.max_out_of_bounds, 0, 1e-9);
  EXPECT_LT(result.max_lateral_error_m, 0.1);
  EXPECT_GT(result.time_s, 5);
}

TEST_P(EachController, DrivesTheSameRoadTheSameWay) {
  const Road road = random_roads(1).front();
  const DriveResult first = drive(road, profile(GetParam()));
  const DriveResult second = drive(road, profile(GetParam()));
  EXPECT_EQ(first.max_out_of_bounds, second.max_out_of_bounds);
  EXPECT_EQ(first.time_s, second.time_s);
}

TEST_P(EachController, KeepsToTheSpeedLimit) {
  DriveSettings settings = profile(GetParam());
  settings.speed_limit_mps = 8;
  const DriveResult result = drive(road_of({{100, 10}, {100, 180}}), settings);
  EXPECT_NEAR(result.max_speed_mps, 8, 0.3);
}

std::vector<std::string_view> controller_names() {
  std::vector<std::string_view> names;
  for (const ControllerKind& kind : controllers()) names.push_back(kind.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Controllers, EachController, testing::ValuesIn(controller_names()));

TEST(Drive, SamplesTwelveTimesASecondFromTheStart) {
  const DriveResult result = drive(road_of({{100, 10}, {100, 180}}), profile("paper-rate"));
  ASSERT_GT(result.samples.size(), 20U);
  EXPECT_DOUBLE_EQ(result.samples[0].car.y_m, 12.5);
  EXPECT_DOUBLE_EQ(result.samples[0].car.x_m, 102);
  EXPECT_NEAR(result.samples[12].time_s, 1, 0.006);
}

TEST(Drive, EndsOnceTheCarIsOutOfItsLane) {
  DriveSettings settings = profile("paper-rate");
  settings.values[1] = 0;  // it does not steer
  const DriveResult result = drive(road_of(integrate(std::vector<double>(6, 0.04))), settings);
  EXPECT_EQ(result.end, DriveEnd::out_of_bounds);
  EXPECT_GT(result.max_out_of_bounds, 0.95);
  EXPECT_GT(result.worst_arc_m, 5);
}

TEST(Drive, EndsWhenTheCarIsStuck) {
  DriveSettings settings = profile("stanley");
  settings.speed_limit_mps = 0.01;
  const DriveResult result = drive(road_of({{100, 10}, {100, 180}}), settings);
  EXPECT_EQ(result.end, DriveEnd::stuck);
  EXPECT_NEAR(result.time_s, 10, 0.2);
}

}  // namespace
}  // namespace jaywalk::lane
