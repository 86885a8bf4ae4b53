// SPDX-License-Identifier: Apache-2.0
#include "search/evolve/nsga2.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk::search {
namespace {

using testing::ElementsAre;

constexpr double kOutermost = std::numeric_limits<double>::infinity();

Worth worth(double first, double second, double lacks = 0) { return {{first, second}, lacks}; }

std::vector<std::size_t> fronts(const std::vector<Standing>& standings) {
  std::vector<std::size_t> numbers;
  for (const Standing& each : standings) numbers.push_back(each.front);
  return numbers;
}

TEST(Domination, IsToBeNoWorseAndSomewhereBetter) {
  EXPECT_TRUE(dominates(worth(2, 2), worth(1, 2)));
  EXPECT_TRUE(dominates(worth(2, 2), worth(1, 1)));
  EXPECT_FALSE(dominates(worth(2, 1), worth(1, 2)));
  EXPECT_FALSE(dominates(worth(2, 2), worth(2, 2))) << "nobody dominates an equal";
}

TEST(Domination, GoesByWhatIsLackingFirst) {
  EXPECT_TRUE(dominates(worth(0, 0), worth(9, 9, 1)));
  EXPECT_TRUE(dominates(worth(0, 0, 1), worth(9, 9, 2)));
  EXPECT_FALSE(dominates(worth(9, 9, 1), worth(0, 0)));
  EXPECT_TRUE(dominates(worth(2, 2, 1), worth(1, 1, 1)));
}

TEST(Fronts, HoldThoseWhomNobodyOfWhatIsLeftDominates) {
  const std::vector<Worth> worths{worth(1, 3), worth(3, 1), worth(1, 1), worth(0, 3), worth(0, 0)};
  EXPECT_THAT(fronts(rank(worths)), ElementsAre(0, 0, 1, 1, 2));
}

TEST(Fronts, OfEqualsAreOne) {
  EXPECT_THAT(fronts(rank(std::vector<Worth>(4, worth(1, 1)))), ElementsAre(0, 0, 0, 0));
  EXPECT_TRUE(rank({}).empty());
}

TEST(Crowding, IsTheDistanceOfTheNeighboursInEachObjective) {
  // On a line from (0, 10) to (10, 0): the neighbours of (2, 8) are 5 of 10 apart in both.
  const std::vector<Worth> worths{worth(0, 10), worth(2, 8), worth(5, 5), worth(10, 0)};
  const auto standings = rank(worths);
  EXPECT_EQ(standings[0].crowding, kOutermost);
  EXPECT_EQ(standings[3].crowding, kOutermost);
  EXPECT_DOUBLE_EQ(standings[1].crowding, 1);
  EXPECT_DOUBLE_EQ(standings[2].crowding, 1.6) << "from 2 to 10, and from 8 to 0";
}

TEST(Crowding, OfAnObjectiveThatIsTheSameForAllIsNone) {
  const std::vector<Worth> worths{worth(1, 1), worth(1, 1), worth(1, 1)};
  const auto standings = rank(worths);
  EXPECT_EQ(standings[1].crowding, 0);
}

TEST(Survivors, AreTheBestFrontsThenTheLeastCrowded) {
  const std::vector<Standing> standings{{.front = 1, .crowding = 9},
                                        {.front = 0, .crowding = 1},
                                        {.front = 0, .crowding = 3},
                                        {.front = 2, .crowding = kOutermost}};
  EXPECT_THAT(survivors(standings, 3), ElementsAre(2, 1, 0));
  EXPECT_THAT(survivors(standings, 99), ElementsAre(2, 1, 0, 3));
  EXPECT_THAT(survivors(standings, 0), ElementsAre());
}

TEST(Survivors, KeepTheOrderOfEquals) {
  EXPECT_THAT(survivors(std::vector<Standing>(3), 2), ElementsAre(0, 1));
}

TEST(Tournament, ChoosesTheBetterOfTwo) {
  std::vector<Standing> standings(10, {.front = 1});
  standings[4].front = 0;
  Random random(1);
  std::size_t won = 0;
  for (int i = 0; i < 1000; ++i) won += tournament(standings, random) == 4 ? 1U : 0U;
  // Drawn at least once of two draws: 1 - 0.9^2 = 19 %.
  EXPECT_GT(won, 140U);
  EXPECT_LT(won, 240U);
}

}  // namespace
}  // namespace jaywalk::search
