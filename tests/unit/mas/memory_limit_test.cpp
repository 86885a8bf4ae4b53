// SPDX-License-Identifier: Apache-2.0
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

/// Each makes new names, of this many letters and more.
std::vector<test::NamedProgram> namers(int count, int letters, const std::string& action) {
  std::vector<test::NamedProgram> team;
  for (int i = 0; i < count; ++i) {
    team.push_back({"n" + std::to_string(i),
                    "text(\"" + std::string(static_cast<std::size_t>(letters), 'a') +
                        "\"). !go(0).\n+!go(N) : text(T) <- .my_name(Me); .concat(T, Me, N, S); " +
                        action +
                        "; !go(N + 1).\n"
                        "-!go(N)[error_msg(M)] <- .print(N, M); .wait(10); !go(N + 1)."});
  }
  team.push_back({"modest", "!see(500). +!see(0) <- .print(unharmed). +!see(N) <- !see(N - 1)."});
  return team;
}

class Names : public testing::TestWithParam<const char*> {};

/// A name stays until the run is over, whoever still uses it.
TEST_P(Names, CountForAllAgentsTogether) {
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_agent_bytes = 8 * kMegabyte;
  options.max_system_bytes = kMegabyte / 2;
  for (const int letters : {1, 4000}) {
    const test::AgentRun run = test::run_agents(namers(2, letters, GetParam()), options);
    EXPECT_THAT(run.printed,
                Contains(HasSubstr("the memory limit of all agents together is reached")));
    EXPECT_THAT(run.printed_by("modest"), Contains("unharmed"));
  }
  options.max_cycles = 2000;
  options.max_system_bytes = 256 * kMegabyte;
  EXPECT_THAT(test::run_agents(namers(2, 4000, GetParam()), options).printed,
              Not(Contains(HasSubstr("memory limit"))));
}

INSTANTIATE_TEST_SUITE_P(OfTexts, Names,
                         testing::Values(".term2string(X, S)",
                                         ".concat(\"f(\", S, \")\", F); .term2string(X, F)",
                                         "X =.. [S, [1], []]",
                                         ".concat(\"+!\", S, \" <- true.\", P); .add_plan(P)"));

TEST(SystemMemory, HoldsForTheNamesOfOneTurn) {
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_agent_bytes = kMegabyte;
  const std::vector<std::string> printed = test::printed_by(
      "!grow(\"aaaaaaaa\", 0).\n"
      "+!grow(S, K) : K < 13 <- .concat(S, S, T); !grow(T, K + 1).\n"
      "+!grow(S, K) <- .term2string(X, S); .print(read).\n"
      "-!grow(S, K)[error_msg(M)] <- .print(M).",
      options);
  EXPECT_THAT(printed, Contains(HasSubstr("memory limit"))) << "64 kB may be 16,000 names";
}

/// Which agents fail, and when, does not depend on threads.
void expect_same_on_threads(const std::vector<test::NamedProgram>& team, MasOptions options) {
  options.fewest_parallel = 2;
  const test::AgentRun one = test::run_agents(team, options);
  EXPECT_THAT(one.printed, Contains(HasSubstr("memory"))) << "no limit is reached";
  for (const std::size_t threads : {2U, 8U}) {
    options.threads = threads;
    const test::AgentRun several = test::run_agents(team, options);
    EXPECT_THAT(several.printed, ElementsAreArray(one.printed)) << threads;
    EXPECT_THAT(several.logged, ElementsAreArray(one.logged)) << threads;
    EXPECT_EQ(several.outcome.cycles, one.outcome.cycles) << threads;
    EXPECT_EQ(several.outcome.message, one.outcome.message) << threads;
  }
}

TEST(SystemMemory, IsSharedAlikeOnOneThreadAndOnSeveral) {
  MasOptions options;
  options.max_cycles = 4000;
  options.max_agent_bytes = kMegabyte;
  options.max_system_bytes = kMegabyte;
  expect_same_on_threads(hoarders(6), options);
}

