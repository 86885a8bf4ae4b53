// SPDX-License-Identifier: Apache-2.0
// Summaries of agents that dropped intentions or never acted.

#include "experiment/compare/troubles.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/tables/tables.h"

namespace jaywalk {
namespace {

DropCause cause(std::string error, std::uint32_t line, std::string formula, std::uint64_t times) {
  return {.error = std::move(error),
          .file = line == 0 ? "" : "x.asl",
          .line = line,
          .column = line == 0 ? 0U : 3U,
          .formula = std::move(formula),
          .times = times};
}

/// Three agents: the second drops for two reasons, the third for one of them.
TestTroubles example(std::string formula) {
  return {.agents = 3,
          .pedestrians = 3,
          .idle = 1,
          .drops = {{2, cause("action_failed", 4, formula, 2)},
                    {2, cause("no_relevant", 0, "go", 1)},
                    {3, cause("action_failed", 4, formula + "x", 5)}}};
}

TEST(Troubles, CountEachAgentOnceAndEachCauseByItself) {
  TroublesSum sum;
  sum.add(0, example("a"));
  const Troubles all = sum.sum();
  EXPECT_EQ(all.agents, 3U);
  EXPECT_EQ(all.dropping, 2U);
  EXPECT_EQ(all.idle, 1U);
  ASSERT_EQ(all.causes.size(), 2U);
  EXPECT_EQ(all.causes[0].agents, 2U);
  EXPECT_EQ(all.causes[0].cause.times, 7U);
  EXPECT_EQ(all.causes[1].cause.error, "no_relevant");
}

TEST(Troubles, CountErroredTestsByWhatEndedThem) {
  TroublesSum sum;
  for (const std::uint64_t test : {9U, 4U, 6U}) sum.add(test, {.agents = 1, .error = "p1 loops"});
  sum.add(2, {.agents = 1, .error = "no answer"});
  const Troubles all = together(std::vector<Troubles>{sum.sum(), sum.sum()});
  EXPECT_EQ(all.errored, 8U);
  EXPECT_EQ(all.errors, (std::vector<SharedError>{{"p1 loops", 6, 4}, {"no answer", 2, 2}}));
}

TEST(Troubles, ShowTheFirstTestsExampleInWhateverOrderTestsCome) {
  std::vector<std::pair<std::uint64_t, std::string>> tests = {{0, "a"}, {1, "b"}, {2, "c"}};
  do {
    TroublesSum sum;
    for (const auto& [number, formula] : tests) sum.add(number, example(formula));
    const Troubles all = sum.sum();
    EXPECT_EQ(all.causes[0].cause.formula, "a");
    EXPECT_EQ(all.causes[0].agents, 6U);
    EXPECT_EQ(all.causes[0].cause.times, 21U);
    EXPECT_EQ(all.dropping, 6U);
  } while (std::next_permutation(tests.begin(), tests.end()));
}

TEST(Troubles, OfGoalsFromNowhereAreToldApartByTheGoal) {
  TroublesSum sum;
  sum.add(0,
          {.agents = 1,
           .pedestrians = 1,
           .drops = {{1, cause("no_relevant", 0, "a", 1)}, {1, cause("no_relevant", 0, "b", 1)}}});
  EXPECT_EQ(sum.sum().causes.size(), 2U);
  EXPECT_EQ(sum.sum().dropping, 1U);
}

Comparison compared(std::vector<std::pair<std::string, TestTroubles>> rows) {
  Comparison comparison;
  for (auto& [behaviour, troubles] : rows) {
    TroublesSum sum;
    sum.add(0, troubles);
    comparison.summaries.push_back({.behaviour = behaviour});
    comparison.troubles.push_back(sum.sum());
  }
  return comparison;
}

TEST(Troubles, AreToldOfEachBehaviourThatHasAny) {
  const auto found = troubles_of(compared({{"fine", {.agents = 3, .pedestrians = 3}},
                                           {"bad", example("move(rigth)")},
                                           {"bad", example("move(rigth)")}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(is_troubled(found));
  EXPECT_EQ(render_troubles(found),
            "What happened to agents (in all tests together)\n"
            "  bad: 2 of 6 agents never acted\n"
            "  bad: 4 of 6 agents dropped an intention\n"
            "    4 agents: action_failed, x.asl:4:3, move(rigth)\n"
            "    2 agents: no_relevant, go\n");
  EXPECT_EQ(render_troubles({}), "");
}

TEST(Troubles, OfSomeWhoAreIdleAreNoneForStrictness) {
  const auto some = troubles_of(compared({{"b", {.agents = 2, .pedestrians = 2, .idle = 1}}}));
  ASSERT_EQ(some.size(), 1U);
  EXPECT_FALSE(is_troubled(some));
  const auto all = troubles_of(compared({{"b", {.agents = 2, .pedestrians = 2, .idle = 2}}}));
  EXPECT_TRUE(is_troubled(all));
  EXPECT_THAT(render_troubles(all), ::testing::HasSubstr("b: its agents never acted"));
}

}  // namespace
}  // namespace jaywalk
