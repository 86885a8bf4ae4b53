// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/significance.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(Significance, ComparesPairedSuccessesExactly) {
  // Of 10 differing tests the one succeeded in 9: 2 (1 + 10) / 2^10.
  EXPECT_NEAR(mcnemar({.both = 80, .first_only = 9, .second_only = 1, .neither = 10}), 22.0 / 1024,
              1e-12);
  EXPECT_DOUBLE_EQ(mcnemar({.both = 5, .first_only = 1, .second_only = 9}),
                   mcnemar({.both = 5, .first_only = 9, .second_only = 1}));
  EXPECT_EQ(mcnemar({.both = 7, .neither = 3}), 1);
  EXPECT_EQ(mcnemar({.first_only = 4, .second_only = 4}), 1);
}

TEST(Significance, BoundsADifferenceOfPairedSharesBothWays) {
  const PairedOutcomes outcomes{.both = 53, .first_only = 16, .second_only = 8, .neither = 9};
  EXPECT_NEAR(outcomes.difference(), 8.0 / 86, 1e-12);
  const ConfidenceInterval interval = difference_interval(outcomes);
  // (16 - 8) / 88 -+ 1.95996 sqrt((16.5 + 8.5) / 88 - (8 / 88)^2) / sqrt(88)
  EXPECT_NEAR(interval.low, -0.0188, 5e-4);
  EXPECT_NEAR(interval.high, 0.2006, 5e-4);
}

TEST(Significance, ComparesRanksWithTies) {
  // U = 2.5 of 16 pairs; ties of 2, 2 and 3 values: variance 4 * 4 / 12 * (9 - 36 / 56), so that
  // z = 5 / 3.3381 and p = 2 (1 - Phi(z)).
  const Counts first{{1, 2}, {2, 1}, {3, 1}};
  const Counts second{{2, 1}, {3, 2}, {4, 1}};
  const RankComparison comparison = *compare_ranks(first, second);
  EXPECT_DOUBLE_EQ(comparison.a12, 2.5 / 16);
  EXPECT_NEAR(comparison.p, 0.134169, 1e-6);
  EXPECT_DOUBLE_EQ(compare_ranks(second, first)->a12, 13.5 / 16);
  EXPECT_DOUBLE_EQ(compare_ranks(second, first)->p, comparison.p);
}

TEST(Significance, SeesNoDifferenceWhereAllAreEqual) {
  const RankComparison comparison = *compare_ranks({{5, 10}}, {{5, 20}});
  EXPECT_EQ(comparison.a12, 0.5);
  EXPECT_EQ(comparison.p, 1);
  EXPECT_FALSE(compare_ranks({}, {{1, 1}}));
}

TEST(Significance, ComparesMeansOfUnequalSpread) {
  // t = -5.5 / sqrt(5 / 12 + 2) = -3.53797 with 5.52079 degrees of freedom; p by integration of
  // its density with Simpson's rule.
  const std::array first{1.0, 2.0, 3.0, 4.0};
  const std::array second{4.0, 6.0, 8.0, 10.0, 12.0};
  const MeanComparison comparison = *compare_means(summarise(first), summarise(second));
  EXPECT_NEAR(comparison.p, 0.014069, 1e-6);
  // -5.5 / sqrt((5 + 40) / 7) * (1 - 3 / 27)
  EXPECT_NEAR(comparison.g, -1.9282, 1e-4);
}

TEST(Significance, ComparesNoMeansOfTooFewOrEqualValues) {
  const std::array one{1.0};
  const std::array same{2.0, 2.0};
  const std::array some{1.0, 2.0};
  EXPECT_FALSE(compare_means(summarise(one), summarise(some)));
  EXPECT_FALSE(compare_means(summarise(same), summarise(same)));
  EXPECT_TRUE(compare_means(summarise(same), summarise(some)));
}

TEST(Significance, IsCorrectedForTheNumberOfQuestions) {
  // 4 * 0.005, 3 * 0.01, 2 * 0.03, and the greatest is no less than that.
  const std::array p{0.01, 0.04, 0.03, 0.005};
  EXPECT_THAT(holm(p), ElementsAre(DoubleNear(0.03, 1e-12), DoubleNear(0.06, 1e-12),
                                   DoubleNear(0.06, 1e-12), DoubleNear(0.02, 1e-12)));
  const std::array large{0.9, 0.8};
  EXPECT_THAT(holm(large), ElementsAre(1, 1));
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace jaywalk
