// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/experiment_results/experiment_runs.h"

#include <unistd.h>

#include "experiment/results/writer.h"

namespace jaywalk {
namespace {

constexpr std::uint64_t kSeed = 5;

ScenarioOptions options() { return {.behaviours = {"proximity", "random_action"}}; }

}  // namespace

StoreTest::StoreTest()
    : folder_(std::filesystem::path(testing::TempDir()) /
              ("jaywalk_store_" + std::to_string(::getpid()))) {
  std::filesystem::create_directories(folder_);
  auto scenario = read_scenario(JAYWALK_SOURCE_DIR "/scenarios/paper.yaml", options());
  Diagnostics warnings;
  prepared_ = PreparedScenario::prepare(std::move(scenario).value(), warnings).value();
  plan_ = {.behaviours = {"proximity", "random_action"}, .agents = {1, 3}, .tests = 12};
}

StoreTest::~StoreTest() { std::filesystem::remove_all(folder_); }

ExperimentDescription StoreTest::description(StoreLevel level, Shard shard) const {
  ExperimentDescription description = describe(*prepared_, options(), plan_, kSeed);
  description.level = level;
  description.shard = shard;
  return description;
}

std::vector<TestKey> StoreTest::cases() const {
  std::vector<TestKey> tests;
  for (std::size_t behaviour = 0; behaviour < plan_.behaviours.size(); ++behaviour) {
    for (const std::uint32_t agents : plan_.agents) {
      for (std::uint64_t number = 0; number < plan_.tests; ++number) {
        tests.push_back({.behaviour = behaviour, .agents = agents, .number = number});
      }
    }
  }
  return tests;
}

TestRecord StoreTest::run(const TestKey& test) const {
  Recording recording;
  const TestSetup setup{
      .behaviour = test.behaviour, .agents = test.agents, .seed = kSeed, .test = test.number};
  const TestRun run = run_test(*prepared_, setup, {.record = &recording});
  const TestResult result{.succeeded = run.outcome.success,
                          .ticks = static_cast<std::uint32_t>(run.outcome.ticks),
                          .score = run.outcome.score(),
                          .cpu_us = 0.5 + static_cast<double>(test.number),
                          .wall_us = 1.0 / 3};
  return make_test_record(test, result, run, std::move(recording));
}

void StoreTest::write(const std::string& path, const ExperimentDescription& description,
                      const std::vector<TestKey>& tests) const {
  auto writer = ResultsWriter::resume(path, description);
  ASSERT_TRUE(writer.ok()) << writer.diagnostics().render();
  for (const TestKey& test : tests) {
    if (!writer.value()->had(test)) writer.value()->add(run(test));
  }
  EXPECT_EQ(writer.value()->finish(), std::nullopt);
}

}  // namespace jaywalk
