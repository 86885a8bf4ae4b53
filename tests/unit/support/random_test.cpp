// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/random.h"

#include <bit>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

// The numbers of the authors' own program, and of Rosetta Code's task of that name.
TEST(SplitMix64, GivesItsPublishedNumbers) {
  SplitMix64 zero(0);
  EXPECT_EQ(zero.next(), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(zero.next(), 0x6E789E6AA1B965F4U);
  EXPECT_EQ(zero.next(), 0x06C45D188009454FU);
  SplitMix64 other(1234567);
  EXPECT_EQ(other.next(), 6457827717110365317U);
  EXPECT_EQ(other.next(), 3203168211198807973U);
}

TEST(SplitMix64, DrawsEachNumberBelowABoundAsOften) {
  SplitMix64 random(7);
  std::vector<int> counts(6);
  for (int i = 0; i < 6000; ++i) ++counts.at(random.below(6));
  for (const int count : counts) {
    EXPECT_GT(count, 880);
    EXPECT_LT(count, 1120);
  }
}

TEST(SplitMix64, DrawsNothingButZeroBelowOne) {
  SplitMix64 random(7);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(random.below(1), 0U);
}

TEST(SplitMix64, DrawsBelowTheLargestBounds) {
  SplitMix64 random(7);
  constexpr std::uint64_t kHalf = (std::uint64_t{1} << 63U) + 1;
  bool large = false;
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t value = random.below(kHalf);
    EXPECT_LT(value, kHalf);
    large = large || value > kHalf / 2;
  }
  EXPECT_TRUE(large);
}

TEST(SplitMix64, SharesAreFromZeroUpToOne) {
  SplitMix64 random(3);
  double sum = 0;
  for (int i = 0; i < 4000; ++i) {
    const double share = random.share();
    EXPECT_GE(share, 0);
    EXPECT_LT(share, 1);
    sum += share;
  }
  EXPECT_NEAR(sum / 4000, 0.5, 0.02);
}

TEST(SplitMix64, OfOneSeedIsAlwaysTheSame) {
  SplitMix64 one(99);
  SplitMix64 other(99);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(one.next(), other.next());
}

TEST(MixedSeeds, DifferForNeighbours) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (std::uint64_t number = 0; number < 40; ++number) seen.insert(mix(seed, number));
  }
  EXPECT_EQ(seen.size(), 1600U);
}

TEST(MixedSeeds, DependOnWhichIsTheSeed) {
  for (std::uint64_t i = 0; i < 20; ++i) EXPECT_NE(mix(i, i + 1), mix(i + 1, i));
}

TEST(MixedSeeds, ChangeAboutHalfOfTheirBitsWithOneOfTheSeed) {
  for (unsigned bit = 0; bit < 64; ++bit) {
    const int changed = std::popcount(mix(5, 6) ^ mix(5 ^ (std::uint64_t{1} << bit), 6));
    EXPECT_GT(changed, 12) << bit;
    EXPECT_LT(changed, 52) << bit;
  }
}

// As java.util.Random prints them.
TEST(JavaRandom, GivesJavasNumbers) {
  EXPECT_DOUBLE_EQ(JavaRandom(42).next_double(), 0.7275636800328681);
  EXPECT_DOUBLE_EQ(JavaRandom(0).next_double(), 0.730967787376657);
}

TEST(JavaRandom, GivesJavasWholeNumbers) {
  JavaRandom random(42);
  EXPECT_EQ(random.next_int(10), 0);
  EXPECT_EQ(random.next_int(10), 3);
  EXPECT_EQ(JavaRandom(42).next_int(16), 11) << "of a power of two, by the upper bits";
}

TEST(JavaRandom, BeginsAnewWithItsSeed) {
  JavaRandom random(5);
  const double first = random.next_double();
  EXPECT_NE(random.next_double(), first);
  random.set_seed(5);
  EXPECT_EQ(random.next_double(), first);
}

TEST(JavaRandom, StaysBelowItsBound) {
  JavaRandom random(1);
  for (const std::int32_t bound : {1, 2, 3, 7, 1000, 1 << 30, INT32_MAX}) {
    for (int i = 0; i < 50; ++i) {
      const std::int32_t value = random.next_int(bound);
      EXPECT_GE(value, 0);
      EXPECT_LT(value, bound);
    }
  }
}

}  // namespace
}  // namespace jaywalk
