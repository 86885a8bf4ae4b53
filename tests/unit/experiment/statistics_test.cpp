// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/statistics.h"

#include <array>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

// Newcombe (1998), "Two-sided confidence intervals for the single proportion", table I.
TEST(WilsonInterval, AgreesWithPublishedValues) {
  struct Case {
    std::uint64_t successes, tests;
    double low, high;
  };
  for (const Case& c : {Case{81, 263, 0.2553, 0.3662}, Case{15, 148, 0.0624, 0.1605},
                        Case{0, 20, 0.0, 0.1611}, Case{1, 29, 0.0061, 0.1718}}) {
    const ConfidenceInterval interval = wilson_interval(c.successes, c.tests);
    EXPECT_NEAR(interval.low, c.low, 5e-5) << c.successes << '/' << c.tests;
    EXPECT_NEAR(interval.high, c.high, 5e-5) << c.successes << '/' << c.tests;
  }
}

TEST(WilsonInterval, EndsExactlyAtZeroAndOne) {
  EXPECT_EQ(wilson_interval(0, 7).low, 0.0);
  EXPECT_EQ(wilson_interval(7, 7).high, 1.0);
}

TEST(MeanInterval, AgreesWithAHandWorkedExample) {
  // Mean 3, standard error sqrt(2.5 / 5), t(4; 0.975) = 2.776445.
  const Sample sample = summarise(std::array{1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_EQ(sample.mean, 3.0);
  EXPECT_EQ(sample.squares, 10.0);
  const auto interval = mean_interval(sample);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, 3 - 1.963243, 1e-6);
  EXPECT_NEAR(interval->high, 3 + 1.963243, 1e-6);
}

TEST(MeanInterval, DoesNotExistForFewerThanTwoValues) {
  EXPECT_FALSE(mean_interval(summarise(std::span<const double>{})));
  EXPECT_FALSE(mean_interval(summarise(std::array{4.0})));
}

TEST(MeanInterval, HasNoWidthIfAllValuesAreEqual) {
  const auto interval = mean_interval(summarise(std::array{4.0, 4.0, 4.0}));
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 4.0);
  EXPECT_EQ(interval->high, 4.0);
}

TEST(Sample, IsAccurateForLargeValuesOfSmallSpread) {
  const Sample sample = summarise(std::array{1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16});
  EXPECT_EQ(sample.mean, 1e9 + 10);
  EXPECT_EQ(sample.squares, 90.0);
}

}  // namespace
}  // namespace jaywalk
