// SPDX-License-Identifier: Apache-2.0
#include "env/lane/road.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace jaywalk::lane {
namespace {

TEST(Road, BeginsStraightUpFromTheMiddleOfTheMapsLowerEdge) {
  const Polyline points = integrate(std::vector<double>{0.01, 0.03, 0.03});
  ASSERT_EQ(points.size(), 4U);
  EXPECT_DOUBLE_EQ(points[0].x_m, 100);
  EXPECT_DOUBLE_EQ(points[0].y_m, 10);
  EXPECT_NEAR(points[1].x_m, 100, 1e-12);
  EXPECT_NEAR(points[1].y_m, 25, 1e-12);
  // 15 m times the mean of 0.01 and 0.03 turn the heading by 0.3.
  const double heading = std::numbers::pi / 2 + 0.3;
  EXPECT_NEAR(points[2].x_m, 100 + 15 * std::cos(heading), 1e-9);
  EXPECT_NEAR(points[2].y_m, 25 + 15 * std::sin(heading), 1e-9);
}

TEST(Road, HasABorderFourMetresAwayOnEachSide) {
  const auto road = make_road({{0, 0}, {0, 100}});
  ASSERT_TRUE(road);
  ASSERT_EQ(road->left.size(), road->middle.size());
  ASSERT_EQ(road->right.size(), road->middle.size());
  for (std::size_t i = 0; i < road->middle.size(); ++i) {
    EXPECT_NEAR(road->left[i].x_m, -4, 1e-9);
    EXPECT_NEAR(road->right[i].x_m, 4, 1e-9);
  }
  EXPECT_NEAR(lane_centre(*road)[50].x_m, 2, 1e-9);
}

TEST(Road, IsInterpolatedAboutOncePerMetre) {
  const auto line = interpolate(std::vector<Point>{{0, 0}, {0, 100.5}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->size(), 101U);
  EXPECT_NEAR((*line)[1].y_m, 1.005, 1e-9);
}

TEST(Road, IsInterpolatedInAtLeastTwentySteps) {
  const auto line = interpolate(std::vector<Point>{{0, 0}, {0, 5}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->size(), 21U);
}

TEST(Road, FitsIntoAMapOrDoesNot) {
  const auto moved = fit_into_map({{-50, 3}, {50, 90}}, 200);
  ASSERT_TRUE(moved);
  EXPECT_DOUBLE_EQ(moved->front().x_m, 10);
  EXPECT_DOUBLE_EQ(moved->front().y_m, 10);
  EXPECT_FALSE(fit_into_map({{0, 0}, {0, 181}}, 200));
}

}  // namespace
}  // namespace jaywalk::lane
