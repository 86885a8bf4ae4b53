// SPDX-License-Identifier: Apache-2.0
#include "search/evolve/road_elements.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace jaywalk::search {
namespace {

using Kind = RoadElement::Kind;

constexpr double kMapM = 200;

TEST(RoadElements, BeginInTheMiddleAndGoUp) {
  const auto points = element_points({}, kMapM);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].x_m, 100);
  EXPECT_EQ(points[0].y_m, 100);
  const RoadElements straight{{Kind::straight, 20}};
  EXPECT_NEAR(element_points(straight, kMapM)[1].x_m, 100, 1e-9);
  EXPECT_NEAR(element_points(straight, kMapM)[1].y_m, 120, 1e-9);
}

TEST(RoadElements, TurnOnACircleOfTwentyMetres) {
  // A quarter of a circle to the left ends 20 m up and 20 m to the left.
  const RoadElements left{{Kind::left, 90}};
  EXPECT_NEAR(element_points(left, kMapM)[1].x_m, 80, 1e-9);
  EXPECT_NEAR(element_points(left, kMapM)[1].y_m, 120, 1e-9);
  const RoadElements right{{Kind::right, 90}};
  EXPECT_NEAR(element_points(right, kMapM)[1].x_m, 120, 1e-9);
}

TEST(RoadElements, GoOnTheWayThatATurnEndedIn) {
  const RoadElements elements{{Kind::right, 90}, {Kind::straight, 10}};
  const auto points = element_points(elements, kMapM);
  EXPECT_NEAR(points[2].x_m, 130, 1e-9);
  EXPECT_NEAR(points[2].y_m, 120, 1e-9);
}

TEST(RoadElements, EndBeforeTheEdgeOfTheMap) {
  // 9 m are left to the edge: 191 m is the last place.
  const RoadElements elements(10, {Kind::straight, 30});
  const auto points = element_points(elements, kMapM);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(points.back().y_m, 190, 1e-9);
}

TEST(RoadElements, AreDrawnOfEachKindWithWholeValues) {
  Random random(4);
  std::set<Kind> kinds;
  for (int i = 0; i < 200; ++i) {
    const RoadElement element = draw_element(random);
    kinds.insert(element.kind);
    const bool straight = element.kind == Kind::straight;
    EXPECT_GE(element.value, straight ? 5 : 10);
    EXPECT_LE(element.value, straight ? 30 : 85);
    EXPECT_EQ(element.value, std::round(element.value));
  }
  EXPECT_EQ(kinds.size(), 3U);
}

TEST(RoadElements, AreReplacedByOnesOfAnotherKind) {
  Random random(4);
  std::set<Kind> kinds;
  for (int i = 0; i < 100; ++i) kinds.insert(draw_other({Kind::left, 20}, random).kind);
  EXPECT_EQ(kinds, (std::set<Kind>{Kind::straight, Kind::right}));
}

TEST(RoadDifference, CountsKindsWhollyAndValuesByHalf) {
  const RoadElements road{{Kind::straight, 20}, {Kind::left, 40}};
  EXPECT_EQ(difference(road, road), 0);
  EXPECT_EQ(difference(road, RoadElements{{Kind::straight, 30}, {Kind::left, 50}}), 0)
      << "10 apart is alike";
  EXPECT_EQ(difference(road, RoadElements{{Kind::straight, 31}, {Kind::left, 40}}), 0.25);
  EXPECT_EQ(difference(road, RoadElements{{Kind::left, 20}, {Kind::right, 40}}), 1);
}

TEST(RoadDifference, ComparesAsManyElementsAsBothHave) {
  const RoadElements longer{{Kind::straight, 20}, {Kind::left, 40}, {Kind::left, 40}};
  EXPECT_EQ(difference(longer, RoadElements{{Kind::straight, 20}}), 0);
  EXPECT_EQ(difference(longer, {}), 1) << "nothing is alike";
}

TEST(SimplifiedCar, StaysOnAStraightRoad) {
  const std::vector<Point> straight{{100, 20}, {100, 60}, {100, 100}, {100, 140}, {100, 180}};
  EXPECT_LT(simplified_deviation_m(straight), 0.01);
}

TEST(SimplifiedCar, LeavesASharpTurnFartherThanAWideOne) {
  const std::vector<Point> wide{{40, 40}, {40, 80}, {60, 120}, {100, 150}, {150, 160}};
  const std::vector<Point> sharp{{40, 40}, {40, 100}, {40, 150}, {60, 155}, {60, 100}, {60, 40}};
  EXPECT_GT(simplified_deviation_m(wide), 0.5);
  EXPECT_GT(simplified_deviation_m(sharp), simplified_deviation_m(wide));
}

TEST(SimplifiedCar, DoesNotLeaveWhatIsNoRoad) {
  EXPECT_EQ(simplified_deviation_m({}), 0);
  EXPECT_EQ(simplified_deviation_m(std::vector<Point>{{1, 1}}), 0);
}

}  // namespace
}  // namespace jaywalk::search
