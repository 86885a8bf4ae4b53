// SPDX-License-Identifier: Apache-2.0
// What holds of statistics and kills whatever the numbers are: against counting by hand and brute
// force.

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/kills/kills.h"
#include "experiment/compare/measures/distribution.h"
#include "experiment/compare/measures/significance.h"
#include "experiment/judge/csv_line.h"

namespace jaywalk {
namespace {

std::vector<double> random_values(std::mt19937_64& random, std::size_t count, int most = 9) {
  std::vector<double> values(count);
  for (double& value : values) value = static_cast<double>(random() % static_cast<unsigned>(most));
  return values;
}

TEST(WilsonLaws, TheIntervalHasTheShareAndIsItsOwnMirror) {
  for (std::uint64_t tests = 1; tests <= 30; ++tests) {
    for (std::uint64_t successes = 0; successes <= tests; ++successes) {
      const ConfidenceInterval of = wilson_interval(successes, tests);
      const double share = static_cast<double>(successes) / static_cast<double>(tests);
      EXPECT_LE(of.low, share + 1e-12);
      EXPECT_GE(of.high, share - 1e-12);
      EXPECT_GE(of.low, 0);
      EXPECT_LE(of.high, 1);
      const ConfidenceInterval mirror = wilson_interval(tests - successes, tests);
      EXPECT_NEAR(of.low, 1 - mirror.high, 1e-12);
    }
  }
}

TEST(WilsonLaws, MoreTestsAndLessConfidenceNarrowIt) {
  const auto width = [](std::uint64_t tests, double confidence) {
    const ConfidenceInterval of = wilson_interval(tests / 4, tests, confidence);
    return of.high - of.low;
  };
  EXPECT_GT(width(20, 0.95), width(40, 0.95));
  EXPECT_GT(width(40, 0.95), width(400, 0.95));
  EXPECT_GT(width(40, 0.99), width(40, 0.95));
}

TEST(SampleLaws, TwoPassesOfOneAtATimeAreTheSameToTheBit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> values(random() % 40);
    for (double& value : values) value = std::ldexp(static_cast<double>(random()), -50) - 5000;
    SampleMaker maker;
    for (int pass = 0; pass < 2; ++pass) {
      for (const double value : values) maker.add(value);
      maker.end_pass();
    }
    const Sample whole = summarise(values);
    EXPECT_EQ(maker.sample().count, whole.count);
    EXPECT_EQ(maker.sample().mean, whole.mean);
    EXPECT_EQ(maker.sample().squares, whole.squares);
  }
}

TEST(RankCorrelationLaws, NothingButTheOrderCounts) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    const std::vector<double> first = random_values(random, 8);
    const std::vector<double> second = random_values(random, 8);
    const auto expected = rank_correlation(first, second);
    std::vector<double> stretched = first;
    for (double& value : stretched) value = std::exp(value) + 3;
    std::vector<double> turned = first;
    for (double& value : turned) value = -value;
    ASSERT_EQ(rank_correlation(stretched, second).has_value(), expected.has_value());
    if (!expected) continue;
    EXPECT_NEAR(*rank_correlation(stretched, second), *expected, 1e-12);
    EXPECT_NEAR(*rank_correlation(second, first), *expected, 1e-12);
    EXPECT_NEAR(*rank_correlation(turned, second), -*expected, 1e-12);
    EXPECT_LE(std::fabs(*expected), 1 + 1e-12);
  }
}

TEST(RankCorrelationLaws, OfAListWithItselfIsOne) {
  const std::vector<double> values{3, 1, 4, 1, 5};
  EXPECT_NEAR(rank_correlation(values, values).value(), 1, 1e-12);
  EXPECT_FALSE(rank_correlation(values, std::vector<double>(5, 2)));
  EXPECT_FALSE(rank_correlation(std::vector{1.0}, std::vector{2.0}));
}

TEST(McNemarLaws, ItIsTheShareOfCoinThrowsNoMoreEven) {
  for (std::uint64_t first = 0; first <= 6; ++first) {
    for (std::uint64_t second = 0; first + second <= 10; ++second) {
      const std::uint64_t all = first + second;
      if (all == 0) continue;
      // Each way in which the tests that differ could have fallen.
      const std::uint64_t fewer = std::min(first, second);
      double as_odd = 0;
      for (std::uint64_t fallen = 0; fallen < std::uint64_t{1} << all; ++fallen) {
        const auto ones = static_cast<std::uint64_t>(std::popcount(fallen));
        as_odd += ones <= fewer || ones >= all - fewer ? 1 : 0;
      }
      const double expected = std::min(1.0, as_odd / std::ldexp(1, static_cast<int>(all)));
      EXPECT_NEAR(mcnemar({.both = 3, .first_only = first, .second_only = second}), expected, 1e-9)
          << first << ' ' << second;
    }
  }
}

