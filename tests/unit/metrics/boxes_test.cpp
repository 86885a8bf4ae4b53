// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/signals/boxes.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kHalfTurn = std::numbers::pi;

std::vector<Point> square(double left, double near, double side = 1) {
  return {{left, near}, {left + side, near}, {left + side, near + side}, {left, near + side}};
}

/// The corners, rounded so that they compare.
std::vector<std::pair<double, double>> corners(const std::vector<Point>& points) {
  std::vector<std::pair<double, double>> result;
  for (const Point& each : points) result.emplace_back(each.x_m, each.y_m);
  return result;
}

Actor sized(double length, double width) { return {"a", ActorKind::vehicle, length, width}; }

TEST(Contact, LastsFromTheFirstTouchToTheLast) {
  const auto times = contact(square(0, 0), square(3, 0), {-1, 0}, {0, kForEver});
  ASSERT_TRUE(times);
  EXPECT_DOUBLE_EQ(times->from, 2);
  EXPECT_DOUBLE_EQ(times->to, 4);
}

TEST(Contact, IsCutToTheTimesThatAreAskedFor) {
  const auto times = contact(square(0, 0), square(3, 0), {-1, 0}, {0, 3});
  ASSERT_TRUE(times);
  EXPECT_DOUBLE_EQ(times->to, 3);
  EXPECT_FALSE(contact(square(0, 0), square(3, 0), {-1, 0}, {0, 1.9}));
  EXPECT_FALSE(contact(square(0, 0), square(3, 0), {-1, 0}, {4.1, 9}));
}

TEST(Contact, NeedsBothAxesAtOnce) {
  // Across from 2 to 4, along from 1 to 3.
  const auto times = contact(square(0, 0), square(3, 2), {-1, -1}, {0, kForEver});
  ASSERT_TRUE(times);
  EXPECT_DOUBLE_EQ(times->from, 2);
  EXPECT_DOUBLE_EQ(times->to, 3);
  EXPECT_FALSE(contact(square(0, 0), square(3, 2), {-1, -0.2}, {0, kForEver}))
      << "along from 5 on only, when it has passed";
}

TEST(Contact, OfWhoDoesNotMoveIsAlwaysOrNever) {
  const auto times = contact(square(0, 0), square(0.5, 0.5), {0, 0}, {1, 2});
  ASSERT_TRUE(times);
  EXPECT_EQ(times->from, 1);
  EXPECT_EQ(times->to, 2);
  EXPECT_FALSE(contact(square(0, 0), square(2, 0), {0, 0}, {0, kForEver}));
  EXPECT_TRUE(contact(square(0, 0), square(1, 0), {0, 0}, {0, kForEver})) << "sides touch";
}

TEST(Contact, IsMissedByWhoMovesAway) {
  EXPECT_FALSE(contact(square(0, 0), square(3, 0), {1, 0}, {0, kForEver}));
  EXPECT_TRUE(contact(square(0, 0), square(3, 0), {1, 0}, {-kForEver, 0})) << "it was there before";
}

TEST(Contact, TakesAPointForAPolygon) {
  const std::vector<Point> point{{3, 0.5}};
  const auto times = contact(square(0, 0), point, {-1, 0}, {0, kForEver});
  ASSERT_TRUE(times);
  EXPECT_DOUBLE_EQ(times->from, 2);
  EXPECT_DOUBLE_EQ(times->to, 3);
}

TEST(Contact, SeesCornersOfTurnedBoxes) {
  // A square stood on its corner reaches sqrt(2) / 2 from its middle.
  const std::vector<Point> diamond = box(sized(1, 1), {5, 0.5, 0, kHalfTurn / 4});
  const auto times = contact(square(0, 0), diamond, {-1, 0}, {0, kForEver});
  ASSERT_TRUE(times);
  EXPECT_NEAR(times->from, 4 - std::sqrt(0.5), 1e-12);
}

TEST(Heading, IsCountedCounterClockwiseFromTheRight) {
  EXPECT_NEAR(heading({.heading_rad = 0}).x, 1, 1e-12);
  EXPECT_NEAR(heading({.heading_rad = kHalfTurn / 2}).y, 1, 1e-12);
  const Vector way = velocity({.speed_mps = 2, .heading_rad = kHalfTurn});
  EXPECT_NEAR(way.x, -2, 1e-12);
  EXPECT_NEAR(way.y, 0, 1e-12);
}

TEST(Vectors, HaveDotAndCrossProducts) {
  EXPECT_EQ(dot(Vector{1, 2}, Vector{3, 4}), 11);
  EXPECT_EQ(cross(Vector{1, 0}, Vector{0, 1}), 1) << "left of it";
  EXPECT_EQ(cross(Vector{0, 1}, Vector{1, 0}), -1);
  const Vector way = displacement({.x_m = 1, .y_m = 2}, {.x_m = 4, .y_m = 0});
  EXPECT_EQ(way.x, 3);
  EXPECT_EQ(way.y, -2);
}

