// SPDX-License-Identifier: Apache-2.0
// Questions for whose answers an intention waits.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::ElementsAre;

constexpr const char* kKnows = "age(carl, 31). age(erin, 44). half(X, Y) :- Y = X / 2.";

std::vector<std::string> ask(const std::string& plan, const std::string& answerer = kKnows) {
  System system;
  system.add("ann", "!s. " + plan);
  system.add("bob", answerer);
  system.run();
  return system.printed;
}

TEST(Ask, BindsTheAnswer) {
  EXPECT_THAT(ask("+!s <- .send(bob, askOne, age(erin, _), age(_, N)); .print(N)."),
              ElementsAre("[ann] 44"));
}

TEST(Ask, OfARuleGetsWhatItConcludes) {
  EXPECT_THAT(ask("+!s <- .send(bob, askOne, half(9, _), A); .print(A)."),
              ElementsAre("[ann] half(9,4.5)[source(bob)]"));
}

TEST(Ask, WithoutAnswerIsFalse) {
  EXPECT_THAT(ask("+!s <- .send(bob, askOne, age(dora, _), A); .print(A)."),
              ElementsAre("[ann] false"));
}

TEST(Ask, FailsIfTheAnswerDoesNotUnify) {
  EXPECT_THAT(ask("+!s <- .send(bob, askOne, age(erin, _), age(_, 3)). "
                  "-!s[error(E)] <- .print(E)."),
              ElementsAre("[ann] ask_failed"));
}

TEST(Ask, InALoopBindsAnewInEachRound) {
  EXPECT_THAT(ask("+!s <- for (.member(P, [carl, erin])) "
                  "{ .send(bob, askOne, age(P, _), age(_, N)); .print(N) }."),
              ElementsAre("[ann] 31", "[ann] 44"));
}

TEST(Ask, OfSeveralWaitsForAll) {
  System system;
  system.add("ann", "!s. +!s <- .send([bob, carl], askOne, w(_), L); .length(L, N); .print(N, L).");
  system.add("bob", "w(70).");
  system.add("carl", "+?w(X) <- .wait(300); X = 65.");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] 2[w(70)[source(bob)],w(65)[source(carl)]]"));
}

TEST(Ask, OfNobodyIsAnsweredAtOnce) {
  EXPECT_THAT(ask("+!s <- .send([], askOne, w(_), L); .print(L)."), ElementsAre("[ann] []"));
}

TEST(Ask, TimesOutWithAnAtom) {
  EXPECT_THAT(
      ask("+!s <- .send(bob, askOne, slow(_), A, 200); .print(A); .wait(1000); .print(end).",
          "+?slow(X) <- .wait(500); X = 1."),
      ElementsAre("[ann] timeout", "[ann] end"));
}

TEST(Ask, OfSeveralTimesOutWithTheAnswersSoFar) {
  System system;
  system.add("ann", "!s. +!s <- .send([bob, carl], askOne, w(_), L, 100); .print(L).");
  system.add("bob", "w(70).");
  system.add("carl", "+?w(X) <- .wait(300); X = 65.");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] [w(70)[source(bob)]]"));
}

TEST(Ask, IsForgottenWithTheGoalThatAsked) {
  System system;
  system.add("ann",
             "!s. +!s <- !!stop; !q; .print(never). +!q <- .send(bob, askOne, w(_), A). "
             "+!stop <- .wait(100); .drop_intention(s); .print(dropped).");
  system.add("bob", "+?w(X) <- .wait(300); X = 65.");
  EXPECT_EQ(system.run().end, RunEnd::idle);
  EXPECT_THAT(system.printed, ElementsAre("[ann] dropped"));
}

TEST(Ask, IsSuspendedByNameUntilResumed) {
  System system;
  system.add("ann",
             "!s. +!s <- !!other; .send(bob, askOne, w(_), w(N)); .print(N). "
             "+!other <- .wait(100); .suspend(s); .wait(500); .print(resuming); .resume(s).");
  system.add("bob", "+?w(X) <- .wait(300); X = 65.");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] resuming", "[ann] 65"));
}

TEST(Ask, MayBeForPlans) {
  EXPECT_THAT(ask("+!s <- .send(bob, askHow, {+!cook(_)}, L); .add_plan(L, bob); !cook(egg).",
                  "@c +!cook(W) <- .print(\"boil \", W)."),
              ElementsAre("[ann] boil egg"));
}

TEST(Ask, OfOneselfIsAnswered) {
  System system;
  system.add("ann", "k(1). !s. +!s <- .send(self, askOne, k(_), k(N)); .print(N).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] 1"));
}

}  // namespace
}  // namespace jaywalk