TEST(RankComparisonLaws, TheEffectIsTheShareOfPairsThatAreGreater) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 40; ++i) {
    Counts first;
    Counts second;
    for (int k = 0; k < 12; ++k) {
      ++first[static_cast<std::uint32_t>(random() % 6)];
      ++second[static_cast<std::uint32_t>(random() % 6)];
    }
    double greater = 0;
    for (const auto& [a, times] : first) {
      for (const auto& [b, others] : second) {
        greater += static_cast<double>(times * others) * (a > b ? 1 : a == b ? 0.5 : 0);
      }
    }
    const RankComparison comparison = compare_ranks(first, second).value();
    EXPECT_NEAR(comparison.a12, greater / (12 * 12), 1e-12);
    EXPECT_NEAR(compare_ranks(second, first)->a12, 1 - comparison.a12, 1e-12);
    EXPECT_GT(comparison.p, 0);
    EXPECT_LE(comparison.p, 1);
  }
}

TEST(MeanComparisonLaws, TurnTheirSignWithTheSides) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 40; ++i) {
    const Sample first = summarise(random_values(random, 6));
    const Sample second = summarise(random_values(random, 9));
    const auto there = compare_means(first, second);
    const auto back = compare_means(second, first);
    ASSERT_EQ(there.has_value(), back.has_value());
    if (!there) continue;
    EXPECT_NEAR(there->p, back->p, 1e-12);
    EXPECT_NEAR(there->g, -back->g, 1e-12);
    EXPECT_EQ(there->g > 0, first.mean > second.mean);
  }
}

TEST(HolmLaws, NoValueFallsAndTheirOrderStays) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> values = random_values(random, 7, 1000);
    for (double& value : values) value /= 1000;
    const std::vector<double> corrected = holm(values);
    ASSERT_EQ(corrected.size(), values.size());
    const std::size_t least =
        static_cast<std::size_t>(std::ranges::min_element(values) - values.begin());
    EXPECT_NEAR(corrected[least], std::min(1.0, 7 * values[least]), 1e-12);
    for (std::size_t a = 0; a < values.size(); ++a) {
      EXPECT_GE(corrected[a], values[a]);
      EXPECT_LE(corrected[a], std::min(1.0, 7 * values[a]) + 1e-12) << "Bonferroni's is no less";
      for (std::size_t b = 0; b < values.size(); ++b) {
        if (values[a] < values[b]) {
          EXPECT_LE(corrected[a], corrected[b] + 1e-12);
        }
      }
    }
  }
}

TEST(DistributionLaws, ItsMarksAreInOrderAndFollowTheValues) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> values = random_values(random, 1 + random() % 20, 100);
    const Distribution of = distribution(values);
    EXPECT_LE(of.least, of.lower_quartile);
    EXPECT_LE(of.lower_quartile, of.median);
    EXPECT_LE(of.median, of.upper_quartile);
    EXPECT_LE(of.upper_quartile, of.greatest);
    std::ranges::shuffle(values, random);
    EXPECT_EQ(distribution(values).median, of.median) << "whatever their order";
    for (double& value : values) value = 2 * value - 7;
    EXPECT_NEAR(distribution(values).upper_quartile, 2 * of.upper_quartile - 7, 1e-9);
    EXPECT_NEAR(distribution(values).mean, 2 * of.mean - 7, 1e-9);
  }
}

TEST(DistributionLaws, ColumnsInAFileAreThoseInMemory) {
  std::mt19937_64 random(7);
  for (const std::size_t most : {1U, 2U, 5U, 1000U}) {
    ValueColumns columns(2, most);
    std::vector<double> first;
    std::vector<double> second;
    for (int i = 0; i < 60; ++i) {
      const double value = static_cast<double>(random() % 9) - 4;
      columns.add(0, value);
      first.push_back(value);
      if (i % 7 != 0) continue;
      columns.add(1, -value);
      second.push_back(-value);
    }
    for (const auto& [column, values] : {std::pair{0U, first}, std::pair{1U, second}}) {
      const Distribution expected = distribution(values);
      const Distribution found = columns.distribution(column);
      EXPECT_EQ(found.count, expected.count);
      EXPECT_EQ(found.mean, expected.mean);
      EXPECT_EQ(found.lower_quartile, expected.lower_quartile);
      EXPECT_EQ(found.greatest, expected.greatest);
    }
  }
}

/// Some behaviours and defects; each pair kills with a chance of a third.
KillMatrix random_matrix(std::mt19937_64& random, std::size_t rows, std::size_t defects) {
  KillMatrix matrix;
  for (std::size_t i = 0; i < defects; ++i) matrix.defects.push_back("d" + std::to_string(i));
  for (std::size_t row = 0; row < rows; ++row) {
    KillRow& of = matrix.rows.emplace_back(KillRow{.behaviour = "b" + std::to_string(row)});
    for (std::size_t i = 0; i < defects; ++i) {
      of.cells.push_back({.tests = 10, .kills = random() % 3 == 0 ? 1 + random() % 9 : 0});
    }
  }
  return matrix;
}

