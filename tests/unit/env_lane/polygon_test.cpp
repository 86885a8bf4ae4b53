// SPDX-License-Identifier: Apache-2.0
#include "env/lane/polygon.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace jaywalk::lane {
namespace {

struct Segment {
  Point from, to;
};

bool touch(const Segment& a, const Segment& b) {
  return segments_touch(a.from, a.to, b.from, b.to);
}

/// Corners of a small grid, so that many segments meet at their ends or lie on one line.
class Points {
 public:
  Point next() {
    const double x = coordinate_(random_);
    return {x, static_cast<double>(coordinate_(random_))};
  }
  Segment segment() {
    const Point from = next();
    return {from, next()};
  }

 private:
  std::mt19937_64 random_{7};
  std::uniform_int_distribution<int> coordinate_{0, 5};
};

TEST(Cross, IsPositiveCounterClockwise) {
  EXPECT_EQ(cross({0, 0}, {2, 0}, {0, 3}), 6);
  EXPECT_EQ(cross({0, 0}, {0, 3}, {2, 0}), -6);
  EXPECT_EQ(cross({1, 1}, {2, 2}, {5, 5}), 0);
}

TEST(SegmentsTouch, WhereTheyCross) {
  EXPECT_TRUE(touch({{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}));
  EXPECT_FALSE(touch({{0, 0}, {1, 1}}, {{0, 4}, {4, 0}}));
}

TEST(SegmentsTouch, WhereOneEndsOnTheOther) {
  EXPECT_TRUE(touch({{0, 0}, {4, 0}}, {{2, 0}, {2, 3}}));
  EXPECT_TRUE(touch({{0, 0}, {4, 0}}, {{4, 0}, {5, 3}}));
  EXPECT_FALSE(touch({{0, 0}, {4, 0}}, {{5, 0}, {5, 3}})) << "on its line but beyond its end";
}

TEST(SegmentsTouch, OnOneLineWhereTheyOverlap) {
  EXPECT_TRUE(touch({{0, 0}, {4, 2}}, {{2, 1}, {6, 3}}));
  EXPECT_TRUE(touch({{0, 0}, {6, 3}}, {{2, 1}, {4, 2}})) << "one within the other";
  EXPECT_FALSE(touch({{0, 0}, {2, 1}}, {{4, 2}, {6, 3}}));
}

TEST(SegmentsTouch, NeverWhereTheyAreParallel) {
  EXPECT_FALSE(touch({{0, 0}, {4, 0}}, {{0, 1}, {4, 1}}));
}

TEST(SegmentsTouch, WhicheverComesFirstAndWhicheverWayTheyRun) {
  Points points;
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Segment a = points.segment();
    const Segment b = points.segment();
    const bool expected = touch(a, b);
    touching += expected;
    EXPECT_EQ(touch(b, a), expected);
    EXPECT_EQ(touch({a.to, a.from}, b), expected);
    EXPECT_EQ(touch({a.to, a.from}, {b.to, b.from}), expected);
  }
  EXPECT_GT(touching, 200);
  EXPECT_LT(touching, 1800);
}

TEST(SegmentsTouch, WhereverThePlaneIsTurnedOrMoved) {
  Points points;
  const auto turned = [](const Point& p) { return Point{7 - p.y_m, p.x_m - 3}; };
  for (int i = 0; i < 2000; ++i) {
    const Segment a = points.segment();
    const Segment b = points.segment();
    EXPECT_EQ(touch({turned(a.from), turned(a.to)}, {turned(b.from), turned(b.to)}), touch(a, b));
  }
}

TEST(Contains, SaysWhetherAPointIsInside) {
  const std::array<Point, 4> square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  EXPECT_TRUE(contains(square, {2, 2}));
  EXPECT_FALSE(contains(square, {5, 2}));
  EXPECT_FALSE(contains(square, {-1, 2}));
  EXPECT_FALSE(contains(square, {2, 5}));
}

TEST(Contains, KnowsTheHollowOfAPolygon) {
  const std::array<Point, 5> arrow{{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}};
  EXPECT_FALSE(contains(arrow, {2, 3}));
  EXPECT_TRUE(contains(arrow, {0.5, 1}));
  EXPECT_TRUE(contains(arrow, {3.5, 1}));
}

TEST(Contains, IsOneSideOfEachEdgeOfATriangle) {
  Points points;
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::array<Point, 3> triangle{points.next(), points.next(), points.next()};
    // Not on any line through grid points of this size.
    const Point at{points.next().x_m + 0.1234, points.next().y_m + 0.0567};
    const bool left = cross(triangle[0], triangle[1], at) > 0;
    const bool expected = cross(triangle[0], triangle[1], triangle[2]) != 0 &&
                          (cross(triangle[1], triangle[2], at) > 0) == left &&
                          (cross(triangle[2], triangle[0], at) > 0) == left;
    inside += expected;
    EXPECT_EQ(contains(triangle, at), expected);
  }
  EXPECT_GT(inside, 50);
}

