// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/simulator/sumo/sumo_network.h"

namespace jaywalk {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

void expect_pose(const RoadFrame::Pose& pose, double x, double y, double heading) {
  EXPECT_NEAR(pose.x_m, x, 1e-9);
  EXPECT_NEAR(pose.y_m, y, 1e-9);
  EXPECT_NEAR(std::remainder(pose.heading_rad - heading, 4 * kQuarter), 0, 1e-9);
}

TEST(FrameOfALine, WithoutALineIsThePlaneItself) {
  const RoadFrame frame;
  expect_pose(frame.to_map({3, 4, 1}), 3, 4, 1);
  expect_pose(frame.to_world({3, 4, 1}), 3, 4, 1);
  EXPECT_EQ(frame.length_m(), 0);
}

TEST(FrameOfALine, LaysTheRoadAlongALine) {
  // Eastwards from (100, 50); the world's y = 0 is at 10 m, its x = 6 on the line.
  const RoadFrame frame({{100, 50}, {200, 50}}, 10, 6);
  expect_pose(frame.to_map({6, 0, kQuarter}), 110, 50, 0);
  expect_pose(frame.to_map({8, 20, kQuarter}), 130, 48, 0);
  expect_pose(frame.to_map({6, 0, 0}), 110, 50, -kQuarter);
  EXPECT_EQ(frame.length_m(), 100);
}

TEST(FrameOfALine, FollowsALineThatBends) {
  // 10 m to the east, then to the north.
  const RoadFrame frame({{0, 0}, {10, 0}, {10, 30}}, 0, 0);
  expect_pose(frame.to_map({0, 5, kQuarter}), 5, 0, 0);
  expect_pose(frame.to_map({0, 15, kQuarter}), 10, 5, kQuarter);
  expect_pose(frame.to_map({2, 15, kQuarter}), 12, 5, kQuarter);
  EXPECT_EQ(frame.length_m(), 40);
}

TEST(FrameOfALine, GoesStraightOnBeforeAndBehindTheLine) {
  const RoadFrame frame({{0, 0}, {10, 0}, {10, 30}}, 0, 0);
  expect_pose(frame.to_map({0, -5, kQuarter}), -5, 0, 0);
  expect_pose(frame.to_map({0, 50, kQuarter}), 10, 40, kQuarter);
  expect_pose(frame.to_world({-5, 0, 0}), 0, -5, kQuarter);
  expect_pose(frame.to_world({10, 40, kQuarter}), 0, 50, kQuarter);
}

TEST(FrameOfALine, FindsItsWayBack) {
  const RoadFrame frame({{0, 0}, {40, 0}, {70, 40}, {70, 90}}, 12, 3);
  for (const double along : {-20.0, 0.0, 15.0, 40.0, 60.0, 100.0, 150.0}) {
    for (const double aside : {2.0, 3.0, 4.5}) {
      const RoadFrame::Pose world{aside, along, 1.2};
      const RoadFrame::Pose back = frame.to_world(frame.to_map(world));
      EXPECT_NEAR(back.x_m, world.x_m, 1e-6) << along;
      EXPECT_NEAR(back.y_m, world.y_m, 1e-6) << along;
      EXPECT_NEAR(std::remainder(back.heading_rad - 1.2, 4 * kQuarter), 0, 1e-9) << along;
    }
  }
}

TEST(FrameOfALine, TakesTheNearestStretchOfALineThatComesBack) {
  // A hairpin: up at x = 0, down at x = 20.
  const RoadFrame frame({{0, 0}, {0, 100}, {20, 100}, {20, 0}}, 0, 0);
  EXPECT_NEAR(frame.to_world({1, 50, kQuarter}).y_m, 50, 1e-9);
  EXPECT_NEAR(frame.to_world({19, 50, -kQuarter}).y_m, 170, 1e-9);
}

TEST(FrameOfALine, PassesOverPointsThatAreTheSame) {
  const RoadFrame frame({{0, 0}, {0, 0}, {10, 0}, {10, 0.0001}, {10, 10}}, 0, 0);
  EXPECT_NEAR(frame.length_m(), 20, 1e-3);
}

}  // namespace
}  // namespace jaywalk
