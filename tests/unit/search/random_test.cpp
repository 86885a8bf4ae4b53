// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "search/test_input.h"

namespace jaywalk::search {
namespace {

TEST(SearchRandom, DrawsBothEndsOfARangeOfWholeNumbers) {
  Random random(1);
  std::set<int> seen;
  for (int i = 0; i < 200; ++i) seen.insert(random.between(-2, 2));
  EXPECT_EQ(seen, (std::set<int>{-2, -1, 0, 1, 2}));
  EXPECT_EQ(random.between(7, 7), 7);
}

TEST(SearchRandom, DrawsNumbersOfARangeEvenly) {
  Random random(2);
  double sum = 0;
  for (int i = 0; i < 2000; ++i) {
    const double value = random.uniform(-3, 5);
    EXPECT_GE(value, -3);
    EXPECT_LT(value, 5);
    sum += value;
  }
  EXPECT_NEAR(sum / 2000, 1, 0.2);
}

TEST(SearchRandom, ThrowsFairCoins) {
  Random random(3);
  int heads = 0;
  for (int i = 0; i < 2000; ++i) heads += random.coin() ? 1 : 0;
  EXPECT_NEAR(heads, 1000, 120);
}

TEST(SearchRandom, ShufflesIntoAnyOrderWithoutLosingAnything) {
  Random random(4);
  std::set<std::vector<int>> orders;
  for (int i = 0; i < 300; ++i) {
    std::vector<int> items{1, 2, 3, 4};
    random.shuffle(items);
    orders.insert(items);
    std::ranges::sort(items);
    EXPECT_EQ(items, (std::vector<int>{1, 2, 3, 4}));
  }
  EXPECT_EQ(orders.size(), 24U);
}

TEST(SearchRandom, OfOneSeedIsAlwaysTheSame) {
  Random one(5);
  Random other(5);
  Random third(6);
  bool differs = false;
  for (int i = 0; i < 20; ++i) {
    const double value = one.uniform(0, 1);
    EXPECT_EQ(value, other.uniform(0, 1));
    differs = differs || value != third.uniform(0, 1);
  }
  EXPECT_TRUE(differs);
}

TEST(StandardNormal, HasMeanZeroAndDeviationOne) {
  Random random(7);
  std::vector<double> values(4000);
  for (double& value : values) value = standard_normal(random);
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / 4000;
  double squares = 0;
  int within = 0;
  for (const double value : values) {
    ASSERT_TRUE(std::isfinite(value));
    squares += (value - mean) * (value - mean);
    within += std::fabs(value) < 1 ? 1 : 0;
  }
  EXPECT_NEAR(mean, 0, 0.06);
  EXPECT_NEAR(squares / 4000, 1, 0.08);
  EXPECT_NEAR(within / 4000.0, 0.6827, 0.03) << "as the bell has it, not a box";
}

TEST(NamedSeeds, DependOnEachLetterAndItsPlace) {
  std::set<std::uint64_t> seeds;
  for (const char* name : {"", "a", "b", "ab", "ba", "aa", "random", "randon"}) {
    seeds.insert(mix_name(1, name));
  }
  EXPECT_EQ(seeds.size(), 8U);
  EXPECT_NE(mix_name(1, "ab"), mix_name(2, "ab"));
  EXPECT_EQ(mix_name(1, "ab"), mix_name(1, "ab"));
}

}  // namespace
}  // namespace jaywalk::search
