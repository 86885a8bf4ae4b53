// SPDX-License-Identifier: Apache-2.0
// The parts of AmbieGen: NSGA-II, roads of elements, the simplified car.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "search/evolve/nsga2.h"
#include "search/evolve/road_elements.h"

namespace jaywalk::search {
namespace {

using Kind = RoadElement::Kind;

TEST(Nsga2, RanksByDominationAndCrowding) {
  // Three on a front, one behind it, one behind both, and one that lacks what is required.
  const std::vector<Worth> worths{{{0, 4}}, {{1, 3}}, {{4, 0}}, {{1, 2}}, {{0, 1}}, {{9, 9}, 1}};
  EXPECT_TRUE(dominates(worths[1], worths[3]));
  EXPECT_FALSE(dominates(worths[0], worths[1]));
  EXPECT_TRUE(dominates(worths[4], worths[5]));
  const std::vector<Standing> standings = rank(worths);
  EXPECT_EQ(standings[0].front, 0U);
  EXPECT_EQ(standings[1].front, 0U);
  EXPECT_EQ(standings[2].front, 0U);
  EXPECT_EQ(standings[3].front, 1U);
  EXPECT_EQ(standings[4].front, 2U);
  EXPECT_EQ(standings[5].front, 3U);
  EXPECT_EQ(standings[0].crowding, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(standings[1].crowding, 2) << "its neighbours are the ends of both ranges";
  const std::vector<std::size_t> best = survivors(standings, 4);
  EXPECT_EQ(best.size(), 4U);
  EXPECT_EQ(best.back(), 3U);
}

// The front of (x, 1 - x) for 0 <= x <= 1 - the rest is dominated - is found from random numbers
// and covered (Deb's two-objective problems are of this kind).
TEST(Nsga2, FindsAKnownFront) {
  struct Individual {
    double x = 0;
    double off = 0;
  };
  Random random(2);
  std::vector<Individual> all;
  for (int i = 0; i < 40; ++i) all.push_back({random.uniform(0, 1), random.uniform(0, 1)});
  const auto worths = [&] {
    std::vector<Worth> result;
    for (const Individual& each : all)
      result.push_back({{each.x - each.off, 1 - each.x - each.off}});
    return result;
  };
  for (int generation = 0; generation < 60; ++generation) {
    const std::vector<Standing> standings = rank(worths());
    for (int i = 0; i < 40; ++i) {
      Individual child = all[tournament(standings, random)];
      child.x = std::clamp(child.x + random.uniform(-0.1, 0.1), 0.0, 1.0);
      child.off = std::max(0.0, child.off + random.uniform(-0.1, 0.1));
      all.push_back(child);
    }
    std::vector<Individual> kept;
    for (const std::size_t i : survivors(rank(worths()), 40)) kept.push_back(all[i]);
    all = std::move(kept);
  }
  double most_off = 0;
  double least = 1;
  double most = 0;
  for (const Individual& each : all) {
    most_off = std::max(most_off, each.off);
    least = std::min(least, each.x);
    most = std::max(most, each.x);
  }
  EXPECT_LT(most_off, 0.02);
  EXPECT_LT(least, 0.05);
  EXPECT_GT(most, 0.95);
}

TEST(RoadElements, MakeStraightsAndArcsOfTwentyMetres) {
  const RoadElements elements{{Kind::straight, 30}, {Kind::right, 90}, {Kind::left, 90}};
  const lane::Polyline points = element_points(elements, 200);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(lane::distance(points[0], {100, 100}), 0, 1e-9);
  EXPECT_NEAR(lane::distance(points[1], {100, 130}), 0, 1e-9);
  EXPECT_NEAR(lane::distance(points[2], {120, 150}), 0, 1e-9);
  EXPECT_NEAR(lane::distance(points[3], {140, 170}), 0, 1e-9);
  EXPECT_EQ(element_points(RoadElements(8, {Kind::straight, 25}), 200).size(), 4U)
      << "the road ends before the map does";
}

TEST(RoadElements, DifferByKindAndByMoreThanTen) {
  const RoadElements one{{Kind::straight, 10}, {Kind::right, 30}, {Kind::left, 50}};
  const RoadElements other{{Kind::straight, 18}, {Kind::right, 60}, {Kind::right, 50}};
  EXPECT_EQ(difference(one, one), 0);
  EXPECT_DOUBLE_EQ(difference(one, other), (0 + 0.5 + 1) / 3);
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    EXPECT_NE(draw_other(one[1], random).kind, Kind::right);
  }
}

TEST(SimplifiedCar, StaysOnAStraightRoadAndLeavesACrookedOne) {
  const auto deviation = [](const RoadElements& elements) {
    return simplified_deviation_m(element_points(elements, 200));
  };
  EXPECT_NEAR(deviation(RoadElements(3, {Kind::straight, 30})), 0, 0.1);
  const double gentle = deviation({{Kind::straight, 25}, {Kind::left, 20}, {Kind::straight, 25}});
  const double sharp =
      deviation({{Kind::straight, 25}, {Kind::left, 85}, {Kind::right, 85}, {Kind::straight, 20}});
  EXPECT_LT(gentle, sharp);
  EXPECT_GT(sharp, 2);
  EXPECT_EQ(simplified_deviation_m(lane::Polyline{{1, 1}, {1, 1}}), 0);
}

}  // namespace
}  // namespace jaywalk::search
