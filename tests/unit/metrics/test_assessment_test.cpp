// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/test_assessment.h"

#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/failure_condition.h"
#include "experiment/export/comparison_files.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;

Criteria criteria() {
  auto assertions = parse_assertions(std::make_shared<const Source>(
      "rules.yaml",
      "assertions:\n"
      "  - {id: away, source: s, precondition: eventually distance < 5, "
      "requirement: always closest > 1}\n"));
  return {.assertions = std::move(assertions.value()), .metrics = true};
}

/// The AV passes a pedestrian who stands that far from the middle of its way.
TestAssessment passing(double x) {
  const Recording recording = drive(1, {steps({0, 0}, {0, 10}, 3), steps({x, 10}, {0, 0}, 3)});
  return assess(criteria(), recording, road());
}

Comparison compared(const std::vector<double>& places) {
  const ExperimentPlan plan{.behaviours = {"a<b"}, .agents = {1}, .tests = places.size()};
  AssessmentTable table(criteria(), plan);
  // In any order.
  for (std::size_t i = places.size(); i-- > 0;) {
    table.add({.behaviour = 0, .agents = 1, .number = i}, passing(places[i]));
  }
  Comparison comparison{.assertions = {"away"}};
  comparison.summaries.push_back({.behaviour = "a<b", .agents = 1, .tests = places.size()});
  comparison.assessments.push_back(table.summary(0, 1));
  return comparison;
}

TEST(TestAssessment, CountVerdictsAndSpreadMetrics) {
  const Comparison comparison = compared({1.75, 3.25, 9.25});
  const VerdictCounts& counts = comparison.assessments[0].verdicts[0];
  EXPECT_EQ(counts.of(Verdict::fail), 1U);
  EXPECT_EQ(counts.of(Verdict::pass), 1U);
  EXPECT_EQ(counts.of(Verdict::vacuous), 1U);
  EXPECT_NEAR(exercised_pct(counts), 200.0 / 3, 1e-9);
  const Distribution& distance = comparison.assessments[0].metrics[0];
  EXPECT_EQ(distance.count, 3U);
  EXPECT_NEAR(distance.least, 0.5, 1e-9);
  EXPECT_NEAR(distance.median, 2, 1e-9);
  EXPECT_NEAR(distance.greatest, 8, 1e-9);
}

TEST(TestAssessment, QuantilesLieBetweenNeighbours) {
  const Distribution four = distribution({4, 1, 3, 2});
  EXPECT_DOUBLE_EQ(four.lower_quartile, 1.75);
  EXPECT_DOUBLE_EQ(four.median, 2.5);
  EXPECT_DOUBLE_EQ(four.upper_quartile, 3.25);
  EXPECT_DOUBLE_EQ(four.mean, 2.5);
  EXPECT_EQ(distribution({}).count, 0U);
}

TEST(TestAssessment, AreSpreadAlikeInLittleMemory) {
  constexpr std::size_t kColumns = 3;
  for (const std::size_t count : {1U, 7U, 8U, 9U, 5000U}) {
    ValueColumns columns(kColumns, 8);
    std::vector<std::vector<double>> kept(kColumns);
    std::mt19937 random(static_cast<unsigned>(count));
    for (std::size_t i = 0; i < count; ++i) {
      // Many are equal, zeros of both signs and infinite ones among them.
      const double value = i % 100 == 99 ? std::numeric_limits<double>::infinity()
                                         : (static_cast<double>(random() % 41) - 20) * 0.1;
      columns.add(i % 2, value * (i % 5 == 0 ? -1 : 1));
      kept[i % 2].push_back(value * (i % 5 == 0 ? -1 : 1));
    }
    for (std::size_t column = 0; column < kColumns; ++column) {
      const Distribution wanted = distribution(kept[column]);
      const Distribution found = columns.distribution(column);
      EXPECT_EQ(found.count, wanted.count);
      for (const auto value :
           {&Distribution::least, &Distribution::lower_quartile, &Distribution::median,
            &Distribution::upper_quartile, &Distribution::greatest, &Distribution::mean}) {
        EXPECT_THAT(found.*value, testing::NanSensitiveDoubleEq(wanted.*value));
      }
    }
  }
}

TEST(TestAssessment, BecomeColumnsOfTheCsv) {
  const std::string csv = to_csv(compared({1.75, 9.25}));
  EXPECT_THAT(csv, HasSubstr(",away_vacuous,away_pass,away_fail,away_unavoidable,"
                             "min_distance_count,min_distance_mean,"));
  EXPECT_THAT(csv, HasSubstr(",1,0,1,0,2,4.25,0.5,"));
}

TEST(TestAssessment, BecomeRowsOfAStore) {
  const auto rows = to_rows(criteria(), passing(1.75));
  EXPECT_EQ(rows[0].id, "away");
  EXPECT_EQ(rows[0].verdict, StoredVerdict::fail);
  EXPECT_EQ(rows[0].actor, 1U);
  EXPECT_EQ(rows[0].tick, 1U);
  EXPECT_NEAR(*rows[0].robustness, -0.5, 1e-9);
  EXPECT_EQ(rows[1].id, "min_distance");
  EXPECT_EQ(rows[1].verdict, StoredVerdict::none);
}

TEST(TestAssessment, BecomeJUnitCases) {
  const std::string xml = to_junit(compared({1.75, 3.25, 9.25}));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"away\" tests=\"1\" failures=\"1\""));
  EXPECT_THAT(xml, HasSubstr("name=\"a&lt;b, 1 agent\""));
  EXPECT_THAT(xml, HasSubstr("1 of 3 tests violate it"));
  EXPECT_THAT(to_junit(compared({9.25})), HasSubstr("no test exercised it"));
}

TEST(TestAssessment, MayFailAComparison) {
  const Comparison comparison = compared({1.75, 3.25, 9.25});
  const auto fails_on = [&](std::string_view text) {
    const auto condition = parse_failure_condition(text);
    return fails(condition.value(), comparison, 0);
  };
  EXPECT_TRUE(fails_on("away.fail>0"));
  EXPECT_FALSE(fails_on("away.fail>1"));
  EXPECT_TRUE(fails_on("away.exercised_pct < 70"));
  EXPECT_TRUE(fails_on("other.fail>0")) << "a measure without a value is no success";
  const auto unknown = parse_failure_condition("other.fail>0");
  EXPECT_THAT(problems(unknown.value(), criteria().assertions).render(),
              HasSubstr("no assertion 'other' is judged"));
  EXPECT_FALSE(parse_failure_condition("away.failed>0").ok());
}

}  // namespace
}  // namespace jaywalk
