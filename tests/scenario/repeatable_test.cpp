// SPDX-License-Identifier: Apache-2.0
// A test is a pure function of the scenario and its setup: the order of tests, the thread and
// what ran before do not matter.

#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include <gtest/gtest.h>

#include "scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::behaviour;
using testing_scenario::paper;

struct RunSummary {
  bool success = false;
  int ticks = 0;
  double score = 0;
  std::uint64_t cycles = 0;

  friend bool operator==(const RunSummary&, const RunSummary&) = default;
};

using Key = std::pair<std::size_t, std::uint64_t>;

std::map<Key, RunSummary> run_all(const PreparedScenario& prepared, const std::vector<Key>& order) {
  std::map<Key, RunSummary> results;
  for (const auto& [index, test] : order) {
    const TestRun result =
        run_test(prepared, {.behaviour = index, .agents = 4, .seed = 9, .test = test});
    results[{index, test}] = {result.outcome.success, result.outcome.ticks, result.outcome.score(),
                              result.cycles};
  }
  return results;
}

std::vector<Key> all_trials(const PreparedScenario& prepared) {
  std::vector<Key> order;
  for (std::size_t index = 0; index < prepared.behaviours().size(); ++index) {
    for (std::uint64_t test = 0; test < 10; ++test) order.emplace_back(index, test);
  }
  return order;
}

TEST(TestRuns, GiveTheSameResultsInAnyOrder) {
  const auto prepared = paper();
  const std::vector<Key> order = all_trials(*prepared);
  const std::vector<Key> backwards(order.rbegin(), order.rend());
  EXPECT_EQ(run_all(*prepared, order), run_all(*prepared, backwards));
}

TEST(TestRuns, GiveTheSameResultsOnSeveralThreads) {
  const auto prepared = paper();
  const std::vector<Key> order = all_trials(*prepared);
  const std::map<Key, RunSummary> alone = run_all(*prepared, order);
  std::map<Key, RunSummary> beside;
  std::thread thread([&] { beside = run_all(*prepared, order); });
  const std::map<Key, RunSummary> again = run_all(*prepared, order);
  thread.join();
  EXPECT_EQ(beside, alone);
  EXPECT_EQ(again, alone);
}

// Their memory has been used by other tests before, other behaviours, and more agents.
TEST(TestRuns, GiveTheSameResultsWhereOneRunnerRunsAll) {
  for (const std::string name : {"paper", "traffic", "zebra", "features", "team", "negotiation"}) {
    Result<Scenario> read =
        read_scenario(testing_scenario::project_file("scenarios/" + name + ".yaml"));
    ASSERT_TRUE(read.ok()) << read.diagnostics().render();
    Diagnostics warnings;
    const auto prepared = PreparedScenario::prepare(std::move(read).value(), warnings);
    ASSERT_TRUE(prepared.ok()) << prepared.diagnostics().render();
    TestRunner runner(*prepared.value());
    for (std::uint64_t test = 0; test < 6; ++test) {
      for (std::size_t index = 0; index < prepared.value()->behaviours().size(); ++index) {
        const TestSetup setup{
            .behaviour = index, .agents = test % 3 == 2 ? 7U : 4U, .seed = 9, .test = test / 2};
        Recording alone;
        Recording again;
        const TestRun expected = run_test(*prepared.value(), setup, {.record = &alone});
        const TestRun result = runner.run(setup, {.record = &again});
        ASSERT_EQ(again, alone) << name << ", behaviour " << index << ", test " << test;
        ASSERT_EQ(result.cycles, expected.cycles);
        ASSERT_EQ(result.message, expected.message);
        ASSERT_EQ(result.outcome.score(), expected.outcome.score());
      }
    }
  }
}

TEST(TestRuns, DependOnTheSeedAndTheTest) {
  const Scenario scenario;
  const std::vector<Position> first = start_cells(scenario, {.agents = 5, .seed = 1, .test = 0});
  EXPECT_NE(first, start_cells(scenario, {.agents = 5, .seed = 2, .test = 0}));
  EXPECT_NE(first, start_cells(scenario, {.agents = 5, .seed = 1, .test = 1}));
}

TEST(TestRuns, StartAllBehavioursAlike) {
  const auto prepared = paper();
  std::vector<std::vector<Position>> starts;
  for (std::size_t index = 0; index < prepared->behaviours().size(); ++index) {
    CrossingResult result;
    (void)run_test(*prepared, {.behaviour = index, .agents = 6, .seed = 2, .test = 7},
                   {.observe = testing_scenario::observing(result)});
    starts.push_back(result.start);
  }
  for (const std::vector<Position>& start : starts) EXPECT_EQ(start, starts[0]);
}

TEST(TestRuns, RunAlikeFromStartCellsThatWereWrittenAndRead) {
  const auto drawn = paper();
  const std::string file = testing::TempDir() + "jaywalk_starts.csv";
  std::ofstream(file) << print_start_cells(start_cells(drawn->scenario(), 3, 5, 10));
  ScenarioOptions options;
  options.sets = {"world.spawn.cells=" + file, "world.spawn.choose=cell"};
  const auto read = paper(options);
  std::filesystem::remove(file);
  ASSERT_NE(read, nullptr);
  for (std::uint64_t test = 0; test < 10; ++test) {
    const TestSetup setup{.behaviour = 0, .agents = 3, .seed = 5, .test = test};
    CrossingResult expected;
    CrossingResult result;
    (void)run_test(*drawn, setup, {.observe = testing_scenario::observing(expected)});
    (void)run_test(*read, setup, {.observe = testing_scenario::observing(result)});
    EXPECT_EQ(result.start, expected.start);
    EXPECT_EQ(result.score(), expected.score());
  }
  EXPECT_NE(problem(*read, {.behaviour = 0, .agents = 3, .seed = 5, .test = 10}), "");
}

TEST(TestRuns, SayWhyTheyCannotRun) {
  const auto prepared = testing_scenario::paper_from({{1, 20}});
  EXPECT_EQ(problem(*prepared, {.agents = 1}), "");
  EXPECT_EQ(problem(*prepared, {.agents = 0}), "a test needs at least one agent");
  EXPECT_EQ(problem(*prepared, {.agents = 2}),
            "test 0 has fewer than 2 start cells in the scenario's file");
  EXPECT_EQ(problem(*prepared, {.behaviour = 7, .agents = 1}), "there is no behaviour 7, only 7");
}

}  // namespace
}  // namespace jaywalk
