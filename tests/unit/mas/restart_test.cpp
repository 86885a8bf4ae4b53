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

}  // namespace
}  // namespace jaywalk
