// SPDX-License-Identifier: Apache-2.0
// Plans as terms to code: which kind of step each formula is, and what is prepared for it.

#include "interpreter/program/plan_compiler.h"

#include <array>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/programs.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;
using test::Terms;
using testing::ElementsAre;

std::vector<Step::Kind> kinds(const Body& body) {
  std::vector<Step::Kind> found;
  for (const Step& step : body.steps) found.push_back(step.kind);
  return found;
}

TEST(PlanCompiler, KnowsAStepByItsOperator) {
  using enum Step::Kind;
  const CompiledProgram made(
      "+!g <- a(1); .print(a); 1 < 2; !g; !!g; ?q; +b; ++b; +<b; +>b; -b; --b; -+b.");
  EXPECT_THAT(
      kinds(*made.plan().code.entry),
      ElementsAre(action, internal_action, constraint, achieve, achieve_new_focus, test, add,
                  add_new_focus, add_begin, add_end, remove, remove_new_focus, replace));
}

TEST(PlanCompiler, LeavesTheKindOfAVariableToItsValueAndKeepsItsOperator) {
  const CompiledProgram made("+!g(X, N) <- X; !X; ?X; +X; N::a; !N::a.");
  std::vector<Step::Kind> operators;
  for (const Step& step : made.plan().code.entry->steps) {
    EXPECT_EQ(step.kind, Step::Kind::variable);
    EXPECT_EQ(step.goal != nullptr, step.variable_kind == Step::Kind::test);
    operators.push_back(step.variable_kind);
  }
  using enum Step::Kind;
  EXPECT_THAT(operators, ElementsAre(action, achieve, test, add, action, achieve));
}

TEST(PlanCompiler, RunsNothingForAnExpression) {
  Terms terms;
  BodyCode code;
  BodyCompiler compiler(code, standard_actions(), terms.symbols);
  EXPECT_THAT(kinds(*compiler.compile(terms.term("1 + 2"))), ElementsAre(Step::Kind::wrong));
  EXPECT_THAT(kinds(*compiler.compile(terms.term("[1]"))), ElementsAre(Step::Kind::wrong));
  EXPECT_THAT(kinds(*compiler.compile(terms.term("a & b"))), ElementsAre(Step::Kind::action));
}

TEST(PlanCompiler, MakesStatementsOfTheirParts) {
  const CompiledProgram made(
      "+!g <- if (a & b) { c } else { d; e }; if (a) { b }; while (a) { b }; for (a & b & (c | d)) "
      "{ e }.");
  const std::vector<Step>& steps = made.plan().code.entry->steps;
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[0].kind, Step::Kind::if_statement);
  EXPECT_EQ(steps[0].first->steps.size(), 1U);
  EXPECT_EQ(steps[0].second->steps.size(), 2U);
  EXPECT_EQ(steps[1].second, nullptr);
  EXPECT_EQ(steps[2].kind, Step::Kind::while_loop);
  EXPECT_NE(steps[2].goal, nullptr);
  EXPECT_EQ(steps[3].kind, Step::Kind::for_loop);
  EXPECT_EQ(steps[3].conjuncts.size(), 3U);
  EXPECT_EQ(steps[3].conjuncts[2]->kind, Goal::Kind::disjunction);
}

TEST(PlanCompiler, EndsEachBranchByJoiningTheOthers) {
  const CompiledProgram made("+!g <- a |&| (b; c). ");
  const Step& fork = made.plan().code.entry->steps.front();
  EXPECT_EQ(fork.kind, Step::Kind::fork_and);
  ASSERT_EQ(fork.branches.size(), 2U);
  using enum Step::Kind;
  EXPECT_THAT(kinds(*fork.branches[0]), ElementsAre(action, join));
  EXPECT_THAT(kinds(*fork.branches[1]), ElementsAre(action, action, join));
  EXPECT_EQ(fork.branches[0]->steps.back().variable_kind, fork_and);
  EXPECT_EQ(CompiledProgram("+!g <- a ||| b.").plan().code.entry->steps.front().kind, fork_or);
}

