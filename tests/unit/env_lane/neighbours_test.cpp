// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "env/lane/polygon.h"

// Two neighbouring quadrilaterals of a road against the area that they have in common, which is
// found here in another way: both are cut into triangles, which are clipped by each other.

namespace jaywalk::lane {
namespace {

using Triangle = std::array<Point, 3>;

Triangle counter_clockwise(Triangle triangle) {
  if (cross(triangle[0], triangle[1], triangle[2]) < 0) std::swap(triangle[1], triangle[2]);
  return triangle;
}

/// The two halves of a simple quadrilateral, by the diagonal that lies within it.
std::array<Triangle, 2> halves(const Quad& quad) {
  const auto& [a, b, c, d] = quad;
  const bool first = (cross(a, b, c) > 0) == (cross(a, c, d) > 0);
  if (first) return {counter_clockwise({a, b, c}), counter_clockwise({a, c, d})};
  return {counter_clockwise({b, c, d}), counter_clockwise({b, d, a})};
}

/// The part of a polygon on the left side of the line from one point to another.
Polyline left_of(const Point& from, const Point& to, const Polyline& polygon) {
  Polyline rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& here = polygon[i];
    const Point& next = polygon[(i + 1) % polygon.size()];
    const double at_here = cross(from, to, here);
    const double at_next = cross(from, to, next);
    if (at_here >= 0) rest.push_back(here);
    if ((at_here > 0 && at_next < 0) || (at_here < 0 && at_next > 0)) {
      const double share = at_here / (at_here - at_next);
      rest.push_back(
          {here.x_m + share * (next.x_m - here.x_m), here.y_m + share * (next.y_m - here.y_m)});
    }
  }
  return rest;
}

double area(const Polyline& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += cross(polygon[0], polygon[i - 1], polygon[i]);
  }
  return twice / 2;
}

double common_area(const Quad& a, const Quad& b) {
  double sum = 0;
  for (const Triangle& one : halves(a)) {
    for (const Triangle& other : halves(b)) {
      Polyline rest(one.begin(), one.end());
      for (std::size_t i = 0; i < 3; ++i) rest = left_of(other[i], other[(i + 1) % 3], rest);
      sum += area(rest);
    }
  }
  return sum;
}

/// A road of two stretches: the borders' three points.
Road of_two(const Polyline& left, const Polyline& right) {
  Road road{.points = {}, .middle = {}, .left = left, .right = right};
  for (std::size_t i = 0; i < 3; ++i) {
    road.middle.push_back({(left[i].x_m + right[i].x_m) / 2, (left[i].y_m + right[i].y_m) / 2});
  }
  return road;
}

Quad stretch(const Road& road, std::size_t i) {
  return {road.left[i], road.left[i + 1], road.right[i + 1], road.right[i]};
}

class Neighbours : public testing::Test {
 protected:
  Point point() { return {coordinate_(random_), coordinate_(random_)}; }

 private:
  std::mt19937_64 random_{11};
  std::uniform_real_distribution<double> coordinate_{0, 10};
};

TEST_F(Neighbours, OverlapWhereTheyHaveAnAreaInCommon) {
  int overlapping = 0;
  int apart = 0;
  while (overlapping + apart < 3000) {
    const Road road = of_two({point(), point(), point()}, {point(), point(), point()});
    const Quad a = stretch(road, 0);
    const Quad b = stretch(road, 1);
    if (!is_simple(a) || !is_simple(b)) continue;
    const double common = common_area(a, b);
    // By the last digits alone nothing is said either way.
    if (common > 0 && common < 1e-9) continue;
    const bool expected = common > 0;
    ++(expected ? overlapping : apart);
    EXPECT_EQ(overlaps_itself(road), expected) << common << " m2, after " << overlapping + apart;
  }
  EXPECT_GT(overlapping, 300);
  EXPECT_GT(apart, 300);
}

TEST_F(Neighbours, OverlapWhicheverEndOfTheRoadIsItsFirst) {
  for (int i = 0; i < 2000; ++i) {
    const Road road = of_two({point(), point(), point()}, {point(), point(), point()});
    const auto turned = [](Polyline line) {
      std::ranges::reverse(line);
      return line;
    };
    EXPECT_EQ(overlaps_itself(of_two(turned(road.right), turned(road.left))), overlaps_itself(road))
        << i;
    EXPECT_EQ(overlaps_itself(of_two(road.right, road.left)), overlaps_itself(road))
        << i << ", with the borders exchanged";
  }
}

TEST_F(Neighbours, ShareTheirSideAloneOnEachSideOfIt) {
  EXPECT_FALSE(overlaps_itself(of_two({{0, 2}, {4, 2}, {8, 2}}, {{0, 0}, {4, 0}, {8, 0}})));
  // The corner at the outside of a bend is drawn out, the one at the inside hardly moves on.
  EXPECT_FALSE(overlaps_itself(of_two({{0, 2}, {4, 2}, {4.1, 2.5}}, {{0, 0}, {4, 0}, {9, 0}})));
}

// Each row folds the second stretch back over the first in another way: by its last corner on the
// left, by that on the right, across the whole of it, or around it.
TEST_F(Neighbours, OverlapHoweverTheSecondIsFoldedBack) {
  const Polyline left{{0, 2}, {4, 2}};
  const Polyline right{{0, 0}, {4, 0}};
  const auto folded = [&](Point to_left, Point to_right) {
    Road road = of_two({left[0], left[1], to_left}, {right[0], right[1], to_right});
    EXPECT_TRUE(is_simple(stretch(road, 1)));
    return overlaps_itself(road);
  };
  EXPECT_TRUE(folded({2, 1.5}, {6, -6})) << "the left corner lies within";
  EXPECT_TRUE(folded({6, 8}, {2, 0.5})) << "the right corner lies within";
  EXPECT_TRUE(folded({1, 5}, {1, -3})) << "its sides go around the first one's";
  EXPECT_TRUE(folded({-2, 3}, {-2, -1})) << "the first one lies within the second";
  EXPECT_FALSE(folded({4.5, 6}, {7, 0}));
}

}  // namespace
}  // namespace jaywalk::lane
