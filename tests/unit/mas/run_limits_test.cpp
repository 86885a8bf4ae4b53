// SPDX-License-Identifier: Apache-2.0
// Limits of a whole run: which one ended it, who reached it, and where.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// An agent that asks for ever, a little at a time.
constexpr const char* kAsker = "n(0). n(N) :- N > 0 & n(N - 1). !go.\n+!go <- ?n(50); !go.";

TEST(RunLimits, EndARunThatTakesTooManyInferences) {
  MasOptions options;
  options.max_run_inferences = 100'000;
  const test::AgentRun run = test::run_agents({{"asker", kAsker}}, options);
  EXPECT_EQ(run.outcome.end, RunEnd::limit);
  EXPECT_EQ(run.outcome.limit, RunLimit::inferences);
  EXPECT_EQ(run.outcome.agent, "asker");
  EXPECT_THAT(run.outcome.message, HasSubstr("100000 inferences"));
  EXPECT_GE(run.outcome.inferences, 100'000U);
}

/// A single query, after which the sum would not be checked again.
TEST(RunLimits, EndAQueryThatTakesAllOfTheRunsInferences) {
  MasOptions options;
  options.max_run_inferences = 50'000;
  const test::AgentRun run =
      test::run_agents({{"burner", "p :- p. !go.\n+!go <- ?p. -!go <- !go."}}, options);
  EXPECT_EQ(run.outcome.limit, RunLimit::inferences);
  EXPECT_EQ(run.outcome.agent, "burner");
  EXPECT_EQ(run.outcome.where, "burner.asl:2:9");
  EXPECT_LT(run.outcome.inferences, 60'000U);
}

TEST(RunLimits, CountTheInferencesOfAllAgents) {
  MasOptions options;
  options.max_run_inferences = 100'000;
  options.max_cycles = 100;
  const auto end = [&](int agents) {
    std::vector<test::NamedProgram> team;
    for (int i = 0; i < agents; ++i) team.push_back({"a" + std::to_string(i), kAsker});
    return test::run_agents(team, options).outcome.limit;
  };
  EXPECT_EQ(end(1), RunLimit::cycles);
  EXPECT_EQ(end(100), RunLimit::inferences);
}

TEST(RunLimits, CountTheInferencesOfOneRunAlone) {
  test::System system;
  system.options.max_run_inferences = 20'000;
  system.add("ann", "n(0). n(N) :- N > 0 & n(N - 1). !go. +!go <- ?n(3000).");
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(system.run().end, RunEnd::idle) << i;
    EXPECT_GT(system.mas->outcome().inferences, 3000U);
  }
}

TEST(RunLimits, EndARunAtItsFirstLackOfMemoryIfThatIsAskedFor) {
  MasOptions options;
  options.max_agent_bytes = 1U << 20U;
  const std::string program = "!a([1]).\n+!a(L) <- .concat(L, L, M); !a(M).\n-!a(_) <- .print(no).";
  EXPECT_EQ(test::run_agents({{"hoarder", program}}, options).outcome.limit, RunLimit::none);
  options.at_memory_limit = MasOptions::AtMemoryLimit::end_run;
  const RunOutcome outcome = test::run_agents({{"hoarder", program}}, options).outcome;
  EXPECT_EQ(outcome.end, RunEnd::limit);
  EXPECT_EQ(outcome.limit, RunLimit::memory);
  EXPECT_EQ(outcome.agent, "hoarder");
  EXPECT_THAT(outcome.where, HasSubstr("hoarder.asl:2:"));
}

TEST(RunLimits, NameTheLimitOfCyclesAndWhereTheAgentIs) {
  MasOptions options;
  options.max_cycles = 50;
  const RunOutcome outcome =
      test::run_agents({{"runner", "!a.\n+!a <- !b; !a.\n+!b."}}, options).outcome;
  EXPECT_EQ(outcome.limit, RunLimit::cycles);
  EXPECT_EQ(outcome.agent, "runner");
  EXPECT_THAT(outcome.where, HasSubstr("runner.asl:"));
  options = {.max_cycles_per_tick = 1000};
  EXPECT_EQ(test::run_agents({{"r", "!a. +!a <- !a."}}, options).outcome.limit, RunLimit::cycles);
}

TEST(RunLimits, AreNamedAsOptionsAre) {
  EXPECT_EQ(name(RunLimit::inferences), "inferences");
  EXPECT_EQ(name(RunLimit::memory), "memory");
  EXPECT_THAT(name(RunLimit::none), IsEmpty());
}

/// A query asks in time, and so does an agent that never rests.
TEST(RunLimits, LetTheOutsideInterruptARun) {
  for (const char* const program :
       {"p :- p. !go. +!go <- ?p. -!go <- !go.", "!go. +!go <- !go.",
        "p :- p. !go. +!go : p. -!go <- !go.", "!go. +!go <- .send(agent, achieve, go)."}) {
    int asked = 0;
    MasOptions options;
    options.max_cycles = UINT64_MAX;
    options.max_inferences = UINT64_MAX / 2;
    options.interrupted = [&asked] { return ++asked > 20; };
    const RunOutcome outcome = test::run_agents({{"agent", program}}, options).outcome;
    EXPECT_EQ(outcome.end, RunEnd::interrupted) << program;
    EXPECT_LT(asked, 1000) << program;
  }
}

}  // namespace
}  // namespace jaywalk
