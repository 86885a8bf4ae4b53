// SPDX-License-Identifier: Apache-2.0
// Agents that start when they first reason, or when they are inspected.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/agent.h"
#include "interpreter/mas/mas.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using test::TestWorld;
using testing::ElementsAre;

constexpr std::string_view kCounter = R"(
  last(3). reached(0).
  !count.
  +!count : reached(N) & last(N) <- .print(done).
  +!count : reached(N) <- -+reached(N + 1); !count.
)";

TEST(Start, IsThereForWhoLooksBeforeTheFirstStep) {
  System system;
  system.add("a", kCounter);
  Mas mas(system.symbols, system.options, nullptr);
  const AgentId id = mas.add_agent(system.agents.front());
  EXPECT_THAT(mas.describe_beliefs(id),
              ElementsAre("reached(0)[source(self)]", "last(3)[source(self)]"));
  EXPECT_EQ(mas.agent(id).circumstance().events.size(), 1U);
  mas.run();
  EXPECT_THAT(mas.describe_beliefs(id),
              ElementsAre("reached(3)[source(self)]", "last(3)[source(self)]"));
  EXPECT_THAT(system.printed, ElementsAre("[a] done"));
}

TEST(Start, ComesBeforeWhatIsDoneFromOutside) {
  System system;
  system.add("a", kCounter);
  Mas mas(system.symbols, system.options, nullptr);
  const AgentId id = mas.add_agent(system.agents.front());
  std::string problem;
  EXPECT_TRUE(mas.intervene(
      id,
      [](Agent& agent) {
        const Value two = Value::number(2);
        const Predicate last = agent.symbols().predicate("last", 1);
        (void)agent.add_belief(agent.heap().structure(last, std::span(&two, 1)), Place::front,
                               nullptr);
      },
      problem));
  EXPECT_THAT(
      mas.describe_beliefs(id),
      ElementsAre("reached(0)[source(self)]", "last(2)[source(self)]", "last(3)[source(self)]"));
}

TEST(Start, ComesBeforePerceptsAndMessages) {
  System system;
  system.add("a", R"(
    last(2). !begin.
    +!begin <- .print(begins).
    +tick(N) <- .print(tick(N)).
    +hello[source(A)] <- .print(A).
  )");
  system.add("b", "!greet. +!greet <- .send(a, tell, hello).");
  TestWorld world(*system.symbols, 0);
  system.run(&world);
  EXPECT_THAT(system.printed, ElementsAre("[a] begins", "[a] tick(0)", "[a] b"));
}

TEST(Start, LeavesAnAgentWithAllThatItHasMade) {
  System system;
  system.add("a", R"(
    !begin.
    +!begin <- +list([1, f(X), "text"]); .queue.create(Q); .queue.add(Q, 1); +queue(Q);
       for (.range(I, 1, 20)) { +number(I, [I]) }; .wait(10); !go_on.
    +!go_on : list(L) & queue(Q) & number(7, S) <- .queue.add(Q, 2); .print(L, Q, S).
  )");
  system.run();
  EXPECT_THAT(system.printed, ElementsAre("[a] [1,f(X),\"text\"][1, 2][7]"));
}

// An agent that receives a message runs on while its sender rests.
TEST(Start, ComesForEachInARingThatPassesAToken) {
  System system;
  for (const char* const name : {"a", "b", "c"}) {
    system.add(name, R"(
      next(a, b). next(b, c). next(c, a).
      !look.
      +!look.
      +!token(N) : N < 200 & .my_name(Me) & next(Me, Next) <- .send(Next, achieve, token(N + 1)).
      +!token(N) : .my_name(Me) <- .print(N, Me).
    )");
  }
  system.add("starter", "!start. +!start <- .wait(1); .send(a, achieve, token(0)).");
  const RunOutcome outcome = system.run();
  EXPECT_THAT(system.printed, ElementsAre("[c] 200c"));
  EXPECT_EQ(outcome.end, RunEnd::idle);
}

}  // namespace
}  // namespace jaywalk