/// It stands there.
Movement standing(double x, double y, double heading_rad = 0) {
  const ActorState state{x, y, 0, heading_rad};
  return {state, state};
}

TEST(Closest, OfTwoWhoStandIsTheirDistance) {
  EXPECT_DOUBLE_EQ(closest_m(sized(2, 2), standing(0, 0), sized(2, 2), standing(5, 0)), 3);
  EXPECT_DOUBLE_EQ(closest_m(sized(2, 2), standing(0, 0), sized(2, 2), standing(5, 6)), 5)
      << "3 m and 4 m between the corners";
  EXPECT_NEAR(closest_m(sized(2, 2), standing(0, 0), sized(2, 2), standing(5, 0, kHalfTurn / 4)),
              4 - std::sqrt(2.0), 1e-12);
}

TEST(Closest, LiesWithinTheStep) {
  // Passes at x = 3 from far before to far behind.
  const Movement passing{{3, -20, 0, 0}, {3, 20, 0, 0}};
  EXPECT_DOUBLE_EQ(closest_m(sized(1, 1), standing(0, 0), sized(1, 1), passing), 2);
  EXPECT_FALSE(touch(sized(1, 1), standing(0, 0), sized(1, 1), passing));
}

TEST(Closest, DependsOnTheWayOfTheOneAgainstTheOther) {
  // Both go 10 m the same way: they keep their distance.
  const Movement one{{0, 0, 0, 0}, {0, 10, 0, 0}};
  const Movement two{{3, 0, 0, 0}, {3, 10, 0, 0}};
  EXPECT_DOUBLE_EQ(closest_m(sized(1, 1), one, sized(1, 1), two), 2);
  // They swap places.
  const Movement back{{0, 10, 0, 0}, {0, 0, 0, 0}};
  EXPECT_EQ(closest_m(sized(1, 1), one, sized(1, 1), back), 0);
  EXPECT_TRUE(touch(sized(1, 1), one, sized(1, 1), back));
}

TEST(Closest, TurnsBoxesAtOnceToTheLaterHeading) {
  // 4 m long: lengthways it would reach from 0 to 4, crossways from 1.5 to 2.5.
  const Movement turning{{2, 0, 0, 0}, {2, 0, 0, kHalfTurn / 2}};
  EXPECT_NEAR(closest_m(sized(1, 1), standing(0, 0), sized(4, 1), turning), 1, 1e-12);
}

TEST(Touch, IsAClosestDistanceOfZero) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-4, 4);
  std::uniform_real_distribution<double> turn(-kHalfTurn, kHalfTurn);
  int touched = 0;
  const auto movement = [&] {
    const double later = turn(random);
    return Movement{{place(random), place(random), 0, turn(random)},
                    {place(random), place(random), 0, later}};
  };
  for (int i = 0; i < 300; ++i) {
    const Movement one = movement();
    const Movement two = movement();
    const bool touches = touch(sized(2, 1), one, sized(0.5, 0.5), two);
    EXPECT_EQ(touches, closest_m(sized(2, 1), one, sized(0.5, 0.5), two) <= 0) << i;
    touched += touches ? 1 : 0;
  }
  EXPECT_GT(touched, 30) << "both answers occur";
  EXPECT_LT(touched, 270);
}

TEST(ConvexHull, LeavesOutWhatIsInsideOrOnAnEdge) {
  const auto hull = convex_hull({{2, 2}, {1, 1}, {0, 0}, {1, 0}, {2, 0}, {0, 2}, {0, 1}});
  EXPECT_THAT(corners(hull), testing::ElementsAre(testing::Pair(0, 0), testing::Pair(2, 0),
                                                  testing::Pair(2, 2), testing::Pair(0, 2)));
}

TEST(ConvexHull, OfTwoPointsIsBoth) {
  EXPECT_THAT(corners(convex_hull({{2, 2}, {1, 1}})),
              testing::ElementsAre(testing::Pair(1, 1), testing::Pair(2, 2)));
  EXPECT_THAT(convex_hull({}), testing::IsEmpty());
}

TEST(Swept, IsABoxAlongAnAxisAndAHexagonAcross) {
  EXPECT_THAT(corners(swept(square(0, 0), {3, 0})),
              testing::ElementsAre(testing::Pair(0, 0), testing::Pair(4, 0), testing::Pair(4, 1),
                                   testing::Pair(0, 1)));
  EXPECT_THAT(corners(swept(square(0, 0), {3, 3})),
              testing::ElementsAre(testing::Pair(0, 0), testing::Pair(1, 0), testing::Pair(4, 3),
                                   testing::Pair(4, 4), testing::Pair(3, 4), testing::Pair(0, 1)));
}

}  // namespace
}  // namespace jaywalk
