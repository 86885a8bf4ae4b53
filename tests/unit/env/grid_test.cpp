// SPDX-License-Identifier: Apache-2.0
#include "env/grid/grid.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

TEST(Grid, ContainsItsCornersAndNothingBeyond) {
  const Grid grid{12, 66};
  EXPECT_TRUE(grid.contains({0, 0}));
  EXPECT_TRUE(grid.contains({11, 65}));
  EXPECT_FALSE(grid.contains({-1, 0}));
  EXPECT_FALSE(grid.contains({12, 0}));
  EXPECT_FALSE(grid.contains({0, -1}));
  EXPECT_FALSE(grid.contains({0, 66}));
}

TEST(Direction, IsSeenFromTheDriver) {
  EXPECT_EQ(neighbour({5, 5}, Direction::left), (Position{4, 5}));
  EXPECT_EQ(neighbour({5, 5}, Direction::right), (Position{6, 5}));
  EXPECT_EQ(neighbour({5, 5}, Direction::forward), (Position{5, 6}));
  EXPECT_EQ(neighbour({5, 5}, Direction::back), (Position{5, 4}));
}

TEST(Direction, IsFoundByItsName) {
  for (const Direction direction :
       {Direction::left, Direction::right, Direction::forward, Direction::back}) {
    EXPECT_EQ(find_direction(name(direction)), direction);
  }
  EXPECT_EQ(find_direction("up"), std::nullopt);
}

TEST(Interval, CountsBothEnds) {
  EXPECT_EQ((Interval{2, 5}).size(), 4);
  EXPECT_TRUE((Interval{5, 4}).empty());
  EXPECT_EQ(Interval{}.size(), 0);
}

// The reference values of the algorithm's authors for the seed 1234567.
TEST(SplitMix64, GivesThePublishedSequence) {
  SplitMix64 random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317U);
  EXPECT_EQ(random.next(), 3203168211198807973U);
  EXPECT_EQ(random.next(), 9817491932198370423U);
}

TEST(SplitMix64, DrawsEveryNumberBelowTheBoundAboutEquallyOften) {
  SplitMix64 random(1);
  std::array<int, 7> counts{};
  for (int i = 0; i < 7000; ++i) ++counts[random.below(counts.size())];
  for (const int count : counts) EXPECT_NEAR(count, 1000, 130);  // more than four deviations
}

TEST(Mix, SeparatesSeedsAndNumbers) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (std::uint64_t number = 0; number < 10; ++number) seeds.insert(mix(seed, number));
  }
  EXPECT_EQ(seeds.size(), 100U);
}

}  // namespace
}  // namespace jaywalk