/// Which defects a set of rows kills, as bits; the rows, too.
std::uint64_t killed_by(const KillMatrix& matrix, std::uint64_t rows) {
  std::uint64_t killed = 0;
  for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
    if ((rows >> row & 1U) == 0) continue;
    for (std::size_t i = 0; i < matrix.defects.size(); ++i) {
      if (matrix.rows[row].cells[i].kills > 0) killed |= std::uint64_t{1} << i;
    }
  }
  return killed;
}

TEST(SmallestTeamLaws, NoSmallerSetOfRowsKillsAsMuch) {
  std::mt19937_64 random(8);
  // Among many matrices some have a smallest team that always taking the best row does not find.
  for (int i = 0; i < 100; ++i) {
    const KillMatrix matrix = random_matrix(random, 3 + random() % 6, 6 + random() % 9);
    const std::uint64_t all_rows = (std::uint64_t{1} << matrix.rows.size()) - 1;
    const std::uint64_t all = killed_by(matrix, all_rows);
    int fewest = 64;
    for (std::uint64_t rows = 0; rows <= all_rows; ++rows) {
      if (killed_by(matrix, rows) == all) fewest = std::min(fewest, std::popcount(rows));
    }
    std::uint64_t team = 0;
    for (const std::size_t row : smallest_team(matrix)) team |= std::uint64_t{1} << row;
    EXPECT_EQ(killed_by(matrix, team), all);
    EXPECT_EQ(std::popcount(team), fewest);
  }
}

TEST(SurvivorLaws, AreThoseThatNoTeamKills) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 40; ++i) {
    const KillMatrix matrix = random_matrix(random, 2, 6);
    const std::uint64_t killed = killed_by(matrix, 3);
    for (const std::size_t defect : survivors(matrix)) EXPECT_EQ(killed >> defect & 1U, 0U);
    EXPECT_EQ(survivors(matrix).size() + static_cast<std::size_t>(std::popcount(killed)), 6U);
    for (std::size_t defect = 0; defect < 6; ++defect) {
      EXPECT_EQ(best_killer(matrix, defect).has_value(), (killed >> defect & 1U) != 0);
    }
  }
}

/// Of `tests` of which `kills` kill, in how many choices of `drawn` tests some kills, as a share.
double share_of_choices(std::uint64_t tests, std::uint64_t kills, int drawn) {
  double killing = 0;
  double all = 0;
  const std::uint64_t killers = (std::uint64_t{1} << kills) - 1;
  for (std::uint64_t choice = 0; choice < std::uint64_t{1} << tests; ++choice) {
    if (std::popcount(choice) != drawn) continue;
    all += 1;
    killing += (choice & killers) != 0 ? 1 : 0;
  }
  return killing / all;
}

TEST(MutationScoreLaws, ItIsTheMeanOverAllChoicesOfTests) {
  for (const std::uint64_t kills : {0U, 1U, 3U, 7U, 8U}) {
    const KillRow row{.behaviour = "b", .cells = {{.tests = 8, .kills = kills}}};
    double last = 0;
    for (int drawn = 1; drawn <= 8; ++drawn) {
      const double score = mutation_score(row, static_cast<std::uint64_t>(drawn));
      EXPECT_NEAR(score, share_of_choices(8, kills, drawn), 1e-12) << kills << ' ' << drawn;
      EXPECT_GE(score, last) << "more tests never kill less";
      last = score;
    }
  }
}

TEST(FirstKillLaws, HalfOfAllOrdersHaveKilledByThen) {
  for (std::uint64_t kills = 1; kills <= 8; ++kills) {
    const KillCell cell{.tests = 8, .kills = kills};
    const auto median = static_cast<int>(first_kill_median(cell).value());
    EXPECT_GE(share_of_choices(8, kills, median), 0.5);
    if (median > 1) {
      EXPECT_LT(share_of_choices(8, kills, median - 1), 0.5);
    }
  }
}

std::string field(std::optional<double> value) {
  std::string line = "a";
  add_csv_field(line, value);
  return line;
}

TEST(CsvNumbers, HaveSixDecimalsAtMost) {
  EXPECT_EQ(field(1.5), "a,1.5");
  EXPECT_EQ(field(2), "a,2");
  EXPECT_EQ(field(1.0 / 3), "a,0.333333");
  EXPECT_EQ(field(2.0 / 3), "a,0.666667");
  EXPECT_EQ(field(100), "a,100") << "zeros before the point stay";
  EXPECT_EQ(field(1e-9), "a,0");
  EXPECT_EQ(field(-1e-9), "a,0") << "without a sign";
  EXPECT_EQ(field(-0.25), "a,-0.25");
  EXPECT_EQ(field(std::nullopt), "a,");
}

}  // namespace
}  // namespace jaywalk
