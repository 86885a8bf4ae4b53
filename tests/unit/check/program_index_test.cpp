// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/index/program_index.h"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/check/index/uses.h"

namespace jaywalk {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

SourceTree loaded(const std::string& text) {
  Diagnostics diagnostics;
  SourceTree program = load_agent(std::make_shared<const Source>("test", text), {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  return program;
}

ProgramIndex index(const std::string& text) { return index_of(loaded(text)); }

TEST(NameSet, KnowsNamesByTheirNumberOfArguments) {
  NameSet names;
  names.add("p", 1);
  names.add("p", 3);
  EXPECT_TRUE(names.contains("p", 1));
  EXPECT_FALSE(names.contains("p", 2));
  EXPECT_FALSE(names.contains("q", 1));
  EXPECT_THAT(names.arities("p"), ElementsAre(1, 3));
  EXPECT_TRUE(names.arities("q").empty());
  EXPECT_THAT(names.names(), ElementsAre("p"));
}

TEST(NameSet, MayTakeAnyNumberOfArguments) {
  NameSet names;
  names.add_any_arity("f");
  EXPECT_TRUE(names.contains("f", 0));
  EXPECT_TRUE(names.contains("f", 7));
}

TEST(ProgramIndex, DistinguishesFactsAndRules) {
  const ProgramIndex of = index("b(1).\nr(X) :- b(X).\n");
  EXPECT_TRUE(of.beliefs.contains("b", 1));
  EXPECT_TRUE(of.facts.contains("b", 1));
  EXPECT_TRUE(of.beliefs.contains("r", 1));
  EXPECT_FALSE(of.facts.contains("r", 1));
  EXPECT_TRUE(of.given.contains("r", 1));
}

TEST(ProgramIndex, DoesNotTakeAReactionForAGift) {
  const ProgramIndex of = index("+seen(X) <- +known(X); -+last(X); -gone(X); ?asked(X).\n");
  EXPECT_TRUE(of.beliefs.contains("seen", 1));
  EXPECT_FALSE(of.given.contains("seen", 1));
  EXPECT_TRUE(of.given.contains("known", 1));
  EXPECT_TRUE(of.given.contains("last", 1));
  EXPECT_FALSE(of.beliefs.contains("gone", 1)) << "it is only removed";
  EXPECT_FALSE(of.beliefs.contains("asked", 1));
}

TEST(ProgramIndex, KnowsWhichGoalsHavePlans) {
  const ProgramIndex of = index("+!g <- true.\n-!f <- true.\n+?t <- true.\n^!s[state(resumed)].\n");
  EXPECT_TRUE(of.achievable_goals.contains("g", 0));
  EXPECT_TRUE(of.planned_goals.contains("f", 0)) << "what to do when it fails";
  EXPECT_FALSE(of.achievable_goals.contains("f", 0));
  EXPECT_TRUE(of.planned_tests.contains("t", 0));
  EXPECT_FALSE(of.planned_goals.contains("s", 0));
}

TEST(ProgramIndex, HasThePlansOfMessages) {
  EXPECT_TRUE(index("b.\n").achievable_goals.contains("kqml_received", 4));
}

TEST(ProgramIndex, KnowsWhatIsPostedAnywhere) {
  const ProgramIndex of =
      index("!a.\n+!a <- !b(1); !!c; .send(x, achieve, d); .add_plan({ +!e <- !f }).\n");
  for (const char* goal : {"a", "c", "d", "f"}) EXPECT_TRUE(of.posted_goals.contains(goal, 0));
  EXPECT_TRUE(of.posted_goals.contains("b", 1));
  EXPECT_TRUE(of.achievable_goals.contains("e", 0));
}

TEST(ProgramIndex, SaysThatMessagesAreSent) {
  EXPECT_TRUE(index("+!g <- .broadcast(tell, b(1)).\n").sends_messages);
  EXPECT_FALSE(index("+!g <- .print(b).\n").sends_messages);
  EXPECT_TRUE(index("+!g <- .broadcast(tell, b(1)).\n").beliefs.contains("b", 1))
      << "what it tells its equals it may be told";
}

TEST(ProgramIndex, IsOpenWhereNamesAreNotWritten) {
  EXPECT_TRUE(index("+!G <- true.\n").has_open_goals);
  EXPECT_TRUE(index("+!g(B) <- +B.\n").has_open_beliefs);
  EXPECT_FALSE(index("+!g(B) <- -B.\n").has_open_beliefs) << "removed, not added";
  EXPECT_TRUE(index("+!g(T) <- .add_plan(T).\n").has_open_goals);
  EXPECT_FALSE(index("+!g <- .add_plan({ +!h <- a }).\n").has_open_goals) << "it is written there";
}

TEST(ProgramIndex, IsClosedOtherwise) {
  const ProgramIndex of = index("b(1).\n+!g(X) : b(X) <- +c(X); !h.\n+!h.\n");
  EXPECT_FALSE(of.has_open_goals);
  EXPECT_FALSE(of.has_open_beliefs);
}

TEST(ProgramIndex, IsOpenWhereAnIncludeIsMissing) {
  Diagnostics diagnostics;
  const SourceTree program = load_agent(
      std::make_shared<const Source>("test", "{ include(\"nowhere.asl\") }\n"), {}, diagnostics);
  const ProgramIndex of = index_of(program);
  EXPECT_TRUE(of.has_open_goals);
  EXPECT_TRUE(of.has_open_beliefs);
}

TEST(Mentions, AreOfNamesThatAreUsed) {
  const SourceTree program = loaded("defined :- used.\n+!plan(X) : asked <- !posted.\n");
  const auto names = mentions_in(program).names;
  for (const char* name : {"used", "asked", "posted"}) EXPECT_THAT(names, Contains(name));
  EXPECT_THAT(names, Not(Contains("defined"))) << "the head of a rule";
  EXPECT_THAT(names, Not(Contains("plan"))) << "the trigger of a plan";
}

TEST(Mentions, AreWordsOfTextsToo) {
  const SourceTree program = loaded("+!g <- .add_plan(\"+!new_goal(X, 2nd) <- !other1.\").\n");
  const auto names = mentions_in(program).names;
  for (const char* name : {"new_goal", "other1", "X"}) EXPECT_THAT(names, Contains(name));
  EXPECT_THAT(names, Not(Contains("2nd"))) << "no name begins with a digit";
}

TEST(Mentions, AreInArgumentsAndAnnotations) {
  const SourceTree program = loaded("b(in_argument)[in_annotation].\n");
  const auto names = mentions_in(program).names;
  for (const char* name : {"in_argument", "in_annotation"}) EXPECT_THAT(names, Contains(name));
}

TEST(Mentions, ShowWhetherThereAreOtherAgents) {
  const auto social = [](const std::string& text) { return shows_other_agents(loaded(text)); };
  EXPECT_TRUE(social("+!g <- .send(bob, tell, b).\n"));
  EXPECT_TRUE(social("+!kqml_received(A, B, C, D) : kqml_mine <- true.\n"));
  EXPECT_TRUE(social("+!g : b[source(bob)] <- true.\n"));
  EXPECT_TRUE(social("+!g : b[source(S)] <- true.\n"));
  EXPECT_FALSE(social("+!g : b[source(self)] & c[source(percept)] <- .print(1).\n"));
}

}  // namespace
}  // namespace jaywalk
