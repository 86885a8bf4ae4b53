// SPDX-License-Identifier: Apache-2.0
// Agents that come and go while the system runs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using test::TestWorld;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Creation, StartsTheNewAgent) {
  System system;
  system.provide("w.asl", "!hi. +!hi <- .my_name(N); .print(\"I am \", N).");
  system.add("boss", "!s. +!s <- .create_agent(helper, \"w.asl\"); .all_names(L); .print(L).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[boss] [boss,helper]", "[helper] I am helper"));
}

TEST(Creation, GivesSuffixesToNamesThatAreTaken) {
  System system;
  system.provide("w.asl", "");
  system.add("boss",
             "!s. +!s <- for (.range(I, 1, 3)) { .create_agent(w, \"w.asl\") }; "
             ".create_agent(Worker, \"w.asl\"); .print(Worker); .all_names(L); .print(L).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[boss] worker", "[boss] [boss,w,w_1,w_2,worker]"));
}

TEST(Creation, FailsWithWhatIsWrongInTheProgram) {
  System system;
  system.provide("w.asl", "p(.");
  system.add("boss",
             "!s. !t. +!s <- .create_agent(w, \"w.asl\"). +!t <- .create_agent(w, \"x.asl\"). "
             "-!G[error_msg(M)] <- .print(M).");
  system.run();
  ASSERT_EQ(system.printed.size(), 2U);
  EXPECT_THAT(system.printed[0], HasSubstr("w.asl"));
  EXPECT_EQ(system.printed[1], "[boss] no file x.asl");
}

TEST(Creation, HasALimit) {
  MasOptions options;
  options.max_agents = 3;
  System system(options);
  system.provide("w.asl", "");
  system.add("boss",
             "!s. +!s <- while (true) { .create_agent(w, \"w.asl\") }. "
             "-!s[error_msg(M)] <- .print(M).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[boss] the limit of 3 agents is reached"));
}

TEST(Creation, LeavesTheNewAgentWithoutABody) {
  System system;
  system.provide("w.asl",
                 "!go. +!go <- walk. -!go[error(E)] <- .print(E). +tick(_) <- .print(no).");
  system.add("boss", "!s. +!s <- .create_agent(w, \"w.asl\"); walk.");
  TestWorld world(*system.symbols, 2);
  system.run(&world);
  EXPECT_THAT(system.printed, ElementsAre("[w] action_failed"));
  EXPECT_THAT(world.history, ElementsAre("0:walk", "", ""));
}

TEST(Killing, EndsAnAgentThatWaits) {
  System system;
  system.add("ann", "!s. +!s <- .wait(100); .kill_agent(bob); .all_names(L); .print(L).");
  system.add("bob", "!s. +!s <- .print(waiting); .wait(500); .print(never).");
  EXPECT_EQ(system.run().end, RunEnd::idle);
  EXPECT_THAT(system.printed, ElementsAre("[bob] waiting", "[ann] [ann]"));
  EXPECT_FALSE(system.mas->is_alive(AgentId{1}));
}

TEST(Killing, OfOneselfEndsThePlan) {
  System system;
  system.add("ann", "!s. +!s <- .print(a); .kill_agent(ann); .print(never).");
  system.add("bob", "!s. +!s <- .wait(100); .send(ann, tell, p). -!s[error(E)] <- .print(E).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] a", "[bob] receiver_not_found"));
}

TEST(Killing, OfSomebodyUnknownFails) {
  System system;
  system.add("ann", "!s. +!s <- .kill_agent(bob). -!s[error(E)] <- .print(E).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[ann] ia_failed"));
}

TEST(Killing, LeavesTimeIfAsked) {
  System system;
  system.add("ann", "!s. +!s <- .kill_agent(bob, 300); .wait(400); .all_names(L); .print(L).");
  system.add(
      "bob",
      "+jag_shutting_down(T) <- .print(T); .wait(200); .print(saved); .wait(200); .print(no).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[bob] 300", "[bob] saved", "[ann] [ann]"));
}

TEST(Killing, KeepsWhatTheAgentHasSaid) {
  System system;
  system.provide("w.asl", "!s. +!s <- .send(boss, tell, word([x, \"y\", f(z)])).");
  system.add("boss",
             "!s. +!s <- .create_agent(w, \"w.asl\"); .wait(100); .kill_agent(w); .wait(100); "
             "for (.range(I, 1, 20000)) { ?word(M) }; ?word(L); .print(L).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[boss] [x,\"y\",f(z)]"));
}

TEST(Cloning, CopiesBeliefsPlansAndWhatIsGoingOn) {
  System system;
  system.add("ann",
             "b(1). b(2). r(X) :- b(X) & X > 1. !s. !count(3). "
             "+!s <- .add_plan({+!new(X) <- .my_name(N); .print(N, \" has \", X)}); +b(3); "
             ".clone(\"twin\"); .send(twin, achieve, show). "
             "+!count(0). +!count(N) <- !count(N - 1). "
             "+!show <- .findall(X, r(X), L); .findall(X, b(X), M); .print(L, M); !new(2).");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[twin] [3,2][3,1,2]", "[twin] twin has 2"));
}

TEST(Cloning, GoesOnInTheMiddleOfAnIntention) {
  System system;
  system.add(
      "ann",
      "!walk(0). !s. +!walk(N) : N < 6 <- .my_name(M); .print(M, N); !walk(N + 1). +!walk(_). "
      "+!s <- X = 1; .clone(twin).");
  system.run();
  EXPECT_THAT(system.printed, testing::Contains("[twin] twin5").Times(1));
  EXPECT_THAT(system.printed, testing::Not(testing::Contains("[twin] twin0")));
}

TEST(Stopping, WithADeadlineTellsEveryAgent) {
  System system;
  system.add("ann", "!s. +!s <- .stopMAS(500, 3); .wait(1000); .print(never).");
  system.add("bob", "+jag_shutting_down(T) <- .print(T).");
  const RunOutcome outcome = system.run();
  EXPECT_EQ(outcome.end, RunEnd::stopped);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(system.mas->now_ms(), 500);
  EXPECT_THAT(system.printed, ElementsAre("[bob] 500"));
}

TEST(Stopping, WithFalseStopsToo) {
  System system;
  system.add("ann", "!s. +!s <- .stopMAS(0, false).");
  EXPECT_EQ(system.run().end, RunEnd::stopped);
}

}  // namespace
}  // namespace jaywalk
