// SPDX-License-Identifier: Apache-2.0
#include "interpreter/explain/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/coverage/observed.h"

namespace jaywalk {
namespace {

using test::Observed;
using testing::HasSubstr;

std::vector<Deliberation> explained(const std::string& program) {
  Observed observed(program, Probes::Detail::bindings);
  ExplainingObserver observer(*observed.probes, observed.texts, {});
  observed.run(observer);
  return observer.deliberations();
}

/// The deliberation about an event that begins like this.
Deliberation about(const std::vector<Deliberation>& all, const std::string& event) {
  for (const Deliberation& each : all) {
    if (each.event.starts_with(event)) return each;
  }
  ADD_FAILURE() << "no deliberation about " << event;
  return {};
}

TEST(AnExplanation, NamesTheConditionThatFailedWithItsBindings) {
  const auto all = explained(
      "distance(20). radius(15).\n"
      "near(D) :- distance(D) & radius(R) & D < R.\n"
      "!step.\n"
      "+!step : near(D) <- .print(cross).\n"
      "+!step <- .print(walk).\n");
  const Deliberation step = about(all, "+!step");
  ASSERT_EQ(step.plans.size(), 2U);
  const TriedPlan& first = step.plans[0];
  EXPECT_EQ(first.state, TriedPlan::State::not_applicable);
  ASSERT_LT(first.failed, first.asked.size());
  EXPECT_EQ(first.asked[first.failed].text, "near(D)");
  // The reason is in the rule.
  const AskedCondition& last = first.asked.back();
  EXPECT_EQ(last.rule, "near(D)");
  EXPECT_EQ(last.text, "D < R");
  EXPECT_FALSE(last.held);
  EXPECT_THAT(last.bindings,
              testing::ElementsAre(testing::Pair("D", "20"), testing::Pair("R", "15")));
  EXPECT_EQ(step.chosen(), &step.plans[1]);
}

TEST(AnExplanation, SeesThatANegationFailsBecauseItsFormulaHolds) {
  const auto all = explained(
      "busy.\n"
      "!go.\n"
      "+!go : not busy <- .print(a).\n"
      "-!go <- .print(b).\n");
  const Deliberation go = about(all, "+!go");
  const TriedPlan& plan = go.plans[0];
  ASSERT_EQ(plan.failed, 0U);
  EXPECT_EQ(plan.asked[0].text, "not busy");
  EXPECT_FALSE(plan.asked[0].held);
  EXPECT_EQ(go.chosen(), nullptr);
  EXPECT_THAT(explanation_text({&go, 1}), HasSubstr("no  not busy   <- here it fails"));
}

TEST(AnExplanation, SaysWhetherANegatedConditionHeldAsWritten) {
  const auto all = explained(
      "busy.\n"
      "!go.\n"
      "calm(X) :- not loud(X) & not (not busy).\n"
      "+!go : not way(_) & not (not busy) & not (busy & late) & calm(1) <- .print(a).\n");
  const Deliberation go = about(all, "+!go");
  ASSERT_NE(go.chosen(), nullptr);
  for (const AskedCondition& asked : go.chosen()->asked) {
    EXPECT_EQ(asked.held, asked.text != "late") << asked.text;
    EXPECT_EQ(asked.negated, asked.text == "late" || asked.text == "busy") << asked.text;
  }
  const std::string text = explanation_text({&go, 1});
  EXPECT_THAT(text, HasSubstr("     yes not way(_)\n"
                              "     yes not not busy\n"
                              "     yes within not (...): busy\n"
                              "     no  within not (...): late\n"
                              "     yes calm(1)\n"));
  EXPECT_THAT(text, HasSubstr("yes not loud(X)  with X = 1\n"));
}

TEST(AnExplanation, TellsPlansThatDoNotMatchAndThoseThatWereNotAsked) {
  const auto all = explained(
      "!go(1).\n"
      "+!go(2) <- .print(a).\n"
      "+!go(1) <- .print(b).\n"
      "+!go(X) <- .print(c).\n");
  const Deliberation go = about(all, "+!go(1)");
  ASSERT_EQ(go.plans.size(), 3U);
  EXPECT_EQ(go.plans[0].state, TriedPlan::State::not_matching);
  EXPECT_EQ(go.plans[1].state, TriedPlan::State::chosen);
  EXPECT_EQ(go.plans[2].state, TriedPlan::State::not_tried);
}

TEST(AnExplanation, TellsWhereBeliefsCameFrom) {
  const auto all = explained(
      "known(1).\n"
      "!go.\n"
      "+!go <- +made(2); !look.\n"
      "+!look : known(A) & made(B) <- .print(A, B).\n");
  const Deliberation look = about(all, "+!look");
  ASSERT_EQ(look.beliefs.size(), 2U);
  EXPECT_EQ(look.beliefs[0].literal, "known(1)[source(self)]");
  EXPECT_EQ(look.beliefs[0].origin, "initial");
  EXPECT_EQ(look.beliefs[1].origin, "its own, agent.asl:3, in tick 0");
}

TEST(AnExplanation, HintsAtBeliefsThatAreAlmostTheOneAskedFor) {
  const auto hint = [](const std::string& beliefs, const std::string& condition) {
    const auto all = explained(beliefs + "\n!go.\n+!go : " + condition + " <- .print(a).\n");
    return about(all, "+!go").plans.at(0).asked.at(0).hint;
  };
  EXPECT_EQ(hint("position(1,2).", "position(X)"),
            "nothing is believed about position/1, but about position/2");
  EXPECT_EQ(hint("distance(3).", "distence(D)"),
            "nothing is believed about distence/1; did you mean 'distance'?");
  EXPECT_EQ(hint("~safe.", "safe"),
            "nothing is believed about safe/0, but about ~safe/0 (strong negation is a belief of "
            "its own)");
  EXPECT_EQ(hint("colour(red). colour(blue).", "colour(green)"),
            "believed is colour(red)[source(self)], colour(blue)[source(self)]");
}

TEST(AnExplanation, HintsAtPlansThatAreAlmostForTheEvent) {
  const auto hint = [](const std::string& goal, const std::string& plan) {
    return about(explained("!" + goal + ".\n" + plan + " <- .print(a).\n"), "+!").hint;
  };
  EXPECT_EQ(hint("cross(left)", "+!cross"),
            "there is a plan for +!cross/0 (agent.asl:2), with 0 arguments");
  EXPECT_EQ(hint("walk", "+!wolk"), "did you mean '+!wolk'?");
  EXPECT_EQ(hint("stop", "+stop"),
            "there is a plan for +stop/0 (agent.asl:2), which is another kind of event");
}

TEST(AnExplanation, ReadsAsText) {
  const auto all = explained(
      "distance(20).\n"
      "!step.\n"
      "+!step : distance(D) & D < 15 <- .print(cross).\n"
      "+!step <- .print(walk).\n");
  EXPECT_EQ(explanation_text(all),
            "tick 0, agent: +!step[source(self)]\n"
            "  1. +!step  (agent.asl:3)\n"
            "     relevant, not applicable\n"
            "     yes distance(D)\n"
            "     no  D < 15  with D = 20   <- here it fails\n"
            "  2. +!step  (agent.asl:4)\n"
            "     chosen\n"
            "  chosen: +!step (agent.asl:4), the first that is applicable\n"
            "  beliefs that were asked for:\n"
            "     distance(20)[source(self)]  initial\n");
}

}  // namespace
}  // namespace jaywalk
