// What is decoded of plans and formulas: constants, variables and simple sums.

#include "interpreter/program/event_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;

/// The head of the plan with this trigger: a slot's number or a constant for each argument; "none".
std::string head(const std::string& trigger) {
  const CompiledProgram made(trigger + ".");
  const PlanHead& head = made.plan().head;
  if (!head.is_decoded) return "none";
  std::string all;
  for (const HeadArgument& each : head.args) {
    all +=
        each.slot == Operand::kNoSlot ? made.text(each.constant) : "_" + std::to_string(each.slot);
    all += ' ';
  }
  return all;
}

TEST(PlanHead, HasArgumentsThatAreConstantsAndVariablesThatDiffer) {
  EXPECT_EQ(head("+!g(1, a, X, Y)"), "1 a _0 _1 ");
  EXPECT_EQ(head("+!g"), "");
  EXPECT_EQ(head("+!g(_, _)"), "_0 _1 ");
}

TEST(PlanHead, IsNotDecodedIfItNeedsUnification) {
  EXPECT_EQ(head("+!g(X, X)"), "none");
  EXPECT_EQ(head("+!g([1])"), "none");
  EXPECT_EQ(head("+!g(f(X))"), "none");
  EXPECT_EQ(head("+!g(\"t\")"), "none");
  EXPECT_EQ(head("+!g(X + 1)"), "none");
  EXPECT_EQ(head("+!g(X)[source(Y)]"), "none");
  EXPECT_EQ(head("+!X"), "none");
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
