// SPDX-License-Identifier: Apache-2.0
// What holds of every road: however it is drawn, its lines have as many points, its borders lie
// where the competition's do, and it does not change with where it lies.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/lane/path.h"
#include "env/lane/road.h"
#include "interpreter/support/random.h"

namespace jaywalk::lane {
namespace {

/// So many points that wander about.
Polyline wandering(SplitMix64& random, std::size_t points) {
  Polyline line{{0, 0}};
  double heading = 0;
  while (line.size() < points) {
    heading += 1.2 * (random.share() - 0.5);
    const double step = 5 + 20 * random.share();
    line.push_back(
        {line.back().x_m + step * std::cos(heading), line.back().y_m + step * std::sin(heading)});
  }
  return line;
}

class EveryRoad : public testing::TestWithParam<std::uint64_t> {
 protected:
  [[nodiscard]] Polyline points() const {
    SplitMix64 random(GetParam());
    return wandering(random, 2 + random.below(9));
  }
};

TEST_P(EveryRoad, HasThreeLinesOfAsManyPoints) {
  const auto road = make_road(points());
  ASSERT_TRUE(road);
  EXPECT_GE(road->middle.size(), 21U);
  EXPECT_EQ(road->left.size(), road->middle.size());
  EXPECT_EQ(road->right.size(), road->middle.size());
  EXPECT_EQ(lane_centre(*road).size(), road->middle.size());
  EXPECT_EQ(road->points.size(), points().size());
}

TEST_P(EveryRoad, IsEightMetresBroadAcrossItsMiddle) {
  const auto road = make_road(points());
  ASSERT_TRUE(road);
  const Polyline lane = lane_centre(*road);
  for (std::size_t i = 0; i + 1 < road->middle.size(); ++i) {
    const Point& at = road->middle[i];
    const Point& next = road->middle[i + 1];
    EXPECT_NEAR(distance(road->left[i], at), 4, 1e-9) << i;
    EXPECT_NEAR(distance(road->right[i], at), 4, 1e-9) << i;
    EXPECT_NEAR(distance(road->left[i], road->right[i]), 8, 1e-9) << i;
    EXPECT_NEAR(distance(lane[i], at), 2, 1e-9) << i;
    // The left border is on the left.
    const double side = (next.x_m - at.x_m) * (road->left[i].y_m - at.y_m) -
                        (next.y_m - at.y_m) * (road->left[i].x_m - at.x_m);
    EXPECT_GT(side, 0) << i;
  }
}

TEST_P(EveryRoad, BeginsAndEndsAtItsPoints) {
  const Polyline drawn = points();
  const auto line = interpolate(drawn);
  ASSERT_TRUE(line);
  EXPECT_NEAR(distance(line->front(), drawn.front()), 0, 1e-3) << "rounded to millimetres";
  double nearest_m = 1e9;
  for (const Point& point : *line) nearest_m = std::min(nearest_m, distance(point, drawn.back()));
  EXPECT_LT(nearest_m, 2e-3);
  EXPECT_GE(length(*line), distance(drawn.front(), drawn.back()) - 2e-3);
}

TEST_P(EveryRoad, IsRoundedToMillimetres) {
  const auto line = interpolate(points());
  ASSERT_TRUE(line);
  for (const Point& point : *line) {
    EXPECT_NEAR(point.x_m * 1000, std::rint(point.x_m * 1000), 1e-6);
    EXPECT_NEAR(point.y_m * 1000, std::rint(point.y_m * 1000), 1e-6);
  }
}

TEST_P(EveryRoad, IsTheSameElsewhere) {
  Polyline moved = points();
  for (Point& point : moved) point = {point.x_m + 64, point.y_m - 32};
  const auto here = interpolate(points());
  const auto there = interpolate(moved);
  ASSERT_EQ(here->size(), there->size());
  for (std::size_t i = 0; i < here->size(); ++i) {
    EXPECT_NEAR((*there)[i].x_m, (*here)[i].x_m + 64, 1.1e-3) << i;
    EXPECT_NEAR((*there)[i].y_m, (*here)[i].y_m - 32, 1.1e-3) << i;
  }
}

TEST_P(EveryRoad, FitsIntoAMapAsItIsOrNotAtAll) {
  const Polyline drawn = points();
  const auto [left, right] = std::ranges::minmax_element(drawn, {}, &Point::x_m);
  const auto [bottom, top] = std::ranges::minmax_element(drawn, {}, &Point::y_m);
  const double side = std::max(right->x_m - left->x_m, top->y_m - bottom->y_m) + 2 * 7;
  EXPECT_FALSE(fit_into_map(drawn, side - 0.01, 7));
  const auto fitted = fit_into_map(drawn, side + 0.01, 7);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(std::ranges::min(*fitted, {}, &Point::x_m).x_m, 7, 1e-9);
  EXPECT_NEAR(std::ranges::min(*fitted, {}, &Point::y_m).y_m, 7, 1e-9);
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    EXPECT_NEAR((*fitted)[i].x_m - (*fitted)[0].x_m, drawn[i].x_m - drawn[0].x_m, 1e-9);
    EXPECT_NEAR((*fitted)[i].y_m - (*fitted)[0].y_m, drawn[i].y_m - drawn[0].y_m, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, EveryRoad, testing::Range<std::uint64_t>(1, 25));

TEST(Roads, OfCurvaturesHaveStepsOfOneLengthAndTurnByTheirMeans) {
  SplitMix64 random(3);
  std::vector<double> curvatures(12);
  for (double& each : curvatures) each = 0.1 * (random.share() - 0.5);
  const CurvatureFrame frame{.step_m = 10, .start = {5, 6}, .heading_rad = 0.3};
  const Path path(integrate(curvatures, frame));
  ASSERT_EQ(path.size(), 13U);
  EXPECT_NEAR(path.heading(0), 0.3, 1e-12);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    EXPECT_NEAR(distance(path.point(i), path.point(i + 1)), 10, 1e-9);
    if (i == 0) continue;
    EXPECT_NEAR(wrapped(path.heading(i) - path.heading(i - 1)),
                10 * (curvatures[i] + curvatures[i - 1]) / 2, 1e-9)
        << i;
  }
}

TEST(Roads, OfOppositeCurvaturesAreMirrored) {
  const std::vector<double> curvatures{0.02, -0.03, 0.05, 0.01};
  std::vector<double> opposite = curvatures;
  for (double& each : opposite) each = -each;
  const Polyline road = integrate(curvatures);
  const Polyline mirrored = integrate(opposite);
  for (std::size_t i = 0; i < road.size(); ++i) {
    EXPECT_NEAR(mirrored[i].x_m - 100, 100 - road[i].x_m, 1e-9) << i;
    EXPECT_NEAR(mirrored[i].y_m, road[i].y_m, 1e-9) << i;
  }
}

TEST(Roads, WithoutASplineAreNone) {
  EXPECT_FALSE(interpolate(Polyline{}));
  EXPECT_FALSE(interpolate(Polyline{{1, 1}}));
  EXPECT_FALSE(make_road({{1, 1}, {1, 1}, {5, 5}}));
  EXPECT_FALSE(interpolate(Polyline{{0, 0}, {1e9, 0}})) << "nobody wants so many points";
  EXPECT_FALSE(interpolate(Polyline{{0, 0}, {std::nan(""), 0}, {5, 5}}));
  EXPECT_FALSE(fit_into_map({}, 200));
}

TEST(Roads, MeasureTheirLengthPieceByPiece) {
  EXPECT_DOUBLE_EQ(length(Polyline{{0, 0}, {3, 4}, {3, 10}}), 11);
  EXPECT_DOUBLE_EQ(length(Polyline{{7, 7}}), 0);
  EXPECT_DOUBLE_EQ(length(Polyline{}), 0);
}

}  // namespace
}  // namespace jaywalk::lane
