// SPDX-License-Identifier: Apache-2.0
// One tick of a system with an environment.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using test::TestWorld;
using testing::ElementsAre;

TEST(Tick, BeginsWithPerceiving) {
  System system;
  system.add("ann", "+tick(N) <- .print(N).");
  TestWorld world(*system.symbols, 2);
  EXPECT_EQ(system.run(&world).end, RunEnd::finished);
  EXPECT_THAT(system.printed, ElementsAre("[ann] 0", "[ann] 1", "[ann] 2"));
}

TEST(Tick, ExecutesTheActionsOfAllAgentsAtOnce) {
  System system;
  system.add("ann", "!s. +!s <- go; stay.");
  system.add("bob", "!s. +!s <- stay.");
  TestWorld world(*system.symbols, 1);
  system.run(&world);
  EXPECT_THAT(world.history, ElementsAre("0:go 1:stay", "0:stay"));
}

TEST(Tick, HasOneActionOfEachAgent) {
  System system;
  system.add("ann", "!a. !b. +!a <- left. +!b <- right.");
  TestWorld world(*system.symbols, 2);
  system.run(&world);
  EXPECT_THAT(world.history, ElementsAre("0:left", "0:right", ""));
}

TEST(Tick, LastsUntilNobodyHasAnythingToSay) {
  System system;
  system.add("ann",
             "+tick(N) <- .send(bob, askOne, double(N, _), double(_, D)); .print(N, D); go.");
  system.add("bob", "double(N, D) :- D = 2 * N. +?double(N, D) <- D = 2 * N.");
  TestWorld world(*system.symbols, 1);
  system.run(&world);
  EXPECT_THAT(system.printed, ElementsAre("[ann] 00", "[ann] 12"));
  EXPECT_THAT(world.history, ElementsAre("0:go", "0:go"));
}

TEST(Tick, TellsInTheNextOneWhyAnActionFailed) {
  System system;
  system.add("ann",
             "!s. +!s <- refuse. "
             "-!s[error(E), error_msg(M)] <- ?tick(N); .print(N, \" \", E, \": \", M).");
  TestWorld world(*system.symbols, 1);
  system.run(&world);
  EXPECT_THAT(system.printed, ElementsAre("[ann] 1 action_failed: the world says no"));
}

TEST(Tick, MovesTheClock) {
  System system;
  system.add("ann", "!s. +!s <- .wait(250); ?tick(N); .print(N).");
  TestWorld world(*system.symbols, 5);
  system.run(&world);
  EXPECT_THAT(system.printed, ElementsAre("[ann] 3"));
}

TEST(Tick, StopsAgentsThatTalkForEver) {
  MasOptions options;
  options.max_rounds = 50;
  System system(options);
  system.add("ann", "!ball. +!ball <- .send(bob, achieve, ball).");
  system.add("bob", "+!ball <- .send(ann, achieve, ball).");
  TestWorld world(*system.symbols, 5);
  const RunOutcome outcome = system.run(&world);
  EXPECT_EQ(outcome.end, RunEnd::looping);
  EXPECT_EQ(outcome.message, "agents exchanged messages for 50 rounds in one tick");
}

TEST(Tick, StopsAnAgentThatNeverRests) {
  MasOptions options;
  options.max_cycles_per_tick = 500;
  System system(options);
  system.add("ann", "!s. +!s <- !s.");
  TestWorld world(*system.symbols, 5);
  const RunOutcome outcome = system.run(&world);
  EXPECT_EQ(outcome.end, RunEnd::looping);
  EXPECT_THAT(outcome.message, testing::HasSubstr("agent ann reasoned for 500 cycles"));
}

TEST(Tick, DescribesWhatAgentsAreAfter) {
  System system;
  system.add("ann", "!s(1). +!s(X) <- !sub(X, [a]). +!sub(X, Y)[source(self)] <- go; go; go.");
  TestWorld world(*system.symbols, 1);
  system.run(&world);
  EXPECT_THAT(system.mas->describe_intentions(AgentId{0}), ElementsAre("s(1) > sub(1,[a])"));
}

}  // namespace
}  // namespace jaywalk
