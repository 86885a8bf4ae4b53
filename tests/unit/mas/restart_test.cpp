// SPDX-License-Identifier: Apache-2.0
// A system that begins anew is as one that was just made.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using test::TestWorld;

constexpr std::string_view kProgram = R"(
  known(a). sum(X, Y, Z) :- Z = X + Y. seen(0).
  !start.
  +!start : known(K) <- .random(R); .print(K, " ", R, " ", _); +fresh(K); !count(0).
  +!count(N) : N < 4 & sum(N, 1, M) <- +seen(M); !count(M).
  +!count(_) <- .findall(X, seen(X), L); .print(L); .abolish(known(_)); +later(b);
     .concat("made", "_here", S); .term2string(T, S); +T; .broadcast(tell, hello(T));
     .queue.create(Q); .queue.add(Q, 1); +queue(Q); .print(Q).
  +tick(N) : later(_) <- .print(tick(N)); go; .df_register(walker); .df_search(walker, L); .print(L).
  +hello(T)[source(A)] : seen(N) <- .print(A, T, N); .add_plan({ +tick(2) <- .print(two); refuse }).
  -!G[error(E)] <- .print(G, E); .wait(100); .print(waited).
)";

/// Runs the agents in a world of their own.
std::vector<std::string> run(System& system, Mas& mas, int agents) {
  system.printed.clear();
  for (int i = 0; i < agents; ++i) {
    AgentSpec spec = system.agents.front();
    spec.name = fmt::format("a{}", i);
    mas.add_agent(spec);
  }
  const RunOutcome outcome = mas.run();
  std::vector<std::string> seen = system.printed;
  seen.push_back(fmt::format("{} {} {} {} {}", static_cast<int>(outcome.end), outcome.ticks,
                             outcome.cycles, outcome.message, mas.now_ms()));
  for (int i = 0; i < agents; ++i) {
    for (std::string& belief : mas.describe_beliefs(static_cast<AgentId>(i))) {
      seen.push_back(std::move(belief));
    }
  }
  return seen;
}

// Whatever it is cut off in: a question, a timer, a wait, a suspended goal, a deadline, branches,
// a loop, an atomic plan, subscriptions to the yellow pages, agents that were created, plans that
// were added, percepts not looked at yet.
constexpr std::string_view kPending = R"(
  !ask. !later. !sleep. !late[hard_deadline(250)]. !both. !held.
  +!ask <- .create_agent(H, "w.asl"); .send(H, askOne, secret(_), A, 300); .print(H, A);
     .send(H, tell, hi); .send(H, askOne, unknown(_), B, 200); .print(B);
     .clone(C); .send(C, tell, made).
  +!later <- .at("now +150 milliseconds", {+!due}); .df_subscribe(walker); .suspend; .print(goes_on).
  +!due <- .print(due); .resume(later); .df_register(walker);
     .add_plan({ @made +tick(4) <- .print(four) }); .relevant_plans({ +tick(_) }, _, L); .print(L).
  +!sleep <- .wait({+provider(_, _)}, 1000, T); .print(woken, T); .stopMAS(300).
  +!late <- .print(late, _); .wait(5000).
  -!late[error(E)] <- .print(E).
  +!both <- !loop(1) |&| !loop(2); .print(both).
  +!loop(N) <- for (.range(I, 1, 2)) { .wait(20); .print(N, I) }.
  @held[atomic] +!held <- .wait(120); .print(held).
  ^!sleep[state(S)] <- .print(S).
  +provider(A, S) <- .print(A, S).
  +made <- .print(made); .my_name(M); .wait(50); .kill_agent(M).
  +tick(T) <- .random(R); .print(tick(T), R); go; +gone(T).
  +!kqml_received(A, achieve, C, Id) <- .print(A, C, Id).
)";
constexpr std::string_view kHelper = R"(
  secret(7).
  +hi[source(A)] <- .print(A); .send(A, achieve, greet(_)); .send(A, achieve, greet(1)).
)";

TEST(Restart, ForgetsWhatWasGoingOn) {
  System system;
  system.provide("w.asl", kHelper);
  system.add("ann", kPending);
  system.agents.front().settings.cycles_per_look = 3;
  constexpr int kLastTick = 12;
  TestWorld world(*system.symbols, kLastTick);
  Mas fresh(system.symbols, system.options, &world);
  const std::vector<std::string> expected = run(system, fresh, 2);
  EXPECT_THAT(expected,
              testing::IsSupersetOf(
                  {"[a0] due", "[a1] goes_on", "[h] a0", "[a0] both", "[a1] held",
                   "[a0] [p__12[source(self),url(\"file:ann.asl\")],made[source(self)]]"}));
  TestWorld unused(*system.symbols, kLastTick);
  Mas reused(system.symbols, system.options, &unused);
  for (int steps = 0; steps <= kLastTick; ++steps) {
    TestWorld cut(*system.symbols, kLastTick);
    reused.restart(system.options, &cut);
    for (int i = 0; i < 3; ++i) reused.add_agent(system.agents.front());
    for (int i = 0; i < steps; ++i) (void)reused.step();
    TestWorld again(*system.symbols, kLastTick);
    reused.restart(system.options, &again);
    EXPECT_EQ(run(system, reused, 2), expected) << "cut off after " << steps << " steps";
    EXPECT_EQ(again.history, world.history);
  }
}

