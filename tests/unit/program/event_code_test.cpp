// SPDX-License-Identifier: Apache-2.0
// Decoding of plans and formulas: heads; constants, variables and simple sums.

#include "interpreter/program/event_code.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;

/// The steps of the head of the plan with this trigger, `first 0`, `constant a`, `pair`; "whole":
/// the unifier matches it.
std::string head(const std::string& trigger) {
  const CompiledProgram made(trigger + ".");
  const PlanHead& head = made.plan().head;
  if (!head.is_decoded) return "whole";
  std::vector<std::string> all;
  for (const HeadStep& step : head.code.steps()) {
    switch (step.kind) {
      case HeadStep::Kind::first:
        all.push_back(fmt::format("first {}", step.slot));
        break;
      case HeadStep::Kind::again:
        all.push_back(fmt::format("again {}", step.slot));
        break;
      case HeadStep::Kind::constant:
        all.push_back("constant " + made.text(step.term));
        break;
      default:
        all.push_back(step.is_pair() ? "pair" : "term");
        break;
    }
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

bool tells_goal(const std::string& trigger) {
  return CompiledProgram(trigger + ".").plan().head.tells_goal;
}

TEST(PlanHead, IsMatchedStepByStep) {
  EXPECT_EQ(head("+!g(1, a, X, Y)"), "constant 1, constant a, first 0, first 1");
  EXPECT_EQ(head("+!g"), "");
  EXPECT_EQ(head("+!g(_, _)"), "first 0, first 1");
  EXPECT_EQ(head("+!g(X, X)"), "first 0, again 0");
  EXPECT_EQ(head("+!g([H|T], [])"), "pair, first 0, first 1, constant []");
  EXPECT_EQ(head("+!g([1], f(X), \"t\", Y + 1)"), "term, term, term, term");
}

TEST(PlanHead, IsLeftToTheUnifierIfItHasAnnotationsOrIsAVariable) {
  EXPECT_EQ(head("+!g(X)[source(Y)]"), "whole");
  EXPECT_EQ(head("+!X"), "whole");
}

TEST(PlanHead, TellsItsGoalIfItLosesNothingOfIt) {
  EXPECT_TRUE(tells_goal("+!g"));
  EXPECT_TRUE(tells_goal("+!g(1, a, X, _, [H|T])"));
  EXPECT_FALSE(tells_goal("+!g(X, X)"));
  EXPECT_FALSE(tells_goal("+!g([a|T])"));
  EXPECT_FALSE(tells_goal("+!g([H|T], [H|R])"));
  EXPECT_FALSE(tells_goal("+!g(f(X))"));
  EXPECT_FALSE(tells_goal("+!g(X)[source(Y)]"));
}

/// How many arguments of a formula's literal are decoded; -1: it is left to the unifier.
int decoded_arguments(const std::string& formula) {
  const CompiledProgram made("+!g(X, Y) <- " + formula + ".");
  const EventCode& code = *made.plan().code.entry->steps.front().event;
  return code.is_decoded ? static_cast<int>(code.args.size()) : -1;
}

TEST(EventCode, HasArgumentsThatAreConstantsVariablesOrSimpleSums) {
  EXPECT_EQ(decoded_arguments("!h(1, a, X, X + 1, X - Y, 2 * X)"), 6);
  EXPECT_EQ(decoded_arguments("+b(X)"), 1);
  EXPECT_EQ(decoded_arguments("!h"), 0);
}

TEST(EventCode, IsNotDecodedIfOneArgumentIsAnotherTerm) {
  EXPECT_EQ(decoded_arguments("!h(1, f(X))"), -1);
  EXPECT_EQ(decoded_arguments("!h(X / Y)"), -1);
  EXPECT_EQ(decoded_arguments("!h(X + Y + 1)"), -1);
  EXPECT_EQ(decoded_arguments("!h(1)[x]"), -1);
  EXPECT_EQ(decoded_arguments("!h(1, 2, 3, 4, 5, 6, 7, 8)"), 8);
  EXPECT_EQ(decoded_arguments("!h(1, 2, 3, 4, 5, 6, 7, 8, 9)"), -1);
}

}  // namespace
}  // namespace jaywalk
