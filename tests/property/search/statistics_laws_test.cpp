// SPDX-License-Identifier: Apache-2.0
// Laws of the statistics of searches, and of NSGA-II's ranks, against what is counted by brute
// force.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "search/evolve/nsga2.h"
#include "search/run_summary.h"
#include "search/sut.h"

namespace jaywalk::search {
namespace {

/// The share of all signings of the differences with a rank sum as far from the middle.
double by_enumeration(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != second[i]) differences.push_back(first[i] - second[i]);
  }
  if (differences.empty()) return 1;
  std::vector<double> ranks;
  for (const double each : differences) {
    double below = 0;
    double equal = 0;
    for (const double other : differences) {
      below += std::fabs(other) < std::fabs(each) ? 1 : 0;
      equal += std::fabs(other) == std::fabs(each) ? 1 : 0;
    }
    ranks.push_back(below + (equal + 1) / 2);
  }
  const double middle = std::accumulate(ranks.begin(), ranks.end(), 0.0) / 2;
  double observed = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) observed += differences[i] > 0 ? ranks[i] : 0;
  std::size_t as_far = 0;
  const std::size_t ways = std::size_t{1} << ranks.size();
  for (std::size_t signs = 0; signs < ways; ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (signs >> i & 1U) != 0 ? ranks[i] : 0;
    as_far += std::fabs(sum - middle) >= std::fabs(observed - middle) - 1e-9 ? 1 : 0;
  }
  return static_cast<double>(as_far) / static_cast<double>(ways);
}

/// Whole numbers, so that differences are equal, and zero, now and then.
std::vector<double> whole_numbers(Random& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& each : values) each = std::floor(random.uniform(0, 6));
  return values;
}

class StatisticsLaws : public testing::TestWithParam<std::uint64_t> {
 protected:
  Random random_{GetParam()};
};

TEST_P(StatisticsLaws, WilcoxonCountsAllWaysToGiveSigns) {
  const std::vector<double> first = whole_numbers(random_, 9);
  const std::vector<double> second = whole_numbers(random_, 9);
  EXPECT_NEAR(wilcoxon_signed_rank(first, second), by_enumeration(first, second), 1e-12);
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank(first, second), wilcoxon_signed_rank(second, first));
}

TEST_P(StatisticsLaws, WilcoxonKnowsOfDifferencesAlone) {
  const std::vector<double> first = whole_numbers(random_, 8);
  std::vector<double> second = whole_numbers(random_, 8);
  std::vector<double> moved = first;
  std::vector<double> moved_too = second;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = 4 * (moved[i] + static_cast<double>(i));
    moved_too[i] = 4 * (moved_too[i] + static_cast<double>(i));
  }
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank(moved, moved_too), wilcoxon_signed_rank(first, second));
}

TEST_P(StatisticsLaws, MedianHasAsManyOnEitherSideInAnyOrder) {
  std::vector<double> values = whole_numbers(random_, 1 + random_.below(12));
  const double middle = median(values);
  const auto below = std::ranges::count_if(values, [&](double v) { return v < middle; });
  const auto above = std::ranges::count_if(values, [&](double v) { return v > middle; });
  EXPECT_LE(2 * below, std::ssize(values));
  EXPECT_LE(2 * above, std::ssize(values));
  std::ranges::reverse(values);
  EXPECT_EQ(median(values), middle);
}

TEST_P(StatisticsLaws, DeviationsScaleWithTheValuesAndDoNotMove) {
  std::vector<double> values = whole_numbers(random_, 7);
  const MeanAndDeviation before = mean_and_deviation(values);
  for (double& each : values) each = 100 - 3 * each;
  values.push_back(kUnknown);
  const MeanAndDeviation after = mean_and_deviation(values);
  EXPECT_NEAR(after.mean, 100 - 3 * before.mean, 1e-9);
  EXPECT_NEAR(after.deviation, 3 * before.deviation, 1e-9);
}