TEST(PlanCompiler, TakesActionsWithTheNamesOfStatementsForActions) {
  using enum Step::Kind;
  EXPECT_THAT(kinds(*CompiledProgram("+!g <- .loop(a); .foreach(a); .if_then_else(a); .fork(or).")
                         .plan()
                         .code.entry),
              ElementsAre(internal_action, internal_action, internal_action, internal_action));
}

TEST(PlanCompiler, PutsABodyWithinABodyInItsPlace) {
  Terms terms;
  BodyCode code;
  BodyCompiler compiler(code, standard_actions(), terms.symbols);
  ASSERT_TRUE(terms.unify("X", "{ b; c }"));
  const Body* const body = compiler.compile(terms.term("{ a; X; d }"));
  using enum Step::Kind;
  EXPECT_THAT(kinds(*body), ElementsAre(action, action, action, action));
  EXPECT_EQ(terms.text(body->steps[2].term), "c");
}

TEST(PlanCompiler, PreparesTheEventsThatStepsMake) {
  const CompiledProgram made("+!g(X) <- !h(X); +b(1); -c; -+d(X + 1); ?e; !!f. +!h(_). +b(_).");
  const std::vector<Step>& steps = made.plans().front()->code.entry->steps;
  const auto event = [&](std::size_t at) { return *steps[at].event->event; };
  EXPECT_EQ(event(0),
            (TriggerKey{TriggerOperator::add, TriggerKind::achieve, predicate_of(steps[0].term)}));
  EXPECT_EQ(event(1),
            (TriggerKey{TriggerOperator::add, TriggerKind::belief, predicate_of(steps[1].term)}));
  EXPECT_EQ(event(2).op, TriggerOperator::remove);
  EXPECT_EQ(event(3).op, TriggerOperator::add);
  EXPECT_EQ(steps[4].event, nullptr);
  EXPECT_EQ(steps[5].event, nullptr);
  // The plans for them are those of the program.
  EXPECT_EQ(steps[0].event->plans->plans().size(), 1U);
  EXPECT_EQ(steps[0].event->plans->plans().front(), made.plans()[1].get());
  EXPECT_TRUE(steps[2].event->plans->plans().empty());
}

TEST(PlanCompiler, KnowsAPlanByItsTrigger) {
  using enum TriggerOperator;
  const std::map<std::string, std::pair<TriggerOperator, TriggerKind>> triggers{
      {"+b(1)", {add, TriggerKind::belief}},          {"-b(1)", {remove, TriggerKind::belief}},
      {"+!b(1)", {add, TriggerKind::achieve}},        {"-!b(1)", {remove, TriggerKind::achieve}},
      {"+?b(1)", {add, TriggerKind::test}},           {"-?b(1)", {remove, TriggerKind::test}},
      {"^!b(1)", {goal_state, TriggerKind::achieve}}, {"^?b(1)", {goal_state, TriggerKind::test}}};
  for (const auto& [text, expected] : triggers) {
    const CompiledProgram made(text + ".");
    EXPECT_EQ(made.plan().key.op, expected.first) << text;
    EXPECT_EQ(made.plan().key.kind, expected.second) << text;
    EXPECT_EQ(made.text(made.plan().trigger), "b(1)");
    EXPECT_EQ(trigger_operator(expected.first, expected.second), text.substr(0, text.find('b')));
  }
}

TEST(PlanCompiler, FindsPlansForStrongNegationWithThoseWithout) {
  const CompiledProgram made("+~b. +b.");
  EXPECT_EQ(made.plans()[0]->key, made.plans()[1]->key);
}

