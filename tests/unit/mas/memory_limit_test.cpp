// Memory that agents share: messages that wait, and the limit for all agents together.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint64_t kMegabyte = 1U << 20U;

/// The sender of a storm fails; who gets it goes on.
TEST(SystemMemory, HoldsForMessagesThatWait) {
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_agent_bytes = kMegabyte;
  const test::AgentRun run = test::run_agents(
      {{"teller",
        "!go. +!go <- .send(listener, achieve, a); .send(listener, achieve, b); !go. "
        "-!go[error(E), error_msg(M)] <- .print(E, \": \", M)."},
       {"listener", "!wait. @w[atomic] +!wait <- .wait(10); .print(alive). +!a. +!b."}},
      options);
  EXPECT_THAT(run.printed_by("teller"),
              Contains("limit: agent listener has no memory left for messages"));
  EXPECT_THAT(run.printed_by("listener"), Contains("alive"));
}

/// A receiver that has read its mail gets more.
TEST(SystemMemory, LetsMessagesInAgainOnceThereIsRoom) {
  MasOptions options;
  options.max_cycles = 100'000;
  options.max_agent_bytes = kMegabyte;
  const test::AgentRun run = test::run_agents(
      {{"teller",
        "!go(0). +!go(N) <- .send(listener, achieve, read); .send(listener, achieve, read); "
        "!go(N + 1). -!go(N) <- .print(full(N)); .wait(50); .send(listener, achieve, last)."},
       {"listener", "!wait. @w[atomic] +!wait <- .wait(10). +!read. +!last <- .print(last)."}},
      options);
  EXPECT_THAT(run.printed_by("teller"), Contains(HasSubstr("full(")));
  EXPECT_THAT(run.printed_by("listener"), Contains("last"));
}

std::vector<test::NamedProgram> hoarders(int count) {
  std::vector<test::NamedProgram> team;
  for (int i = 0; i < count; ++i) {
    team.push_back({"a" + std::to_string(i),
                    "!go(0). +!go(N) <- +b(N, f(N)); !go(N + 1). "
                    "-!go(N)[error_msg(M)] <- .print(M)."});
  }
  team.push_back({"modest", "!see(2000). +!see(0) <- .print(unharmed). +!see(N) <- !see(N - 1)."});
  return team;
}

TEST(SystemMemory, HoldsForAllAgentsTogether) {
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_agent_bytes = 8 * kMegabyte;
  options.max_system_bytes = kMegabyte;
  const test::AgentRun run = test::run_agents(hoarders(4), options);
  EXPECT_THAT(run.printed,
              Contains(HasSubstr("the memory limit of all agents together is reached")));
  EXPECT_THAT(run.printed_by("modest"), Contains("unharmed"));
  options.max_system_bytes = 64 * kMegabyte;
  EXPECT_THAT(test::run_agents(hoarders(4), options).printed,
              Not(Contains(HasSubstr("memory limit"))));
}

TEST(SystemMemory, NamesTheLimitThatEndsARun) {
  MasOptions options;
  options.max_system_bytes = kMegabyte;
  options.at_memory_limit = MasOptions::AtMemoryLimit::end_run;
  const RunOutcome outcome = test::run_agents(hoarders(4), options).outcome;
  EXPECT_EQ(outcome.limit, RunLimit::memory);
  EXPECT_THAT(outcome.message, HasSubstr("more memory than all agents together may have"));
}

TEST(SystemMemory, LetsNoAgentComeWhereNothingIsLeft) {
  test::System system;
  system.options.max_system_bytes = kMegabyte;
  system.provide("idle.asl", "quiet.");
  system.add("maker",
             "!go. +!go <- .create_agent(idle, \"idle.asl\"); !go. "
             "-!go[error_msg(M)] <- .print(M).");
  (void)system.run();
  EXPECT_THAT(system.printed,
              ElementsAre("[maker] the memory limit of all agents together is reached"));
  EXPECT_GT(system.mas->agent_count(), 100U);
}

/// Who fails, and when, does not depend on threads.
TEST(SystemMemory, IsSharedAlikeOnOneThreadAndOnSeveral) {
  const std::vector<test::NamedProgram> team = hoarders(6);
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_agent_bytes = kMegabyte;
  options.max_system_bytes = kMegabyte;
  options.fewest_beside = 2;
  const test::AgentRun one = test::run_agents(team, options);
  EXPECT_THAT(one.printed, Contains(HasSubstr("memory")));
  options.threads = 4;
  const test::AgentRun four = test::run_agents(team, options);
  EXPECT_THAT(four.printed, ElementsAreArray(one.printed));
  EXPECT_THAT(four.logged, ElementsAreArray(one.logged));
  EXPECT_EQ(four.outcome.cycles, one.outcome.cycles);
}

}  // namespace
}  // namespace jaywalk