TEST_P(StatisticsLaws, ClustersHoldEverybodyOnceTheLargestFirst) {
  const std::vector<double> values = whole_numbers(random_, 20);
  const auto groups = cluster(values.size(), [&](std::size_t a, std::size_t b) {
    return std::fabs(values[a] - values[b]) <= 1;
  });
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    ASSERT_FALSE(groups[i].empty());
    if (i > 0) {
      EXPECT_GE(groups[i - 1].size(), groups[i].size());
    }
    const std::size_t founder = groups[i].front();
    EXPECT_EQ(founder, std::ranges::min(groups[i]));
    for (const std::size_t each : groups[i]) {
      EXPECT_TRUE(seen.insert(each).second);
      EXPECT_LE(std::fabs(values[founder] - values[each]), 1);
    }
    // No founder could have joined a group that was founded before.
    for (const auto& other : groups) {
      if (other.front() < founder) {
        EXPECT_GT(std::fabs(values[other.front()] - values[founder]), 1);
      }
    }
  }
  EXPECT_EQ(seen.size(), values.size());
}

TEST_P(StatisticsLaws, FrontsAreWhatIsLeftWhenThoseBeforeAreTakenAway) {
  std::vector<Worth> worths(25);
  for (Worth& each : worths) {
    each.objectives = {std::floor(random_.uniform(0, 5)), std::floor(random_.uniform(0, 5))};
    each.lacks = std::floor(random_.uniform(0, 2));
  }
  const std::vector<Standing> standings = rank(worths);
  for (std::size_t i = 0; i < worths.size(); ++i) {
    // The longest chain of those who dominate each other down to this one.
    bool has_cause = standings[i].front == 0;
    for (std::size_t j = 0; j < worths.size(); ++j) {
      if (!dominates(worths[j], worths[i])) continue;
      EXPECT_LT(standings[j].front, standings[i].front);
      has_cause = has_cause || standings[j].front + 1 == standings[i].front;
    }
    EXPECT_TRUE(has_cause) << "nobody of the front before dominates " << i;
    EXPECT_FALSE(dominates(worths[i], worths[i]));
  }
}

TEST_P(StatisticsLaws, SurvivorsAreNoWorseThanThoseWhoDoNot) {
  std::vector<Worth> worths(20);
  for (Worth& each : worths) each.objectives = {random_.uniform(0, 1), random_.uniform(0, 1)};
  const std::vector<Standing> standings = rank(worths);
  const std::vector<std::size_t> alive = survivors(standings, 8);
  ASSERT_EQ(alive.size(), 8U);
  const std::set<std::size_t> survive(alive.begin(), alive.end());
  EXPECT_EQ(survive.size(), 8U);
  for (std::size_t i = 0; i < worths.size(); ++i) {
    if (survive.contains(i)) continue;
    EXPECT_FALSE(better(standings[i], standings[alive.back()]));
  }
}

TEST_P(StatisticsLaws, FitnessIsBetweenNothingAndOneAndGrowsWithTheMeasure) {
  const double harmless = random_.uniform(-5, 5);
  const double worst = harmless + random_.uniform(0.1, 5);
  const Fitness rising{.harmless = harmless, .worst = worst};
  const Fitness falling{.harmless = worst, .worst = harmless};
  double last = -1;
  for (double value = -12; value < 12; value += 0.25) {
    const Outcome outcome{.measures = {value}};
    EXPECT_GE(rising.of(outcome), std::max(0.0, last));
    EXPECT_LE(rising.of(outcome), 1);
    EXPECT_NEAR(rising.of(outcome) + falling.of(outcome), 1, 1e-9);
    last = rising.of(outcome);
  }
  EXPECT_EQ(last, 1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, StatisticsLaws, testing::Range<std::uint64_t>(1, 21));

}  // namespace
}  // namespace jaywalk::search