TEST(PlanCompiler, RemembersTheFirstArgumentOfATriggerThatIsAConstant) {
  const CompiledProgram made("+!g(1, X). +!g(a). +!g(\"t\"). +!g(X). +!g. +!g([1]).");
  std::vector<std::string> first;
  for (const auto& plan : made.plans()) {
    first.push_back(plan->first_argument.is_unset() ? "-" : made.text(plan->first_argument));
  }
  EXPECT_THAT(first, ElementsAre("1", "a", "-", "-", "-", "-"));
  EXPECT_EQ(made.plans()[3]->first_key, 0U);
  EXPECT_NE(made.plans()[0]->first_key, made.plans()[1]->first_key);
}

TEST(PlanCompiler, KnowsThePlansThatAreForAnyPredicate) {
  const CompiledProgram made("+X. +!g.");
  EXPECT_TRUE(made.plans()[0]->any_predicate);
  EXPECT_FALSE(made.plans()[1]->any_predicate);
}

TEST(PlanCompiler, CompilesContextsAndConditionsOfGoals) {
  const CompiledProgram made("+!g : b & c <: d <- a.\n+!h : true <- a.");
  EXPECT_NE(made.plans()[0]->context, nullptr);
  EXPECT_TRUE(made.plans()[0]->has_goal_condition);
  EXPECT_NE(made.plans()[0]->goal_condition, nullptr);
  EXPECT_EQ(made.plans()[1]->context, nullptr) << "`true` asks for nothing";
  EXPECT_FALSE(made.plans()[1]->has_goal_condition);
}

class TriggerPartsOf : public testing::Test {
 protected:
  /// The operator and the literal; "none" of what is no trigger.
  std::string parts(const std::string& term) {
    TriggerParts found;
    if (!trigger_parts(terms_.term(term), terms_.symbols, found)) return "none";
    return trigger_operator(found.op, found.kind) + " " + terms_.text(found.literal);
  }
  Terms terms_;
};

TEST_F(TriggerPartsOf, TriggersAreTheirOwn) {
  EXPECT_EQ(parts("{+!g(1)}"), "+! g(1)");
  EXPECT_EQ(parts("{-?g}"), "-? g");
  EXPECT_EQ(parts("{^!g}"), "^! g");
}

TEST_F(TriggerPartsOf, ABodyOfOneChangeOfBeliefAreThoseOfItsEvent) {
  EXPECT_EQ(parts("{+b(1)}"), "+ b(1)");
  EXPECT_EQ(parts("{-b}"), "- b");
}

TEST_F(TriggerPartsOf, OtherTermsAreNone) {
  for (const char* term :
       {"b", "1", "X", "{+b; +c}", "{b}", "{?b}", "{!b}", "{-+b}", "{++b}", "{+<b}", "{}"}) {
    EXPECT_EQ(parts(term), "none") << term;
  }
}

TEST(EqualPlans, DifferInTriggerContextOrBodyAndNotInTheirLabels) {
  const CompiledProgram made(
      "@a +!g(X) : b <- c(X). @z +!g(Y) : b <- c(Y). +!h(X) : b <- c(X). +!g(X) <- c(X).\n"
      "+!g(X) : b <- d(X). +!g(X) : d <- c(X).");
  const auto plans = made.plans();
  EXPECT_TRUE(equal_plans(*plans[0], *plans[1])) << "names of variables do not count";
  for (std::size_t i = 2; i < plans.size(); ++i) {
    EXPECT_FALSE(equal_plans(*plans[0], *plans[i])) << i;
    EXPECT_TRUE(equal_plans(*plans[i], *plans[i])) << i;
  }
}

TEST(CompilePlan, GivesNothingForATermWithoutATrigger) {
  Terms terms;
  const Value body = terms.term("{ a; b }");
  const std::array<Value, 6> parts{Value(), terms.term("b"), Value(), body, Value(), Value()};
  const Value plan = terms.heap.structure(
      terms.symbols.predicate(Signature{.functor = names::plan_text, .arity = 6}), parts,
      Value::empty_list(), Form::plan);
  EXPECT_EQ(compile_plan(plan, {}, standard_actions(), terms.symbols), nullptr);
}

}  // namespace
}  // namespace jaywalk