TEST(Restart, ForgetsAllThatHappenedBefore) {
  System system;
  system.add("ann", kProgram);
  const auto make_world = [&] { return TestWorld(*system.symbols, 4); };
  TestWorld first = make_world();
  MasOptions options = system.options;
  Mas reused(system.symbols, options, &first);
  (void)run(system, reused, 5);
  for (const int agents : {3, 3, 6, 1}) {
    for (const std::uint64_t seed : {0U, 5U}) {
      options.seed = seed;
      TestWorld again = make_world();
      reused.restart(options, &again);
      const std::vector<std::string> after = run(system, reused, agents);
      TestWorld fresh = make_world();
      Mas mas(system.symbols, options, &fresh);
      EXPECT_EQ(after, run(system, mas, agents)) << agents << " agents, seed " << seed;
      EXPECT_EQ(again.history, fresh.history);
      EXPECT_GT(after.size(), 20U);
    }
  }
}

// Each agent does something else with the rules that it began with, and says what they answer.
constexpr std::string_view kRules = R"(
  given(0).
  r(X) :- X = 1.  r(X) :- X = 2 | X = 3.
  one(X) :- r(X) & X < 2.
  both(X) :- r(X).  both(fact).
  !go.
  +!go <- !ask; !change; !ask.
  +!ask : given(G) & .my_name(N) <- .findall(X, r(X), R); .findall(X, one(X), O);
     .findall(X, both(X), B); .print(G, N, R, O, B).
  +!change : .my_name(a0) <- +{ r(X) :- X = 4 }.
  +!change : .my_name(a1) <- +r(5).
  +!change : .my_name(a2) <- +r(6); -r(6).
  +!change : .my_name(a3) <- .include("more.asl").
  +!change : .my_name(a4) <- .abolish(both(_)); +{ one(X) :- r(X) }.
  +!change.
)";
constexpr std::string_view kMoreRules = "r(X) :- X = 7. one(more).";

TEST(Restart, LeavesTheRulesOfTheProgramAndNoOthers) {
  System system;
  system.provide("more.asl", kMoreRules);
  system.add("ann", kRules);
  Mas reused(system.symbols, system.options, nullptr);
  for (const int agents : {6, 5, 6, 3, 6}) {
    const std::vector<std::string> after = run(system, reused, agents);
    Mas fresh(system.symbols, system.options, nullptr);
    EXPECT_EQ(after, run(system, fresh, agents)) << agents << " agents";
    reused.restart(system.options, nullptr);
  }
  EXPECT_THAT(run(system, reused, 6),
              testing::IsSupersetOf(
                  {"[a0] 0a0[4,1,2,3][1][4,1,2,3,fact]", "[a1] 0a1[5,1,2,3][1][5,1,2,3,fact]",
                   "[a2] 0a2[1,2,3][1][1,2,3,fact]", "[a3] 0a3[7,1,2,3][more,1][7,1,2,3,fact]",
                   "[a4] 0a4[1,2,3][1,2,3,1][1,2,3]", "[a5] 0a5[1,2,3][1][1,2,3,fact]"}));
}

TEST(Restart, PutsGivenBeliefsBeforeRulesThatWereLeft) {
  System system;
  system.add("ann", kRules);
  system.agents.front().parameters = {{system.symbols->predicate("given", 1), {Value::number(1)}}};
  const AgentSpec plain = system.agents.front();
  AgentSpec with_fact = plain;
  with_fact.parameters.push_back({system.symbols->predicate("r", 1), {Value::number(8)}});
  Mas reused(system.symbols, system.options, nullptr);
  for (const AgentSpec& spec : {plain, with_fact, plain, with_fact}) {
    system.agents.front() = spec;
    const std::vector<std::string> after = run(system, reused, 9);
    Mas fresh(system.symbols, system.options, nullptr);
    EXPECT_EQ(after, run(system, fresh, 9));
    const bool has_fact = spec.parameters.size() > 1;
    EXPECT_THAT(after, testing::Contains(has_fact ? "[a8] 1a8[1,2,3,8][1][1,2,3,8,fact]"
                                                  : "[a8] 1a8[1,2,3][1][1,2,3,fact]"));
    reused.restart(system.options, nullptr);
  }
}

}  // namespace
}  // namespace jaywalk
