// SPDX-License-Identifier: Apache-2.0
// A system on several threads does what it does on one, to the byte.

#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/generate.h"
#include "tests/helpers/run_agents.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using test::TestWorld;

/// What can be seen of a run.
struct Seen {
  std::vector<std::string> printed;
  std::vector<std::string> logged;
  RunEnd end = RunEnd::idle;
  std::uint64_t cycles = 0;
  std::uint64_t ticks = 0;
  std::string message;
  double now_ms = 0;

  friend bool operator==(const Seen&, const Seen&) = default;
};

std::ostream& operator<<(std::ostream& out, const Seen& seen) {
  return out << fmt::format("end {}, {} cycles, {} ticks, {} ms, '{}'\n",
                            static_cast<int>(seen.end), seen.cycles, seen.ticks, seen.now_ms,
                            seen.message)
             << testing::PrintToString(seen.printed) << testing::PrintToString(seen.logged);
}

struct Member {
  std::string name;
  std::string program;
};

struct Team {
  std::vector<Member> members;
  bool in_world = false;
  MasOptions options = {};
};

Seen run(const Team& team, std::size_t threads) {
  MasOptions options = team.options;
  options.threads = threads;
  options.fewest_parallel = 2;
  options.max_cycles = options.max_cycles == 0 ? 2000 : options.max_cycles;
  System system(options);
  for (const Member& member : team.members) system.add(member.name, member.program);
  system.provide("child.asl", "!c. +!c <- .my_name(Me); .print(Me); .broadcast(tell, born(Me)).");
  TestWorld world(*system.symbols, 5);
  const RunOutcome outcome = system.run(team.in_world ? &world : nullptr);
  std::vector<std::string> printed = system.printed;
  printed.insert(printed.end(), world.history.begin(), world.history.end());
  return {printed,       system.logged,   outcome.end,         outcome.cycles,
          outcome.ticks, outcome.message, system.mas->now_ms()};
}

void expect_same_on_threads(const Team& team) {
  const Seen alone = run(team, 1);
  for (const std::size_t threads : {2U, 4U, 8U}) EXPECT_EQ(run(team, threads), alone) << threads;
}

std::vector<Member> crowd(int count, const std::string& program) {
  std::vector<Member> members;
  for (int i = 0; i < count; ++i) members.push_back({fmt::format("a{}", i), program});
  return members;
}

constexpr std::string_view kTalker = R"(
  +!start : .my_name(Me) <- .random(R); .print("begins ", R); .broadcast(tell, hello(Me, R, _));
     .wait(10); .count(hello(_, _, _), N); .print("knows ", N).
  +hello(Who, R, X) : R > 0.7 <- .print(Who, " says ", X); .send(Who, achieve, thanks(_)).
  +!thanks(X)[source(Who)] <- .print("thanks from ", Who, " for ", X).
  !start.
)";

TEST(Threads, DoNotChangeWhatIsPrinted) {
  expect_same_on_threads({.members = crowd(20, std::string(kTalker))});
  EXPECT_GT(run({.members = crowd(20, std::string(kTalker))}, 4).printed.size(), 60U);
}

TEST(Threads, DoNotChangeWhatHappensInAWorld) {
  expect_same_on_threads(
      {.members = crowd(12, std::string(kTalker) + "+tick(N) <- .print(N); go; refuse. "
                                                   "-!G <- .print(no). -tick(N) <- stay."),
       .in_world = true});
}

TEST(Threads, EndARunWhereTheFirstAgentEndsIt) {
  Team team{.members = crowd(9, "!s(0). +!s(N) <- .print(N); !s(N + 1).")};
  team.members[4].program = "!s(0). +!s(3) <- .print(stop); .stopMAS. +!s(N) <- !s(N + 1).";
  team.members[7].program = team.members[4].program;
  expect_same_on_threads(team);
  const Seen seen = run(team, 4);
  EXPECT_EQ(seen.end, RunEnd::stopped);
  EXPECT_EQ(seen.printed.back(), "[a3] 2");  // those behind a4 had no turn any more
}

