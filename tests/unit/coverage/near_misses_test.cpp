// SPDX-License-Identifier: Apache-2.0
// Hints of explanations: which near miss is named where there are several, and where there is
// nothing to hint at.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/explain/explanation.h"
#include "tests/unit/coverage/observed.h"

namespace jaywalk {
namespace {

using test::Observed;
using testing::HasSubstr;
using testing::Not;

std::vector<Deliberation> deliberated(const std::string& program,
                                      ExplainingObserver::Wanted wanted = {}) {
  Observed observed(program, Probes::Detail::bindings);
  ExplainingObserver observer(*observed.probes, observed.texts, std::move(wanted));
  observed.run(observer);
  return observer.deliberations();
}

/// The hint of the only condition of a plan for `!go`, behind these beliefs.
std::string belief_hint(const std::string& beliefs, const std::string& condition) {
  for (const Deliberation& each :
       deliberated(beliefs + "\n!go.\n+!go : " + condition + " <- .print(a).\n")) {
    if (each.event.starts_with("+!go")) return each.plans.at(0).asked.at(0).hint;
  }
  return "nothing was deliberated";
}

/// The hint of the event of a goal that has no plan among these.
std::string plan_hint(const std::string& goal, const std::string& plans) {
  for (const Deliberation& each : deliberated("!" + goal + ".\n" + plans)) {
    if (each.event.starts_with("+!")) return each.hint;
  }
  return "nothing was deliberated";
}

TEST(BeliefHints, AreNoneOfAConditionThatHeld) {
  EXPECT_EQ(belief_hint("colour(red).", "colour(red)"), "");
  EXPECT_EQ(belief_hint("colour(red).", "not colour(blue)"), "");
}

TEST(BeliefHints, SayThatNothingIsAlike) {
  EXPECT_EQ(belief_hint("colour(red).", "weight(W)"), "nothing is believed about weight/1");
}

TEST(BeliefHints, ShowThreeFactsAndCountTheOthers) {
  const std::string hint = belief_hint("at(1). at(2). at(3). at(4). at(5).", "at(9)");
  EXPECT_THAT(hint, HasSubstr("believed is at(1)[source(self)], at(2)"));
  EXPECT_THAT(hint, HasSubstr(" and 2 more"));
  EXPECT_THAT(hint, Not(HasSubstr("at(4)")));
  EXPECT_THAT(belief_hint("at(1). at(2). at(3).", "at(9)"), Not(HasSubstr("more")));
}

TEST(BeliefHints, AreNoneWhereOnlyARuleHasNoAnswer) {
  EXPECT_EQ(belief_hint("near(X) :- at(X) & X < 3. at(7).", "near(7)"), "");
}

TEST(BeliefHints, PreferTheSameNameToASimilarOne) {
  EXPECT_EQ(belief_hint("speeds(1). speed(1,2).", "speed(V)"),
            "nothing is believed about speed/1, but about speed/2");
}

TEST(BeliefHints, LookForSimilarNamesOfAsManyArgumentsOnly) {
  EXPECT_EQ(belief_hint("distance(3,4).", "distence(D)"), "nothing is believed about distence/1");
}

TEST(BeliefHints, ForgetWhatIsNoLongerBelieved) {
  const auto all = deliberated(
      "position(1,2).\n!go.\n"
      "+!go <- -position(1,2); !look.\n"
      "+!look : position(X) <- .print(X).\n");
  for (const Deliberation& each : all) {
    if (!each.event.starts_with("+!look")) continue;
    EXPECT_EQ(each.plans.at(0).asked.at(0).hint, "nothing is believed about position/1");
    return;
  }
  FAIL() << "nobody looked";
}

TEST(PlanHints, AreNoneWhereNoPlanIsAlike) {
  EXPECT_EQ(plan_hint("cross", "+!entirely_else <- .print(a).\n"), "");
}

TEST(PlanHints, AreNoneWhereAPlanWasChosen) {
  EXPECT_EQ(plan_hint("cross", "+!cross <- .print(a).\n+!crosss <- .print(b).\n"), "");
}

TEST(PlanHints, CountTheArgumentsOfThePlan) {
  EXPECT_EQ(plan_hint("cross", "+!cross(W) <- .print(W).\n"),
            "there is a plan for +!cross/1 (agent.asl:2), with 1 argument");
  EXPECT_EQ(plan_hint("cross", "+!cross(W,H) <- .print(W).\n"),
            "there is a plan for +!cross/2 (agent.asl:2), with 2 arguments");
}

TEST(PlanHints, PreferTheSameNameToASimilarOne) {
  EXPECT_THAT(plan_hint("cross(a)", "+!crosss(W) <- .print(W).\n+!cross <- .print(b).\n"),
              HasSubstr("there is a plan for +!cross/0 (agent.asl:3)"));
}

TEST(PlanHints, KnowThatATestGoalIsAnotherKindOfEvent) {
  EXPECT_EQ(plan_hint("cross", "+?cross <- .print(a).\n"),
            "there is a plan for +?cross/0 (agent.asl:2), which is another kind of event");
}

TEST(PlanHints, DoNotTakeAFailurePlanForAPlanOfTheGoal) {
  EXPECT_EQ(plan_hint("cross", "-!cross <- .print(a).\n"), "");
  EXPECT_EQ(plan_hint("cross", "-!cross(W) <- .print(W).\n"), "");
}

TEST(Explanations, AreOfTheAgentAndTheTickThatAreWanted) {
  const std::string program = "!go.\n+!go <- .print(a).\n";
  EXPECT_FALSE(deliberated(program).empty());
  EXPECT_FALSE(deliberated(program, {.agent = "agent"}).empty());
  EXPECT_TRUE(deliberated(program, {.agent = "other"}).empty());
  EXPECT_FALSE(deliberated(program, {.tick = 0}).empty()) << "before the first tick";
  EXPECT_TRUE(deliberated(program, {.tick = 1}).empty());
}

}  // namespace
}  // namespace jaywalk
