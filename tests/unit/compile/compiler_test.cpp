// SPDX-License-Identifier: Apache-2.0
// From source trees to programs: beliefs, goals, plans and their labels.

#include "interpreter/compile/compiler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/term/heap.h"
#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Compiler, KeepsBeliefsAndRulesInTheOrderOfTheText) {
  const CompiledProgram made("b(1). a(X) :- b(X). ~b(2).");
  EXPECT_THAT(made.beliefs(), ElementsAre("b(1)[source(self)]", "{ a(_0)[source(self)] :- b(_0) }",
                                          "~b(2)[source(self)]"));
}

TEST(Compiler, NamesTheSourceOfABeliefThatHasNone) {
  EXPECT_THAT(CompiledProgram("b[x]. c[source(bob)].").beliefs(),
              ElementsAre("b[source(self),x]", "c[source(bob)]"));
}

TEST(Compiler, EvaluatesTheArithmeticOfFacts) {
  EXPECT_THAT(CompiledProgram("b(1 + 2 * 3, f(4 mod 3)).").beliefs(),
              ElementsAre("b(7,f(1))[source(self)]"));
}

TEST(Compiler, RefusesToDivideByZeroInAFact) {
  const CompiledProgram made("b(1).\nc(1 div 0).\nd(f(2 div 0)).");
  EXPECT_EQ(made.program, nullptr);
  EXPECT_EQ(made.errors(),
            "2:1: division by zero in a belief\n3:1: division by zero in a belief\n");
}

TEST(Compiler, LeavesTheArithmeticOfRulesToEachQuery) {
  EXPECT_THAT(CompiledProgram("a(X + 1) :- b(X).").beliefs(),
              ElementsAre("{ a((_0+1))[source(self)] :- b(_0) }"));
}

TEST(Compiler, MakesARuleOfAFactWithVariables) {
  const CompiledProgram made("any(X, X, _).");
  ASSERT_EQ(made.program->beliefs().size(), 1U);
  const Program::Belief& belief = made.program->beliefs().front();
  ASSERT_NE(belief.rule, nullptr);
  EXPECT_TRUE(belief.fact.is_unset());
  EXPECT_EQ(belief.rule->slot_count, 2U);
}

TEST(Compiler, RefusesInitialGoalsThatAreVariables) {
  EXPECT_EQ(CompiledProgram("!Start.").errors(),
            "1:2: an initial goal must be a literal [names begin with a lower-case letter]\n");
}

TEST(Compiler, NamesTheSourceOfInitialGoalsAndCountsTheirVariables) {
  const CompiledProgram made("!go(X, Y, X). !stay[source(bob)].");
  const auto& goals = made.program->goals();
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(made.text(goals[0].literal), "go(_0,_1,_0)[source(self)]");
  EXPECT_EQ(goals[0].slot_count, 2U);
  EXPECT_EQ(made.text(goals[1].literal), "stay[source(bob)]");
  EXPECT_EQ(goals[1].slot_count, 0U);
}

