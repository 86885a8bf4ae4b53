// SPDX-License-Identifier: Apache-2.0
// All that an agent owns counts against its memory, not terms alone.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::uint64_t kSmall = 1U << 20U;

MasOptions small(std::uint64_t cycles) {
  MasOptions options;
  options.max_cycles = cycles;
  options.max_agent_bytes = kSmall;
  return options;
}

struct Hoarder {
  const char* what;
  const char* program;
};

/// Each gets more and more of something.
TEST(MemoryLimit, HoldsForAllThatAnAgentOwns) {
  for (const Hoarder& each : std::vector<Hoarder>{
           {"goals", "!go. +!go <- !go; a."},
           {"goals that are tests", "!go. +!go <- ?down; a. +?down <- ?down; a. "},
           {"new goals", "!go. +!go <- !!go; !!go."},
           {"events", "!go. +!go <- !!one; !!two; !go. +!one <- !!one; !!one. +!two <- .wait(10)."},
           {"intentions", "!go. +!go <- !!wait; !go. +!wait <- .wait(100000)."},
           {"loops", "!go. +!go <- for (.range(X, 1, 20)) { !go; a }."},
           {"beliefs", "!go. +!go <- !add(0). +!add(N) <- +b(N); !add(N + 1)."},
           {"rules", "!go. +!go <- !add(0). +!add(N) <- +{r(N) :- x & y}; !add(N + 1)."},
           {"plans",
            "!go. +!go <- !add(0). +!add(N) <- .concat(\"+!g(\", N, \").\", S); "
            ".add_plan(S); !add(N + 1)."},
           {"appointments", "!go. +!go <- .at(\"now +1000 s\", {+!late}); !go."},
           {"sets",
            "!go(0). +!go(N) <- .set.create(S); .set.add_all(S, [N,2,3]); +s(S); !go(N + 1)."},
           {"branches", "!go. +!go <- { !go; a } |&| { !go; b }."},
           {"messages to itself",
            "!go. +!go <- .my_name(N); .send(N, achieve, go); .send(N, achieve, go)."},
           {"failures", "!go. +!go <- !deep(10); a. +!deep(N) <- .fail. -!deep(N) <- !go; c."},
           {"solutions", "n(0). n(X) :- n(Y) & X = Y + 1. !a. +!a <- .findall(f(X, X), n(X), L)."},
           {"terms of a query", "p(X) :- p(f(X, X)) | q. !a. +!a <- ?p(0)."},
           {"frames of a query", "p(N) :- p(N + 1) & q. !a. +!a <- ?p(0)."},
           {"a list", "!a. +!a <- !d([f(1, 2)]). +!d(L) <- .concat(L, L, M); !d(M)."}}) {
    MasOptions options = small(100'000);
    options.at_memory_limit = MasOptions::AtMemoryLimit::end_run;
    const test::AgentRun run = test::run_agents({{"agent", each.program}}, options);
    EXPECT_EQ(run.errors.size(), 0U) << each.what;
    EXPECT_EQ(run.outcome.limit, RunLimit::memory) << each.what << ": " << run.outcome.message;
  }
}

/// The numbers of later rounds are not stored.
TEST(MemoryLimit, LetsLoopsGoThroughManyNumbers) {
  const test::AgentRun run = test::run_agents(
      {{"agent", "!go. +!go <- for (.range(X, 1, 100000)) { Y = X }; .print(done)."}},
      small(1'000'000));
  EXPECT_THAT(run.printed_by("agent"), ElementsAre("done"));
}

TEST(MemoryLimit, FailsTheStepThatAsksForMore) {
  const test::AgentRun run = test::run_agents(
      {{"agent",
        "!top. +!top <- !go(0). -!top[error(E), error_msg(M)] <- .print(E, \": \", M). "
        "+!go(N) <- !go(N + 1); a. !other. +!other <- .wait(1); .print(other)."},
       {"neighbour", "!see(2000). +!see(0) <- .print(unharmed). +!see(N) <- !see(N - 1)."}},
      small(100'000));
  EXPECT_THAT(run.printed_by("agent"), Contains("limit: the agent's memory limit is reached"))
      << ::testing::PrintToString(run.logged);
  EXPECT_THAT(run.printed_by("agent"), Contains("other"));
  EXPECT_THAT(run.printed_by("neighbour"), Contains("unharmed"));
}

/// A failed step's memory is released, so that its failure plan has it.
TEST(MemoryLimit, LeavesTheAgentAbleToGoOn) {
  const test::AgentRun run = test::run_agents(
      {{"agent",
        "!again(0). +!again(3) <- .print(done). +!again(N) <- !down(0); !again(N + 1). "
        "-!again(N) <- .print(failed(N)); !again(N + 1). +!down(N) <- +d(N); !down(N + 1); a."}},
      small(1'000'000));
  EXPECT_THAT(run.printed_by("agent"), Contains("failed(0)"));
  EXPECT_THAT(run.printed_by("agent"), Contains("done"));
}

/// A storm is held off for as long as it lasts, and the agent gets to what else it has to do.
TEST(MemoryLimit, HoldsForAsLongAsAStormLasts) {
  const test::AgentRun run = test::run_agents(
      {{"agent", "!go. +!go <- !!go; !!go. !other. +!other <- .wait(20); .print(other)."}},
      small(100'000));
  EXPECT_EQ(run.outcome.limit, RunLimit::cycles);
  EXPECT_THAT(run.printed_by("agent"), Contains("other"));
  EXPECT_LT(run.errors.size() + run.printed.size(), 200U);
}

}  // namespace
}  // namespace jaywalk
