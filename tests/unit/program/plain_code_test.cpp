// What strides may take of plans and formulas: constants, variables and simple sums.

#include "interpreter/program/plain_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;

/// The head of the plan with this trigger: a slot's number or a constant for each argument; "none".
std::string head(const std::string& trigger) {
  const CompiledProgram made(trigger + ".");
  const PlainPlan& plain = made.plan().plain;
  if (!plain.has_plain_head) return "none";
  std::string all;
  for (const HeadArgument& each : plain.head) {
    all +=
        each.slot == Operand::kNoSlot ? made.text(each.constant) : "_" + std::to_string(each.slot);
    all += ' ';
  }
  return all;
}

TEST(PlainPlan, HasAHeadOfConstantsAndVariablesThatDiffer) {
  EXPECT_EQ(head("+!g(1, a, X, Y)"), "1 a _0 _1 ");
  EXPECT_EQ(head("+!g"), "");
  EXPECT_EQ(head("+!g(_, _)"), "_0 _1 ");
}

TEST(PlainPlan, HasNoHeadThatNeedsUnification) {
  EXPECT_EQ(head("+!g(X, X)"), "none");
  EXPECT_EQ(head("+!g([1])"), "none");
  EXPECT_EQ(head("+!g(f(X))"), "none");
  EXPECT_EQ(head("+!g(\"t\")"), "none");
  EXPECT_EQ(head("+!g(X + 1)"), "none");
  EXPECT_EQ(head("+!g(X)[source(Y)]"), "none");
  EXPECT_EQ(head("+!X"), "none");
}

std::size_t plain_arguments(const std::string& formula) {
  const CompiledProgram made("+!g(X, Y) <- " + formula + ".");
  return made.plan().code.entry->steps.front().plain->args.size();
}

TEST(PlainStep, HasArgumentsThatAreConstantsVariablesOrSimpleSums) {
  EXPECT_EQ(plain_arguments("!h(1, a, X, X + 1, X - Y, 2 * X)"), 6U);
  EXPECT_EQ(plain_arguments("+b(X)"), 1U);
  EXPECT_EQ(plain_arguments("!h"), 0U);
}

TEST(PlainStep, HasNoneIfOneArgumentIsAnotherTerm) {
  EXPECT_EQ(plain_arguments("!h(1, f(X))"), 0U);
  EXPECT_EQ(plain_arguments("!h(X / Y)"), 0U);
  EXPECT_EQ(plain_arguments("!h(X + Y + 1)"), 0U);
  EXPECT_EQ(plain_arguments("!h(1)[x]"), 0U);
}

}  // namespace
}  // namespace jaywalk
