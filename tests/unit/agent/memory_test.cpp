// SPDX-License-Identifier: Apache-2.0
// Agents that run for long need no more memory than those that run for short.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;

/// Enough for any of these programs, too little for what they throw away.
constexpr std::uint64_t kSmallHeap = 1U << 20U;

std::vector<std::string> run_in_little_memory(std::string_view program) {
  MasOptions options;
  options.max_agent_bytes = kSmallHeap;
  options.max_cycles = 2'000'000;
  return test::printed_by(program, options);
}

TEST(AgentMemory, DoesNotGrowWithTailRecursion) {
  EXPECT_THAT(run_in_little_memory("!count(200000). +!count(0) <- .print(done). "
                                   "+!count(N) <- !count(N - 1)."),
              ElementsAre("done"));
}

TEST(AgentMemory, DoesNotGrowWithTailRecursionThatReturns) {
  // Each level leaves a link from its result to that of the level below.
  EXPECT_THAT(run_in_little_memory("!a. +!a <- !count(10000, 0, R); .print(R). +!count(0, S, S). "
                                   "+!count(N, S, R) <- !count(N - 1, S + 1, R)."),
              ElementsAre("10000"));
}

TEST(AgentMemory, DoesNotGrowWithALoop) {
  EXPECT_THAT(run_in_little_memory("n(0). !a. +!a <- while (n(X) & X < 20000) "
                                   "{ Y = [X, f(X), \"text\"]; -+n(X + 1) }; .print(done)."),
              ElementsAre("done"));
}

TEST(AgentMemory, DoesNotGrowWithBeliefsThatComeAndGo) {
  EXPECT_THAT(run_in_little_memory("!a(20000). +!a(0) <- .count(b(_), N); .print(N). "
                                   "+!a(N) <- +b(N); -b(N); !a(N - 1)."),
              ElementsAre("0"));
}

TEST(AgentMemory, DoesNotGrowWithIntentionsThatEnd) {
  EXPECT_THAT(run_in_little_memory("!a(20000). +!a(0) <- .print(done). +!a(N) <- !!b(N); "
                                   "!a(N - 1). +!b(N) <- X = [N, N]."),
              ElementsAre("done"));
}

TEST(AgentMemory, DoesNotGrowWithMessages) {
  EXPECT_THAT(run_in_little_memory("!a(10000). +!a(0) <- .print(done). "
                                   "+!a(N) <- .send(agent, achieve, a(N - 1))."),
              ElementsAre("done"));
}

TEST(AgentMemory, DoesNotGrowWithFailures) {
  EXPECT_THAT(run_in_little_memory("!a(5000). +!a(0) <- .print(done). "
                                   "+!a(N) <- !fails(N); !a(N - 1). +!fails(_) <- .fail. "
                                   "-!fails(_)."),
              ElementsAre("done"));
}

TEST(AgentMemory, DoesNotGrowWithQueries) {
  EXPECT_THAT(run_in_little_memory("!a. loop(0). loop(N) :- N > 0 & .length([N, N], L) & "
                                   "loop(N - 1). +!a <- ?loop(2000); .print(done)."),
              ElementsAre("done"));
}

TEST(AgentMemory, KeepsWhatIsStillNeeded) {
  EXPECT_THAT(run_in_little_memory(R"(
      !a.
      +!a <- K = kept([1, 2], "text", X); +b(K); !busy(20000); .print(K); ?b(B); X = 7; .print(B).
      +!busy(0).
      +!busy(N) <- Y = [N, f(N), "garbage"]; !busy(N - 1).
      )"),
              ElementsAre("kept([1,2],\"text\",X)", ::testing::StartsWith("kept([1,2],\"text\",")));
}

}  // namespace
}  // namespace jaywalk
