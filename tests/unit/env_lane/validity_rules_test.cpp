// SPDX-License-Identifier: Apache-2.0
// Each rule of the competition by itself, at its edge, and which of two broken ones is named.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/lane/validity.h"

namespace jaywalk::lane {
namespace {

constexpr std::string_view kTooSharp = "The road is too sharp";
constexpr std::string_view kTooShort = "The road is not long enough.";
constexpr std::string_view kIntersects = "The road is self-intersecting";

/// Part of a circle around the map's middle, a point each 10 m or so.
Polyline arc(double radius, double angle) {
  Polyline points;
  const int parts = std::max(6, static_cast<int>(radius * angle / 10));
  for (int i = 0; i <= parts; ++i) {
    const double at = angle * i / parts;
    points.push_back({100 + radius * std::cos(at), 100 + radius * std::sin(at)});
  }
  return points;
}

TEST(Rules, WantRadiiOfFortySevenFeet) {
  EXPECT_EQ(validate(arc(16, 2.5)).message, "");
  EXPECT_EQ(validate(arc(14, 2.5)).message, kTooSharp) << "47 ft are 14.33 m";
  EXPECT_EQ(validate(arc(14, 2.5), {.least_radius_ft = 43}).message, "");
  EXPECT_EQ(validate(arc(16, 2.5), {.least_radius_ft = 55}).message, kTooSharp);
}

TEST(Rules, WantMoreThanTwentyMetres) {
  EXPECT_EQ(validate({{100, 100}, {100, 121}}).message, "");
  EXPECT_EQ(validate({{100, 100}, {100, 119}}).message, kTooShort);
  EXPECT_EQ(validate({{100, 100}, {100, 149}}, {.least_length_m = 50}).message, kTooShort);
  EXPECT_EQ(validate({{100, 100}, {100, 151}}, {.least_length_m = 50}).message, "");
}

TEST(Rules, WantTheBordersWithinTheMapToo) {
  EXPECT_EQ(validate({{5, 20}, {5, 150}}).message, "");
  EXPECT_EQ(validate({{3, 20}, {3, 150}}).message, kLeavesMap) << "the left border is at -1 m";
  EXPECT_EQ(validate({{197, 20}, {197, 150}}).message, kLeavesMap);
  EXPECT_EQ(validate({{100, 20}, {100, 199}}).message, "") << "the road ends before the edge";
  EXPECT_EQ(validate({{100, 20}, {100, 201}}).message, kLeavesMap);
  EXPECT_EQ(validate({{100, 20}, {100, 201}}, {.map_m = 250}).message, "");
}

TEST(Rules, WantARoadThatDoesNotMeetItself) {
  // Around and over its own beginning.
  EXPECT_EQ(validate(arc(30, 2 * std::numbers::pi + 0.3)).message, kIntersects);
  EXPECT_EQ(validate(arc(30, 1.7 * std::numbers::pi)).message, "");
}

TEST(Rules, NameTheFirstThatIsBrokenInTheCompetitionsOrder) {
  const Polyline short_and_outside{{-3, 20}, {-3, 30}};
  EXPECT_EQ(validate(short_and_outside).message, kLeavesMap);
  Polyline crossing_and_outside = arc(30, 2 * std::numbers::pi + 0.3);
  for (Point& point : crossing_and_outside) point.x_m -= 80;
  EXPECT_EQ(validate(crossing_and_outside).message, kLeavesMap);
  EXPECT_EQ(validate(arc(8, 2 * std::numbers::pi + 0.6)).message, kIntersects)
      << "it is too sharp, too";
  EXPECT_EQ(validate(arc(6, 1.5), {.least_length_m = 30}).message, kTooShort)
      << "it is too sharp, too";
}

TEST(Rules, KeepTheRoadThatTheyRefuse) {
  const RoadVerdict verdict = validate({{100, 100}, {100, 119}});
  EXPECT_FALSE(verdict.valid());
  ASSERT_TRUE(verdict.road);
  EXPECT_EQ(verdict.road->points.size(), 2U);
  EXPECT_FALSE(validate({{100, 100}}).road) << "of one point there is none";
}

TEST(Rules, FindThatNothingIsWrongAsTheFirstThingThatIs) {
  for (double radius = 6; radius < 110; radius += 4) {
    for (const double angle : {0.4, 1.5, 3.0, 5.5, 6.5}) {
      EXPECT_EQ(is_valid(arc(radius, angle)), validate(arc(radius, angle)).valid())
          << radius << ' ' << angle;
    }
  }
}

TEST(LeastRadius, IsThatOfACircle) {
  for (const double radius : {9.0, 20.0, 75.0}) {
    Polyline line;
    for (int i = 0; i < 40; ++i) {
      line.push_back({radius * std::cos(i / radius), radius * std::sin(i / radius)});
    }
    EXPECT_NEAR(least_radius_m(line), radius, 1e-6);
  }
}

TEST(LeastRadius, IsNothingOfAStraightLineAndOfTooFewPoints) {
  Polyline line;
  for (int i = 0; i < 30; ++i) line.push_back({3.0 * i, 4.0 * i});
  EXPECT_EQ(least_radius_m(line), 0);
  EXPECT_EQ(least_radius_m(Polyline{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}}), 0);
}

TEST(LeastRadius, LeavesOutTheLastFivePoints) {
  // Straight on but for a kink; from the last points on it is not noticed.
  const auto with_kink = [](std::size_t at) {
    Polyline line;
    for (std::size_t i = 0; i < 30; ++i) line.push_back({static_cast<double>(i), 0});
    line[at].y_m = 3;
    return least_radius_m(line);
  };
  EXPECT_GT(with_kink(10), 0);
  EXPECT_GT(with_kink(28), 0) << "the last window begins at 24";
  EXPECT_EQ(with_kink(29), 0);
}

}  // namespace
}  // namespace jaywalk::lane