TEST(Quads, AreSimpleUnlessTheirSidesCrossOrTheyAreFlat) {
  EXPECT_TRUE(is_simple({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  EXPECT_TRUE(is_simple({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}})) << "clockwise, too";
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}})) << "a bow tie";
  EXPECT_FALSE(is_simple({{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}));
}

/// A road along these points of its middle, without a curve through them.
Road along(const Polyline& middle) { return road_along(middle, middle); }

TEST(Overlaps, NeverOnAStraightRoad) {
  EXPECT_FALSE(overlaps_itself(along({{0, 0}, {10, 0}, {20, 0}, {30, 0}})));
}

TEST(Overlaps, NotInAGentleCurve) {
  EXPECT_FALSE(overlaps_itself(*make_road(integrate(std::vector<double>(8, 0.03)))));
}

TEST(Overlaps, WhereACurveIsTighterThanTheRoadIsBroad) {
  Polyline middle;
  for (int i = 0; i <= 12; ++i) middle.push_back({2 * std::cos(0.25 * i), 2 * std::sin(0.25 * i)});
  EXPECT_TRUE(overlaps_itself(along(middle)));
}

TEST(Overlaps, WhereTheRoadCrossesItself) {
  EXPECT_TRUE(
      overlaps_itself(*make_road({{0, 0}, {60, 0}, {90, 30}, {60, 60}, {30, 30}, {30, -40}})));
}

TEST(Overlaps, WhereOneStretchLiesWithinTheOneBefore) {
  const Road back{.points = {},
                  .middle = {{0, 1}, {4, 1}, {1, 1}},
                  .left = {{0, 2}, {4, 2}, {1, 1.5}},
                  .right = {{0, 0}, {4, 0}, {1, 0.5}}};
  EXPECT_TRUE(overlaps_itself(back));
  Road on = back;
  on.middle[2] = {7, 1};
  on.left[2] = {7, 1.5};
  on.right[2] = {7, 0.5};
  EXPECT_FALSE(overlaps_itself(on)) << "they share their common side alone";
}

TEST(Overlaps, WhereTheRoadComesBackTooNearBesideItself) {
  const auto hairpin = [](double apart) {
    Polyline middle;
    for (int i = 0; i <= 20; ++i) middle.push_back({2.0 * i, 0});
    const double radius = apart / 2;
    for (int i = 1; i < 20; ++i) {
      const double angle = i * 0.15707963;
      middle.push_back({40 + radius * std::sin(angle), radius - radius * std::cos(angle)});
    }
    for (int i = 20; i >= 0; --i) middle.push_back({2.0 * i, apart});
    return middle;
  };
  EXPECT_FALSE(overlaps_itself(along(hairpin(16))));
  EXPECT_TRUE(overlaps_itself(along(hairpin(7.5)))) << "half a metre less than its breadth";
}

TEST(Overlaps, WhicheverWayTheRoadIsDrawn) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> curvature(-0.14, 0.14);
  int overlapping = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<double> curvatures(16);
    for (double& each : curvatures) each = curvature(random);
    const Polyline middle = make_road(integrate(curvatures))->middle;
    Polyline mirrored = middle;
    for (Point& point : mirrored) point.x_m = -point.x_m;
    const bool expected = overlaps_itself(along(middle));
    overlapping += expected;
    EXPECT_EQ(overlaps_itself(along(mirrored)), expected) << i;
  }
  EXPECT_GT(overlapping, 5);
  EXPECT_LT(overlapping, 55);
}

TEST(Outline, GoesForthOnTheLeftAndBackOnTheRight) {
  const Road road = along({{0, 0}, {10, 0}});
  const Polyline ring = outline(road);
  ASSERT_EQ(ring.size(), 4U);
  EXPECT_EQ(ring[0].y_m, 4);
  EXPECT_EQ(ring[1].x_m, 10);
  EXPECT_EQ(ring[2].x_m, 10);
  EXPECT_EQ(ring[2].y_m, -4);
  EXPECT_EQ(ring[3].x_m, 0);
}

}  // namespace
}  // namespace jaywalk::lane
