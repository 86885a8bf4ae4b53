// SPDX-License-Identifier: Apache-2.0
// Conditions of --fail-on about assertions: `recovery.fail>0`.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/failure_condition.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;

/// Two behaviours judged by two assertions, with counts of verdicts for ten tests each.
Comparison judged() {
  Comparison comparison{.assertions = {"away", "slow"}};
  comparison.summaries = {{.behaviour = "walk", .tests = 10}, {.behaviour = "run", .tests = 10}};
  comparison.assessments = {{.verdicts = {{.tests = {4, 3, 2, 1}}, {.tests = {10, 0, 0, 0}}}},
                            {.verdicts = {{.tests = {0, 10, 0, 0}}, {.tests = {0, 0, 10, 0}}}}};
  return comparison;
}

std::optional<double> value(const char* subject, std::size_t row) {
  const FailureCondition condition = parse_failure_condition(std::string(subject) + ">0").value();
  EXPECT_EQ(subject_of(condition), subject);
  return value_of(condition, judged(), row);
}

TEST(VerdictConditions, CountTheTestsOfEachVerdict) {
  EXPECT_EQ(value("away.vacuous", 0), 4);
  EXPECT_EQ(value("away.pass", 0), 3);
  EXPECT_EQ(value("away.fail", 0), 2);
  EXPECT_EQ(value("away.unavoidable", 0), 1);
}

TEST(VerdictConditions, AreOfTheirAssertionAndRow) {
  EXPECT_EQ(value("slow.fail", 0), 0);
  EXPECT_EQ(value("slow.fail", 1), 10);
  EXPECT_EQ(value("away.pass", 1), 10);
}

TEST(VerdictConditions, TakeTheShareThatMetThePrecondition) {
  EXPECT_EQ(value("away.exercised_pct", 0), 60);
  EXPECT_EQ(value("slow.exercised_pct", 0), 0);
  EXPECT_EQ(value("slow.exercised_pct", 1), 100);
}

TEST(VerdictConditions, FailRowByRow) {
  const FailureCondition condition = parse_failure_condition("away.fail > 1").value();
  EXPECT_TRUE(fails(condition, judged(), 0));
  EXPECT_FALSE(fails(condition, judged(), 1));
}

TEST(VerdictConditions, AreMetWhereNothingWasJudged) {
  for (const char* text : {"away.fail>0", "away.exercised_pct>50"}) {
    const FailureCondition condition = parse_failure_condition(text).value();
    Comparison comparison = judged();
    comparison.assessments[0].verdicts[0] = {};  // all of its tests ended errored
    EXPECT_TRUE(fails(condition, comparison, 0)) << text;
    comparison.assessments.clear();
    EXPECT_TRUE(fails(condition, comparison, 0)) << text;
    comparison = judged();
    comparison.assertions = {"other", "slow"};
    EXPECT_TRUE(fails(condition, comparison, 0)) << text;
  }
}

TEST(VerdictConditions, SuggestTheVerdictThatWasMeant) {
  EXPECT_THAT(parse_failure_condition("away.fial>0").diagnostics().render(),
              HasSubstr("did you mean 'fail'?"));
  EXPECT_THAT(parse_failure_condition("away.broken>0").diagnostics().render(),
              HasSubstr("expected vacuous, pass, fail, unavoidable, exercised_pct"));
}

TEST(VerdictConditions, SayThatNoSuchAssertionIsJudged) {
  const FailureCondition condition = parse_failure_condition("awai.fail>0").value();
  Assertion away;
  away.id = "away";
  EXPECT_THAT(problems(condition, {&away, 1}).render(), HasSubstr("no assertion 'awai' is judged"));
  EXPECT_THAT(problems(condition, {&away, 1}).render(), HasSubstr("did you mean 'away'?"));
  EXPECT_THAT(problems(condition, {}).render(), HasSubstr("--assertions names a file"));
}

TEST(VerdictConditions, AreFineWhereTheAssertionIsJudged) {
  Assertion away;
  away.id = "away";
  EXPECT_TRUE(problems(parse_failure_condition("away.fail>0").value(), {&away, 1}).empty());
  EXPECT_TRUE(problems(parse_failure_condition("accuracy>0").value(), {}).empty())
      << "a measure needs none";
}

}  // namespace
}  // namespace jaywalk