TEST(Compiler, RefusesClausesOfMoreVariablesThanHaveNumbers) {
  std::string wide = "b(_";
  for (int i = 1; i < 40'000; ++i) wide += ",_";
  wide += ")";
  const std::string too_many =
      ": more than 65535 variables [split it into several rules or plans]\n";
  EXPECT_EQ(CompiledProgram("a :- " + wide + ".").errors(), "");
  EXPECT_EQ(CompiledProgram("a :- " + wide + " & " + wide + ".").errors(), "1:1" + too_many);
  EXPECT_EQ(CompiledProgram("ok.\n+!a : " + wide + " <- -" + wide + ".").errors(),
            "2:1" + too_many);
}

TEST(Compiler, GivesPlansWithoutALabelOneOfTheirOwn) {
  const CompiledProgram made("+!a. @mine +!b. @[atomic] +!c.");
  std::vector<std::string> labels;
  for (const auto& plan : made.plans()) labels.push_back(made.text(plan->label));
  EXPECT_THAT(labels, ElementsAre("p__1[source(self),url(\"file:agent.asl\")]",
                                  "mine[source(self),url(\"file:agent.asl\")]",
                                  "p__2[atomic,source(self),url(\"file:agent.asl\")]"));
}

TEST(Compiler, GivesLabelsThatTheTableDoesNotHaveWhereTheyMustBeNew) {
  const std::string text = "+!a(p__1).";
  const CompiledProgram usual(text);
  EXPECT_THAT(usual.text(usual.plan().label), HasSubstr("p__1["));
  const CompiledProgram fresh(text, {.fresh_names = true});
  EXPECT_THAT(fresh.text(fresh.plan().label), HasSubstr("p__2["));
}

TEST(Compiler, RefusesASecondPlanOfTheSameLabel) {
  const CompiledProgram made("@l +!a <- .print(1).\n@l +!a <- .print(2).");
  EXPECT_EQ(made.errors(),
            "2:2: another plan has the label 'l' already [give each plan a label of its own, or "
            "none]\n");
}

TEST(Compiler, TakesAnEqualPlanOfTheSameLabelOnce) {
  const CompiledProgram made("@l +!a(X) <- .print(X).\n@l +!a(X) <- .print(X).");
  EXPECT_EQ(made.errors(), "");
  EXPECT_EQ(made.plan().line, 1U);
}

TEST(Compiler, LetsLabelsOfSubplansBeThoseOfOtherPlans) {
  const CompiledProgram made("@l +!a. { @l +!b. @m +!c. } @m +!d. { @l +!e. }");
  EXPECT_EQ(made.errors(), "");
  ASSERT_EQ(made.plans().size(), 2U);
  EXPECT_EQ(made.plans()[0]->subplans->plans().size(), 2U);
  EXPECT_EQ(made.plans()[1]->subplans->plans().size(), 1U);
  EXPECT_THAT(CompiledProgram("+!a. { @l +!b. @l +!c. }").errors(),
              HasSubstr("another plan has the label 'l' already"));
}

TEST(Compiler, ReadsWhatThePlansOfALabelAreLike) {
  const CompiledProgram made("@a[atomic] +!g. @b[all_unifs] +!g. @c[learned(crossing)] +!g.");
  const auto plans = made.plans();
  ASSERT_EQ(plans.size(), 3U);
  EXPECT_TRUE(plans[0]->atomic);
  EXPECT_FALSE(plans[0]->all_unifs);
  EXPECT_TRUE(plans[1]->all_unifs);
  EXPECT_FALSE(plans[1]->atomic);
  EXPECT_TRUE(plans[0]->policy.is_unset());
  EXPECT_EQ(made.text(plans[2]->policy), "crossing");
}

TEST(Compiler, TakesALabelWithArgumentsForItsAnnotationsAlone) {
  const CompiledProgram made("@l(1)[atomic] +!g.");
  EXPECT_TRUE(made.plan().atomic);
  EXPECT_THAT(made.text(made.plan().label), HasSubstr("p__1["));
}

TEST(Compiler, GivesSubplansTheVariablesOfThePlansAroundThem) {
  const CompiledProgram made("+!a(X, _) : b(Y). { +!c(Y, Z). { +!d(Z, X). } }");
  const Plan& inner = *made.plan().subplans->plans().front();
  // Its own Y and Z; then X of the plan around it. An unnamed variable belongs to neither.
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  EXPECT_EQ(inner.slot_count, 3U);
  EXPECT_THAT(inner.inherited, ElementsAre(Pair{2, 0}, Pair{0, 2}));
  const Plan& innermost = *inner.subplans->plans().front();
  EXPECT_EQ(innermost.slot_count, 3U);
  EXPECT_THAT(innermost.inherited, ElementsAre(Pair{2, 0}, Pair{0, 1}, Pair{1, 2}));
}

TEST(Compiler, KeepsWhereAPlanStands) {
  const CompiledProgram made("\n\n  +!g\n <- a.");
  EXPECT_EQ(made.plan().file, "agent.asl");
  EXPECT_EQ(made.plan().line, 3U);
  const StepPlace place = made.plan().code.entry->steps.front().place;
  EXPECT_EQ(place.line, 4U);
  EXPECT_EQ(place.column, 5U);
  EXPECT_EQ(place.length, 1U);
}

TEST(Compiler, CompilesNothingThatIsWronglyWritten) {
  const CompiledProgram made("b(1. +!g <- a.");
  EXPECT_EQ(made.program, nullptr);
  EXPECT_EQ(made.diagnostics.error_count(), 1U);
}

TEST(Compiler, NamesAProgramByItsFileWithoutTheEnding) {
  EXPECT_EQ(CompiledProgram("b.").program->name(), "agent");
}

TEST(Compiler, PutsTheProgramInTheNamespaceThatItIsGiven) {
  EXPECT_THAT(CompiledProgram("b(c). default::d.", {.ns = "n"}).beliefs(),
              ElementsAre("n::b(c)[source(self)]", "d[source(self)]"));
}

TEST(Compiler, MayUseOtherInternalActions) {
  const ActionRegistry none;
  const CompiledProgram made("+!g : .print(1) <- .print(2).", {.actions = &none});
  EXPECT_EQ(&made.program->actions(), &none);
  EXPECT_EQ(made.plan().context->action, nullptr);
  const CompiledProgram usual("+!g : .print(1) <- .print(2).");
  EXPECT_NE(usual.plan().context->action, nullptr);
}

TEST(Compiler, FindsTheTextsOfItsFiles) {
  const CompiledProgram made("{include(\"other.asl\")} b.", {}, {{"other.asl", "c."}});
  ASSERT_NE(made.program->find_source("agent.asl"), nullptr);
  EXPECT_EQ(made.program->find_source("agent.asl")->text(), "{include(\"other.asl\")} b.");
  EXPECT_EQ(made.program->find_source("kqmlPlans.asl"), nullptr);
}

TEST(ParameterNames, AreThoseOfFactsWithArguments) {
  const CompiledProgram made(
      "speed(3). limit(1). rule(X) :- speed(X). flag. ~speed(2). n::other(1). speed(4). pair(1, "
      "2).");
  EXPECT_THAT(parameter_names(*made.program, made.symbols),
              ElementsAre("speed/1", "limit/1", "~speed/1", "pair/2"));
}

TEST(ParameterNames, AreNoneOfAProgramWithoutFacts) {
  const CompiledProgram made("+!g.");
  EXPECT_THAT(parameter_names(*made.program, made.symbols), IsEmpty());
}

}  // namespace
}  // namespace jaywalk
