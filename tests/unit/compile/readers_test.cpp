// SPDX-License-Identifier: Apache-2.0
// Texts that become terms and plans while an agent runs.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/compile/plan_reader.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/print.h"
#include "tests/helpers/run_agents.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using test::Terms;
using testing::ElementsAre;

class PlanReader : public testing::Test {
 protected:
  /// The plan as text, or why it is none.
  std::string read(const std::string& text) {
    std::string problem;
    const Value plan =
        read_plan(text, terms_.heap, terms_.symbols, standard_actions(), texts_, problem);
    EXPECT_EQ(plan.is_unset(), !problem.empty());
    return plan.is_unset() ? problem : term_text(plan, terms_.symbols);
  }
  std::string of_trigger(const std::string& trigger) {
    const Value plan = plan_of_trigger(terms_.term(trigger), terms_.heap, terms_.symbols);
    return plan.is_unset() ? "unset" : term_text(plan, terms_.symbols);
  }

  Terms terms_;
  TextsRead texts_;
};

TEST_F(PlanReader, ReadsAPlanWithOrWithoutItsStop) {
  EXPECT_EQ(read("@l[atomic] +!g(X) : b(X) <- !h(X); .print(X)."),
            "{ @l[atomic] +!g(X) : b(X) <- !h(X); .print(X) }");
  EXPECT_EQ(read("+b"), "{ +b }");
}

TEST_F(PlanReader, SaysWhatIsNoPlan) {
  EXPECT_EQ(read("+!g <- a; )"), "expected the end of the text, found ')'");
  EXPECT_EQ(read(""), "expected a plan, found the end of the text");
}

TEST_F(PlanReader, GivesEachPlanItsOwnVariables) {
  std::string problem;
  const Value a = read_plan("+!g(X) <- a(X).", terms_.heap, terms_.symbols, standard_actions(),
                            texts_, problem);
  const Value b = read_plan("+!g(X) <- a(X).", terms_.heap, terms_.symbols, standard_actions(),
                            texts_, problem);
  const auto variable = [](Value plan) {
    return deref(deref(deref(plan_parts(plan).trigger).structure()->arg(0)).structure()->arg(0));
  };
  ASSERT_TRUE(variable(a).is_variable());
  EXPECT_NE(variable(a).bits(), variable(b).bits());
}

TEST_F(PlanReader, MakesAPlanWithoutABodyOfATrigger) {
  EXPECT_EQ(of_trigger("{+!g(1)}"), "{ +!g(1) }");
  EXPECT_EQ(of_trigger("{-?g}"), "{ -?g }");
  EXPECT_EQ(of_trigger("{+b}"), "{ +b }");
  EXPECT_EQ(of_trigger("{-b(X)}"), "{ -b(X) }");
}

TEST_F(PlanReader, MakesNoPlanOfWhatIsNoTrigger) {
  EXPECT_EQ(of_trigger("b"), "unset");
  EXPECT_EQ(of_trigger("{b}"), "unset");
  EXPECT_EQ(of_trigger("{-+b}"), "unset");
  EXPECT_EQ(of_trigger("{+b; +c}"), "unset");
}

TEST(TermReader, GivesTheCallersVariablesToATextThatNamesThem) {
  EXPECT_THAT(test::printed_by("!g(7). +!g(X) <- .term2string(T, \"f(X, Y, X)\"); "
                               "T = f(A, B, C); .print(A, \" \", C); B = 2; .print(T)."),
              ElementsAre("7 7", "f(7,2,7)"));
}

TEST(TermReader, BindsTheCallersVariableByATextThatNamesIt) {
  EXPECT_THAT(test::printed_by("!g. +!g <- .term2string(T, \"Y\"); T = 3; .print(Y)."),
              ElementsAre("3"));
}

TEST(TermReader, GivesUnnamedVariablesToNobody) {
  EXPECT_THAT(test::printed_by("!g(1). +!g(_) <- .term2string(T, \"f(_)\"); T = f(2); .print(T)."),
              ElementsAre("f(2)"));
}

TEST(TriggerReader, ReadsTriggersFromTexts) {
  EXPECT_THAT(test::printed_by("!g. !h. +!h <- +b(5). +b(_). "
                               "+!g <- .wait(\"+b(X)\"); .print(X)."),
              ElementsAre("5"));
}

}  // namespace
}  // namespace jaywalk
