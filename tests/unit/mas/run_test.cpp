// SPDX-License-Identifier: Apache-2.0
// A system without environment: rounds, time, limits.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::ElementsAre;

TEST(Run, EndsWhenAllAreIdle) {
  System system;
  system.add("ann", "!s. +!s <- .print(a).");
  EXPECT_EQ(system.run().end, RunEnd::idle);
}

TEST(Run, GivesEachAgentOneCycleInTurn) {
  System system;
  system.add("ann", "!s. +!s <- .print(1); .print(2).");
  system.add("bob", "!s. +!s <- .print(1); .print(2).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] 1", "[bob] 1", "[ann] 2", "[bob] 2"));
}

TEST(Run, LetsTimePassOnlyWhenAllAreIdle) {
  System system;
  system.add("ann", "!a. !b. +!a <- .wait(200); .print(late). +!b <- .wait(100); .print(early).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] early", "[ann] late"));
  EXPECT_EQ(system.mas->now_ms(), 200);
}

TEST(Run, FiresTimersOfOneTimeInTheOrderOfAsking) {
  System system;
  system.add("ann", "!s. +!s <- .print(x); .wait(100); .print(ann).");
  system.add("bob", "!s. +!s <- .wait(100); .print(bob).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] x", "[ann] ann", "[bob] bob"));
}

TEST(Run, DoesNotWaitForTimersThatNobodyNeeds) {
  System system;
  system.add("ann", "!s. !t. +!s <- .wait({+e}, 60000); .print(e). +!t <- .wait(10); +e.");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] e"));
  EXPECT_EQ(system.mas->now_ms(), 10);
}

TEST(Run, LetsWaitingAgentsThroughWhereAnotherNeverRests) {
  System system;
  system.add("ann", "!s. +!s <- !s.");
  system.add("bob", "!s. +!s <- .wait(10); .stopMAS.");
  EXPECT_EQ(system.run().end, RunEnd::stopped);
}

TEST(Run, StopsAnAgentThatNeverRests) {
  MasOptions options;
  options.max_cycles_per_tick = 500;
  System system(options);
  system.add("ann", "!s. +!s <- !s.");
  EXPECT_EQ(system.run().end, RunEnd::looping);
}

TEST(Run, StopsAtTheLimitOfCycles) {
  MasOptions options;
  options.max_cycles = 20;
  System system(options);
  system.add("ann", "!s. +!s <- .wait(10); !s.");
  const RunOutcome outcome = system.run();
  EXPECT_EQ(outcome.end, RunEnd::limit);
  EXPECT_EQ(outcome.message, "agent ann reached the limit of 20 cycles");
}

TEST(Run, IsTheSameEveryTime) {
  const auto play = [](std::uint64_t seed) {
    MasOptions options;
    options.seed = seed;
    System system(options);
    system.provide("p.asl", "+!play <- .random(X); .wait(X * 100); .send(boss, tell, won(X)).");
    system.add("boss",
               "!s. +!s <- for (.range(I, 1, 5)) { .create_agent(p, \"p.asl\") }; "
               ".broadcast(achieve, play). +won(X)[source(S)] <- .print(S, \" \", X).");
    system.run();
    return system.printed;
  };
  EXPECT_EQ(play(7).size(), 5U);
  EXPECT_EQ(play(7), play(7));
  EXPECT_NE(play(7), play(8));
}

TEST(Run, TellsAgentsThatTheyFallAsleepAndAwake) {
  System system;
  system.add("ann",
             "+jag_sleeping <- .print(tired). +jag_awaking <- .print(awake). +p <- .print(p).");
  system.add("bob", "!s. +!s <- .wait(100); .send(ann, tell, p).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] tired", "[ann] awake", "[ann] p", "[ann] tired"));
}

TEST(Run, CostsNothingForIdleAgents) {
  System system;
  for (int i = 0; i < 200; ++i) system.add("idle", "");
  system.add("ann", "!s(0). +!s(5000). +!s(N) <- !s(N + 1).");
  const RunOutcome outcome = system.run();
  EXPECT_LT(outcome.cycles, 12'000U);
}

TEST(Run, FollowsTheWallClockInRealTime) {
  MasOptions options;
  options.realtime = true;
  System system(options);
  system.add("ann", "!s. +!s <- .wait(5); .print(later).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] later"));
  EXPECT_GE(system.mas->now_ms(), 5);
}

}  // namespace
}  // namespace jaywalk
