// SPDX-License-Identifier: Apache-2.0
#include "search/run_summary.h"

#include <gtest/gtest.h>

#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

TEST(Statistics, GiveMeanAndDeviationOfTheSample) {
  const std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
  const MeanAndDeviation result = mean_and_deviation(values);
  EXPECT_DOUBLE_EQ(result.mean, 5);
  EXPECT_NEAR(result.deviation, 2.138, 0.001);
}

// Conover's example: differences 1 ... n all positive leave one sum of 2^n on each side.
TEST(Wilcoxon, IsExactWhereAllDifferencesHaveOneSign) {
  const std::vector<double> zero(6);
  const std::vector<double> greater{1, 2, 3, 4, 5, 6};
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank(greater, zero), 2.0 / 64);
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank(zero, greater), 2.0 / 64);
}

// R: wilcox.test(c(125,115,130,140,140,115,140,125,140,135),
// c(110,122,125,120,140,124,123,137,135,145), paired=TRUE): V = 27 of nine differences, two of them
// ties; the exact distribution with shared ranks.
TEST(Wilcoxon, SharesRanksAndLeavesZerosOut) {
  const std::vector<double> a{125, 115, 130, 140, 140, 115, 140, 125, 140, 135};
  const std::vector<double> b{110, 122, 125, 120, 140, 124, 123, 137, 135, 145};
  EXPECT_NEAR(wilcoxon_signed_rank(a, b), 0.63, 0.03);
}

TEST(Wilcoxon, SeesNoDifferenceBetweenEqualValues) {
  const std::vector<double> values{1, 2, 3};
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank(values, values), 1);
}

TEST(Diversity, IsTheMedianOfThePairwiseDistances) {
  EXPECT_DOUBLE_EQ(median_distance({{0, 0}, {3, 4}, {0, 1}}), std::sqrt(18.0));
  EXPECT_DOUBLE_EQ(median_distance({{0, 0}}), 0);
  EXPECT_DOUBLE_EQ(median({4, 1, 3, 2}), 2.5);
}

TEST(Clusters, JoinWhatIsNearAndPutTheLargestFirst) {
  const std::vector<double> places{0, 10, 10.5, 0.2, 9.8};
  const auto groups = cluster(places.size(), [&](std::size_t founder, std::size_t other) {
    return std::abs(places[founder] - places[other]) <= 1;
  });
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0], (std::vector<std::size_t>{1, 2, 4}));
  EXPECT_EQ(groups[1], (std::vector<std::size_t>{0, 3}));
}

TEST(TestsToSomething, CountsSearchesThatFoundNothingAsLonger) {
  const std::vector<double> executed{9, 300, 300, 200};
  const TestsTo most = tests_to(std::vector{9.0, 30.0, kUnknown, 20.0}, executed);
  EXPECT_EQ(most.found, 3U);
  EXPECT_EQ(most.searches, 4U);
  EXPECT_EQ(most.median, 25) << "of 9, 20, 30 and more";
  EXPECT_EQ(text_of(most), "3 of 4, 25");
  const TestsTo half = tests_to(std::vector{9.0, kUnknown, kUnknown, 20.0}, executed);
  EXPECT_EQ(half.median, std::nullopt) << "the third is not known";
  EXPECT_EQ(text_of(half), "2 of 4, > 300");
  const TestsTo none = tests_to(std::vector{kUnknown, kUnknown}, std::vector{300.0, 200.0});
  EXPECT_EQ(text_of(none), "0 of 2, > 200") << "that is certain of both";
  EXPECT_EQ(tests_to(std::vector{5.0, kUnknown, 3.0}, std::vector{5.0, 6.0, 3.0}).median, 5);
}

/// The corner's SUT with a requirement, of which `nearness` is the robustness.
class JudgedCorner : public CornerSut {
 public:
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kJudged; }

  static constexpr std::array kJudged = {
      MeasureKind{.name = "nearness", .meaning = "", .requirement = "near"}};
};

TEST(Summaries, HaveTheFirstViolationOfARequirement) {
  SearchRun run;
  for (const double robustness : {0.5, 0.0, -0.1, -0.2}) {
    run.tests.push_back(
        {.test = {.input = {Form::vector, {0, 0}}, .outcome = {.measures = {robustness}}}});
  }
  run.tests.insert(run.tests.begin(), TestRow{.candidates = 1, .invalid = 1});
  run.tests[0].test.input = {Form::vector, {0, 0}};
  run.tests[0].test.outcome.refused = "no";
  const RunSummary summary = summarise(run, JudgedCorner());
  EXPECT_EQ(summary.tests, 4) << "the refused one is none";
  EXPECT_EQ(summary.errors, 0);
  EXPECT_EQ(summary.invalid_pct, 100) << "of the only candidate that was counted";
  EXPECT_EQ(summary.tests_to_violation, std::vector<double>{3});
}

// A mean of 2 and 4 tests over three searches, of which one found nothing, is 3, not 2.
TEST(Statistics, LeaveOutSearchesWithoutAValue) {
  EXPECT_DOUBLE_EQ(mean_and_deviation(std::vector{2.0, kUnknown, 4.0}).mean, 3);
  EXPECT_TRUE(std::isnan(mean_and_deviation(std::vector{kUnknown}).mean));
  EXPECT_TRUE(std::isnan(summarise(SearchRun{}, CornerSut()).tests_to_failure));
}

TEST(RunSummary, CountsWhatASearchFound) {
  SearchRun run;
  for (const double fitness : {0.1, 0.2, 0.95, 0.4, 1.0}) {
    TestRow row{.candidates = 4, .invalid = 1};
    row.test = {.input = {Form::vector, {fitness, 0}},
                .outcome = {.simulated_s = 3, .measures = {fitness}},
                .fitness = fitness,
                .failed = fitness >= 0.9};
    run.tests.push_back(row);
  }
  const RunSummary summary = summarise(run, CornerSut());
  EXPECT_DOUBLE_EQ(summary.tests, 5);
  EXPECT_DOUBLE_EQ(summary.failures, 2);
  EXPECT_DOUBLE_EQ(summary.tests_to_failure, 3);
  EXPECT_DOUBLE_EQ(summary.failures_per_1000, 400);
  EXPECT_NEAR(summary.fitness_last_80, (0.2 + 0.95 + 0.4 + 1.0) / 4, 1e-12);
  EXPECT_DOUBLE_EQ(summary.fitness_last_20, 1);
  EXPECT_NEAR(summary.diversity, 0.05, 1e-12);
  EXPECT_DOUBLE_EQ(summary.invalid_pct, 25);
  EXPECT_DOUBLE_EQ(summary.simulated_s, 3);
}

}  // namespace
}  // namespace jaywalk::search
