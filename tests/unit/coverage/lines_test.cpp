// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

CoveredPlace line(std::uint32_t number) { return {.line = number, .last_line = number}; }

CoveredCondition condition(std::uint32_t at, std::uint64_t asked, std::uint64_t held) {
  return {.where = line(at), .text = "c", .counts = {.asked = asked, .held = held}};
}

/// A file with one plan, whose trigger stands in line 1.
CoveredFile file_of(CoveredPlan plan) {
  plan.where = line(1);
  plan.trigger = "+!g";
  CoveredFile file;
  file.plans[plan.where] = std::move(plan);
  return file;
}

TEST(CoveredLines, CountHowOftenAPlanWasChosen) {
  const auto lines =
      covered_lines(file_of({.counts = {.relevant = 5, .applicable = 4, .chosen = 3}}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines.at(1).count, 3U);
  EXPECT_THAT(lines.at(1).gaps, IsEmpty());
}

TEST(CoveredLines, SayWhyAPlanWasNotChosen) {
  const auto gaps = [](PlanCounts counts) {
    return covered_lines(file_of({.counts = counts})).at(1).gaps;
  };
  EXPECT_THAT(gaps({}), ElementsAre("no such event: +!g"));
  EXPECT_THAT(gaps({.relevant = 2}), ElementsAre("never applicable, 2 times relevant: +!g"));
  EXPECT_THAT(gaps({.relevant = 2, .applicable = 1}),
              ElementsAre("never chosen, 1 times applicable: +!g"));
}

TEST(CoveredLines, SayWhichOutcomeOfAConditionWasNotSeen) {
  const auto gaps = [](std::uint64_t asked, std::uint64_t held) {
    CoveredPlan plan{.counts = {.relevant = 1, .applicable = 1, .chosen = 1}};
    plan.conditions = {condition(2, asked, held)};
    return covered_lines(file_of(plan)).at(2).gaps;
  };
  EXPECT_THAT(gaps(0, 0), ElementsAre("never asked: c"));
  EXPECT_THAT(gaps(3, 0), ElementsAre("never true: c"));
  EXPECT_THAT(gaps(3, 3), ElementsAre("never false: c"));
  EXPECT_THAT(gaps(3, 1), IsEmpty());
}

TEST(CoveredLines, SayNothingOfConditionsBehindAPlanThatWasNeverRelevant) {
  CoveredPlan plan;
  plan.conditions = {condition(2, 0, 0)};
  EXPECT_EQ(covered_lines(file_of(plan)).size(), 1U);
}

TEST(CoveredLines, SayWhichFormulasOfAChosenPlanWereNotExecuted) {
  CoveredPlan plan{.counts = {.relevant = 1, .applicable = 1, .chosen = 1}};
  plan.formulas = {{.where = line(2), .text = "a", .counts = {.executed = 1}},
                   {.where = line(3), .text = "b"}};
  const auto lines = covered_lines(file_of(plan));
  EXPECT_THAT(lines.at(2).gaps, IsEmpty());
  EXPECT_THAT(lines.at(3).gaps, ElementsAre("never executed: b"));
  plan.counts.chosen = 0;
  EXPECT_THAT(covered_lines(file_of(plan)).at(3).gaps, IsEmpty())
      << "what is behind a plan that was not chosen is clear";
}

TEST(CoveredLines, TakeTheGreatestCountOfWhatBeginsOnALine) {
  CoveredPlan plan{.counts = {.relevant = 9, .applicable = 9, .chosen = 2}};
  plan.conditions = {condition(1, 9, 4)};
  plan.formulas = {{.where = line(1), .text = "a", .counts = {.executed = 3}}};
  EXPECT_EQ(covered_lines(file_of(plan)).at(1).count, 9U);
}

TEST(CoveredLines, CountARuleByItsFirstCondition) {
  CoveredFile file;
  file.rules[line(4)] = {.where = line(4), .head = "r", .conditions = {condition(5, 6, 2)}};
  file.rules[line(8)] = {.where = line(8), .head = "s"};
  const auto lines = covered_lines(file);
  ASSERT_EQ(lines.size(), 2U) << "a rule without conditions cannot be covered";
  EXPECT_EQ(lines.at(4).count, 6U);
  EXPECT_EQ(lines.at(5).count, 6U);
}

TEST(Percent, HasOneDecimal) {
  EXPECT_EQ(percent({.covered = 3, .of = 4}), "75.0 %");
  EXPECT_EQ(percent({.covered = 1, .of = 3}), "33.3 %");
  EXPECT_EQ(percent({.covered = 0, .of = 3}), "0.0 %");
  EXPECT_EQ(percent({}), "-");
}

}  // namespace
}  // namespace jaywalk