/// Many send long lists, none of which is a constant that they could share, to one another, who
/// reason, meanwhile, up to the limit.
std::vector<test::NamedProgram> correspondents(int count, int length) {
  std::vector<test::NamedProgram> team;
  for (int i = 0; i < count; ++i) {
    team.push_back(
        {"a" + std::to_string(i),
         "!begin. +!begin <- .findall(X, .range(X, 1, " + std::to_string(length) +
             "), L); !!go(0, L); !!hoard([], 0).\n"
             "+!go(N, L) <- .send(a" +
             std::to_string((i + 1) % count) + ", tell, got(N, L)); .send(a" +
             std::to_string((i + 3) % count) +
             ", tell, had(N, L)); !go(N + 1, L).\n"
             "-!go(N, L)[error_msg(M)] <- .print(N, M); .wait(5); !go(N + 1, L).\n"
             "+!hoard(T, N) <- .concat(T, T, [N, N], U); !hoard(U, N + 1).\n"
             "-!hoard(T, N)[error_msg(M)] <- .print(N, M); .wait(3); !hoard([], N + 1).\n"});
  }
  return team;
}

TEST(SystemMemory, IsTakenByNamesAlikeOnOneThreadAndOnSeveral) {
  MasOptions options;
  options.max_cycles = 600;
  options.max_agent_bytes = kMegabyte;
  options.max_system_bytes = kMegabyte / 2;
  expect_same_on_threads(namers(6, 200, ".term2string(X, S)"), options);
  options.max_system_bytes = 0;
  expect_same_on_threads(namers(6, 40'000, ".term2string(X, S)"), options);
}

/// Outboxes that are full, long before the round is over.
TEST(SystemMemory, HoldsBackNoMoreTextsThanItNeedsTo) {
  std::vector<test::NamedProgram> team;
  for (int i = 0; i < 12; ++i) {
    team.push_back({"a" + std::to_string(i),
                    "!go(x, 0). +!go(T, N) : N < 18 <- !go(t(T, T), N + 1). "
                    "+!go(T, _) <- .print(T); .send(a0, tell, done); .print(sent)."});
  }
  MasOptions options;
  options.fewest_parallel = 2;
  const test::AgentRun one = test::run_agents(team, options);
  EXPECT_EQ(one.printed.size(), 24U);
  options.threads = 3;
  const test::AgentRun three = test::run_agents(team, options);
  EXPECT_TRUE(three.printed == one.printed);
  EXPECT_EQ(three.outcome.cycles, one.outcome.cycles);
}

class Storms : public testing::TestWithParam<int> {};

TEST_P(Storms, AreTheSameOnOneThreadAndOnSeveral) {
  MasOptions options;
  options.max_cycles = 200;
  options.max_agent_bytes = kMegabyte;
  expect_same_on_threads(correspondents(8, GetParam()), options);
  options.max_system_bytes = 4 * kMegabyte;
  expect_same_on_threads(correspondents(8, GetParam()), options);
}

TEST_P(Storms, EndARunAtTheSamePlace) {
  MasOptions options;
  options.max_cycles = 200;
  options.max_agent_bytes = kMegabyte;
  options.at_memory_limit = MasOptions::AtMemoryLimit::end_run;
  options.fewest_parallel = 2;
  const auto team = correspondents(8, GetParam());
  const RunOutcome one = test::run_agents(team, options).outcome;
  EXPECT_EQ(one.limit, RunLimit::memory);
  options.threads = 4;
  const RunOutcome four = test::run_agents(team, options).outcome;
  EXPECT_EQ(four.message, one.message);
  EXPECT_EQ(four.cycles, one.cycles);
}

INSTANTIATE_TEST_SUITE_P(OfLists, Storms, testing::Values(10, 500, 3000));

}  // namespace
}  // namespace jaywalk
