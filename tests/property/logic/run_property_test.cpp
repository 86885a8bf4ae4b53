// SPDX-License-Identifier: Apache-2.0
// Laws of whole runs, over generated programs.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/helpers/generate.h"
#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

MasOptions small_run(std::uint64_t seed) {
  MasOptions options;
  options.seed = seed;
  options.max_cycles = 300;
  options.max_inferences = 20'000;
  options.max_agent_bytes = 4U << 20U;
  return options;
}

TEST(RunProperty, TheSameSeedGivesTheSameRun) {
  std::size_t printing = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Choices choices(seed);
    const std::string program = test::random_program(choices) +
                                "\n!r. +!r <- .random(V); .print(V); .random([1,2,3,4],W); "
                                ".print(W).\n";
    const test::AgentRun one = test::run_agents({{"agent", program}}, small_run(seed));
    const test::AgentRun two = test::run_agents({{"agent", program}}, small_run(seed));
    ASSERT_EQ(one.errors, two.errors) << "seed " << seed << "\n" << program;
    ASSERT_EQ(one.printed, two.printed) << "seed " << seed << "\n" << program;
    ASSERT_EQ(one.logged, two.logged) << "seed " << seed << "\n" << program;
    ASSERT_EQ(one.outcome.cycles, two.outcome.cycles) << "seed " << seed << "\n" << program;
    printing += one.printed.empty() ? 0 : 1;
  }
  EXPECT_GT(printing, 30U);  // else this has tested nothing
}

TEST(RunProperty, AnotherSeedDrawsOtherNumbers) {
  const std::string program = "!r. +!r <- .random(V); .print(V).";
  EXPECT_NE(test::printed_by(program, small_run(1)), test::printed_by(program, small_run(2)));
}

}  // namespace
}  // namespace jaywalk