TEST(Threads, StopAtTheSameLimit) {
  Team team{.members = crowd(9, "!s(0). +!s(N) <- !s(N + 1).")};
  team.options.max_cycles = 100;
  expect_same_on_threads(team);
  EXPECT_EQ(run(team, 4).message, "agent a0 reached the limit of 100 cycles");
}

// Such agents take many steps in a row; their warnings come as if they took turns.
TEST(Threads, DoNotChangeWhatAgentsThatKeepToThemselvesLog) {
  Team team;
  for (int i = 0; i < 30; ++i) {
    team.members.push_back(
        {fmt::format("a{}", i),
         fmt::format("!s(0). +!s(N) : N < {} <- +b(N); !!odd(N mod 7); !s(N + 1). +!s(_). "
                     "+!odd(N) : N < 5.",
                     20 + i)});
  }
  expect_same_on_threads(team);
  EXPECT_GT(run(team, 4).logged.size(), 100U);
  team.members[7].program = "!s(0). +!s(N) <- !s(N + 1).";
  team.options.max_cycles_per_tick = 70;
  expect_same_on_threads(team);
  EXPECT_EQ(run(team, 4).end, RunEnd::looping);
}

TEST(Threads, LetAgentsComeAndGoInTheirTurn) {
  Team team{.members = crowd(10, std::string(kTalker))};
  team.members[3].program += "!c. +!c <- .create_agent(kid, \"child.asl\"); .send(kid, tell, x).";
  team.members[6].program += "!k. +!k <- .kill_agent(a8); .all_names(L); .print(L).";
  team.members[7].program += "!k. +!k <- .df_search(s, L); .print(L); .wait(1); .clone(twin).";
  team.members[2].program += "!k. +!k <- .df_register(s).";
  expect_same_on_threads(team);
}

TEST(Threads, DoNotRunWhatOthersSendWhereItConcernsAll) {
  Team team{.members = crowd(8, "+do(X) <- X; .all_names(L); .print(L).")};
  team.members[1].program = "!s. +!s <- .broadcast(tell, do({ .create_agent(kid) })).";
  expect_same_on_threads(team);
  Team teachers{.members = crowd(8, "!g. +!g <- .wait(5); !new. -!g <- .print(cannot).")};
  teachers.members[0].program =
      "!s. +!s <- .broadcast(tellHow, \"+!new <- .create_agent(kid); .all_names(L); .print(L).\").";
  expect_same_on_threads(teachers);
}

// Programs of all that the language has; what they send and believe meets.
TEST(Threads, DoNotChangeWhatRandomProgramsDo) {
  std::size_t printed = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    test::Choices choices(seed);
    std::vector<test::NamedProgram> team;
    const std::size_t size = 3 + choices.below(4);
    while (team.size() < size) {
      const std::string program = test::random_program(choices) + std::string(kTalker);
      const std::string name = fmt::format("a{}", team.size());
      if (test::run_agents({{name, program}}, {.max_cycles = 1}).errors.empty()) {
        team.push_back({name, program});
      }
    }
    MasOptions options{.seed = seed, .max_cycles = 100, .max_inferences = 2'000};
    options.fewest_parallel = 2;
    test::EnvironmentMaker world;
    if (choices.once_in(3)) {
      world = [](SymbolTable& symbols) { return std::make_unique<TestWorld>(symbols, 5); };
    }
    const test::AgentRun alone = test::run_agents(team, options, world);
    printed += alone.printed.size();
    for (const std::size_t threads : {2U, 4U, 8U}) {
      options.threads = threads;
      const test::AgentRun beside = test::run_agents(team, options, world);
      ASSERT_EQ(beside.printed, alone.printed) << "seed " << seed << ", threads " << threads;
      ASSERT_EQ(beside.logged, alone.logged) << "seed " << seed << ", threads " << threads;
      ASSERT_EQ(beside.outcome.cycles, alone.outcome.cycles) << "seed " << seed;
      ASSERT_EQ(beside.outcome.message, alone.outcome.message) << "seed " << seed;
    }
  }
  EXPECT_GT(printed, 100U);  // else this has tested nothing
}

}  // namespace
}  // namespace jaywalk
