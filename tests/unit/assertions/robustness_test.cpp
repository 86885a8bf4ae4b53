// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/assertions/robustness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/assertions/traces.h"

namespace jaywalk::stl {
namespace {

using testing::ElementsAre;

constexpr double kInf = std::numeric_limits<double>::infinity();

/// x and y of the only road user, 1, at ticks of one second.
TestTrace trace(std::vector<double> x, std::vector<double> y = {}, double tick_s = 1) {
  TestTrace result(x.size(), tick_s, 1);
  result.set(0, 1, std::move(x));
  if (!y.empty()) result.set(1, 1, std::move(y));
  return result;
}

std::vector<Truth> truths(const std::string& text, const Trace& over) {
  std::string errors;
  const auto parsed = expression(text, &errors);
  EXPECT_EQ(errors, "");
  return parsed ? evaluate(*parsed, parsed->root, over, 1) : std::vector<Truth>{};
}

std::vector<double> robustness(const std::string& text, const Trace& over) {
  std::vector<double> result;
  for (const Truth& truth : truths(text, over)) {
    result.push_back(truth.robustness);
    EXPECT_TRUE(truth.robustness == 0 || truth.holds == (truth.robustness > 0)) << text;
  }
  return result;
}

std::vector<bool> holds(const std::string& text, const Trace& over) {
  std::vector<bool> result;
  for (const Truth& truth : truths(text, over)) result.push_back(truth.holds);
  return result;
}

std::size_t violation(const std::string& text, const Trace& over) {
  const auto parsed = expression(text);
  return first_violation(*parsed, parsed->root, over, 1, 0);
}

TEST(Robustness, OfAComparisonIsTheSignedDifference) {
  EXPECT_THAT(robustness("x > 2", trace({5, 2, 1})), ElementsAre(3, 0, -1));
  EXPECT_THAT(robustness("x <= 2", trace({5, 2, 1})), ElementsAre(-3, 0, 1));
  EXPECT_THAT(robustness("x == 2", trace({5, 2})), ElementsAre(-3, 0));
  EXPECT_THAT(robustness("x != 2", trace({5, 2})), ElementsAre(3, 0));
}

TEST(Robustness, OfZeroLeavesTheConditionToDecide) {
  EXPECT_THAT(holds("x > 2", trace({2})), ElementsAre(false));
  EXPECT_THAT(holds("x >= 2", trace({2})), ElementsAre(true));
  EXPECT_THAT(holds("not (x > 2)", trace({2})), ElementsAre(true));
  EXPECT_THAT(holds("always x > 2", trace({3, 2, 4})), ElementsAre(false, false, true));
  EXPECT_THAT(holds("x >= 2 and x > 2", trace({2})), ElementsAre(false));
  EXPECT_THAT(holds("x >= 2 or x > 2", trace({2})), ElementsAre(true));
}

TEST(Robustness, OfAndIsTheMinimumOfOrTheMaximum) {
  const TestTrace over = trace({5}, {1});
  EXPECT_THAT(robustness("x > 2 and y > 0", over), ElementsAre(1));
  EXPECT_THAT(robustness("x > 2 or y > 0", over), ElementsAre(3));
  EXPECT_THAT(robustness("x > 2 => y > 3", over), ElementsAre(-2));
  EXPECT_THAT(robustness("not x > 2", over), ElementsAre(-3));
}

TEST(Robustness, ArithmeticKeepsItsPrecedence) {
  const TestTrace over = trace({6}, {2});
  EXPECT_THAT(robustness("x + 2 * y - 1 > 0", over), ElementsAre(9));
  EXPECT_THAT(robustness("(x + 2) * y / 4 > 0", over), ElementsAre(4));
  EXPECT_THAT(robustness("abs(y - x) + min(x, y) - max(x, y) >= -y", over), ElementsAre(2));
}

TEST(Robustness, OfAlwaysAndEventuallyIsTheLeastAndTheGreatestOfTheWindow) {
  const TestTrace over = trace({3, 1, 4, 1, 5});
  EXPECT_THAT(robustness("always x > 0", over), ElementsAre(1, 1, 1, 1, 5));
  EXPECT_THAT(robustness("eventually x > 0", over), ElementsAre(5, 5, 5, 5, 5));
  EXPECT_THAT(robustness("always[1, 2] x > 0", over), ElementsAre(1, 1, 1, 5, kInf));
  EXPECT_THAT(robustness("eventually[2, 3] x > 0", over), ElementsAre(4, 5, 5, -kInf, -kInf));
}

TEST(Robustness, OfHistoricallyAndOnceLooksBack) {
  const TestTrace over = trace({3, 1, 4, 1, 5});
  EXPECT_THAT(robustness("historically x > 0", over), ElementsAre(3, 1, 1, 1, 1));
  EXPECT_THAT(robustness("once[1, 2] x > 0", over), ElementsAre(-kInf, 3, 3, 4, 4));
  EXPECT_THAT(robustness("historically[2, inf] x > 0", over), ElementsAre(kInf, kInf, 3, 1, 1));
}

TEST(Robustness, OfUntilDemandsItsLeftSideOnlyBeforeTheRight) {
  // y holds first at tick 2; x need not hold there.
  const TestTrace over = trace({2, 2, -9}, {-1, -1, 7});
  EXPECT_THAT(robustness("x > 0 until y > 0", over), ElementsAre(2, 2, 7));
  EXPECT_THAT(robustness("x > 0 until[0, 1] y > 0", over), ElementsAre(-1, 2, 7));
  EXPECT_THAT(robustness("x > 0 until[1, 2] y > 0", over), ElementsAre(2, 2, -kInf));
}

TEST(Robustness, OfSinceDemandsItsLeftSideOnlyAfterTheRight) {
  const TestTrace over = trace({-9, 2, 3}, {7, -1, -1});
  EXPECT_THAT(robustness("x > 0 since y > 0", over), ElementsAre(7, 2, 2));
  EXPECT_THAT(robustness("x > 0 since[0, 1] y > 0", over), ElementsAre(7, 2, -1));
}

TEST(Robustness, WindowsAreSecondsThatCoverWholeTicks) {
  EXPECT_EQ(tick_window({0.3, 0.3}, 0.1).from, 3U) << "but for rounding";
  EXPECT_EQ(tick_window({0.3, 0.3}, 0.1).to, 3U);
  EXPECT_EQ(tick_window({0.2, 1.9}, 0.5).from, 1U);
  EXPECT_EQ(tick_window({0.2, 1.9}, 0.5).to, 3U);
  EXPECT_TRUE(tick_window({0.2, 0.4}, 1).empty);
  EXPECT_THAT(robustness("eventually[0.2, 0.4] x > 0", trace({1, 2})), ElementsAre(-kInf, -kInf));
}

TEST(Robustness, WhatDoesNotExistIsInfiniteAndEqualInfinitiesDoNotDiffer) {
  EXPECT_THAT(robustness("x > 1", trace({kInf})), ElementsAre(kInf));
  EXPECT_THAT(robustness("x - y >= 0", trace({kInf}, {kInf})), ElementsAre(0));
  EXPECT_THAT(holds("x <= y", trace({kInf}, {kInf})), ElementsAre(true));
  EXPECT_THAT(robustness("x * 0 >= 0", trace({kInf})), ElementsAre(0)) << "no NaN";
}

TEST(Robustness, QuantifiersGoThroughTheRoadUsers) {
  TestTrace over(2, 1, 3);
  over.set(0, 1, {1, 5});
  over.set(0, 2, {2, 3});
  over.set(0, 3, {9, 4});
  EXPECT_THAT(robustness("forall x > 0", over), ElementsAre(1, 3));
  EXPECT_THAT(robustness("exists (x > 0)", over), ElementsAre(9, 5));
  EXPECT_THAT(robustness("forall x > 0", TestTrace(1, 1, 0)), ElementsAre(kInf));
  EXPECT_THAT(robustness("exists x > 0", TestTrace(1, 1, 0)), ElementsAre(-kInf));
  EXPECT_THAT(robustness("p2.x > 0", over), ElementsAre(2, 3));
}

TEST(Robustness, EventsAndConditionsAreAllOrNothing) {
  TestTrace over(2, 1, 1);
  over.set(2, 1, {0, 1});
  over.set_event("precondition", 1, {1, 0});
  EXPECT_THAT(robustness("p", over), ElementsAre(-kInf, kInf));
  EXPECT_THAT(robustness("happens(precondition)", over), ElementsAre(kInf, -kInf));
  EXPECT_THAT(robustness("true", over), ElementsAre(kInf, kInf));
}

TEST(FirstViolation, IsTheFirstTickAtWhichADemandIsNotMet) {
  EXPECT_EQ(violation("always x > 0", trace({1, 1, 0, -5})), 2U);
  EXPECT_EQ(violation("always x > 0 and always y > 0", trace({1, 1, 0}, {1, 0, 1})), 1U);
  EXPECT_EQ(violation("eventually[0, 2] x > 5", trace({1, 1, 0, 9})), 2U);
  EXPECT_EQ(violation("always (x > 0 => always[1, 2] y > 0)", trace({0, 1, 1, 1}, {1, 0, 1, 0})),
            3U);
  EXPECT_EQ(violation("x > 2", trace({1, 9})), 0U);
}

}  // namespace
}  // namespace jaywalk::stl
