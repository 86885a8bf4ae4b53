// SPDX-License-Identifier: Apache-2.0
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/comparison_files.h"
#include "experiment/results/reader.h"
#include "experiment/results/writer.h"
#include "tests/unit/experiment_results/experiment_runs.h"

namespace jaywalk {
namespace {

std::unique_ptr<ResultsReader> open(const std::string& path) {
  auto reader = ResultsReader::open(path);
  EXPECT_TRUE(reader.ok()) << reader.diagnostics().render();
  return std::move(reader).value();
}

TEST_F(StoreTest, GivesBackWhatItWasGiven) {
  write(file("a.gpkg"), description(StoreLevel::all), cases());
  const auto store = open(file("a.gpkg"));
  EXPECT_TRUE(store->complete());
  const std::vector<StoredTest> tests = store->tests().value();
  ASSERT_EQ(tests.size(), cases().size());
  for (const StoredTest& stored : tests) {
    const TestRecord wanted = run(stored.test);
    EXPECT_EQ(stored.result.succeeded, wanted.result.succeeded);
    EXPECT_EQ(stored.result.ticks, wanted.result.ticks);
    EXPECT_EQ(stored.result.score, wanted.result.score);
    EXPECT_EQ(stored.result.cpu_us, wanted.result.cpu_us);
    EXPECT_EQ(stored.result.wall_us, wanted.result.wall_us);
    EXPECT_GT(stored.scenes, 0U);
    EXPECT_EQ(store->scores(stored.id).value(), wanted.scores);
    EXPECT_EQ(store->recording(stored.id).value(), wanted.recording);
  }
}

TEST_F(StoreTest, DescribesItsExperiment) {
  const ExperimentDescription wanted = description(StoreLevel::summary, {.index = 2, .count = 3});
  write(file("a.gpkg"), wanted, {});
  const ExperimentDescription found = open(file("a.gpkg"))->description();
  EXPECT_EQ(difference(found, wanted), "");
  EXPECT_EQ(found.level, wanted.level);
  EXPECT_EQ(found.shard, wanted.shard);
  EXPECT_EQ(found.behaviour_options, wanted.behaviour_options);
  EXPECT_EQ(found.behaviours[1].code_lines, wanted.behaviours[1].code_lines);
  EXPECT_EQ(found.behaviours[0].parameters, wanted.behaviours[0].parameters);
}

TEST_F(StoreTest, KeepsTheScenesThatItsLevelSays) {
  for (const StoreLevel level : {StoreLevel::summary, StoreLevel::found, StoreLevel::all}) {
    const std::string path = file(std::string(name(level)) + ".gpkg");
    write(path, description(level), cases());
    int successes = 0;
    const auto store = open(path);
    const std::vector<StoredTest> tests = store->tests().value();
    for (const StoredTest& test : tests) {
      const bool wanted =
          level == StoreLevel::all || (level == StoreLevel::found && test.result.succeeded);
      EXPECT_EQ(test.scenes > 0, wanted) << name(level) << " " << test.id;
      successes += test.result.succeeded ? 1 : 0;
    }
    EXPECT_THAT(successes, testing::AllOf(testing::Gt(0), testing::Lt(48)));
  }
}

TEST_F(StoreTest, RunsATestAgainWhereItHasNoScenes) {
  write(file("a.gpkg"), description(StoreLevel::summary), cases());
  const auto store = open(file("a.gpkg"));
  for (const std::int64_t id : {1, 20, 48}) {
    const TestKey test = store->test(id).value().test;
    EXPECT_EQ(store->recording(id).value(), run(test).recording);
  }
}

TEST_F(StoreTest, NeedsNoFilesToRunATestAgain) {
  ExperimentDescription moved = description(StoreLevel::summary);
  const auto elsewhere = [](std::string& path) {
    const std::string root = JAYWALK_SOURCE_DIR;
    ASSERT_TRUE(path.starts_with(root)) << path;
    path = "/no/such/folder" + path.substr(root.size());
  };
  elsewhere(moved.scenario);
  for (StoredInput& input : moved.inputs) elsewhere(input.path);
  write(file("a.gpkg"), moved, cases());
  const auto store = open(file("a.gpkg"));
  EXPECT_EQ(store->recording(30).value(), run(store->test(30).value().test).recording);
}

TEST_F(StoreTest, SeesThatATestComesOutOtherwise) {
  ExperimentDescription changed = description(StoreLevel::summary);
  changed.sets = {"world.av.speed=3"};
  write(file("a.gpkg"), changed, cases());
  const auto store = open(file("a.gpkg"));
  EXPECT_EQ(message_of(store->recording(2)), "test 2 came out otherwise than stored");
}

TEST_F(StoreTest, SelectsTests) {
  write(file("a.gpkg"), description(), cases());
  const auto store = open(file("a.gpkg"));
  EXPECT_EQ(store->tests({.behaviour = 1, .agents = 3}).value().size(), 12U);
  EXPECT_EQ(store->tests({.limit = 5}).value().size(), 5U);
  const auto found = store->tests({.behaviour = 0, .succeeded = true}).value();
  const auto missed = store->tests({.behaviour = 0, .succeeded = false}).value();
  EXPECT_EQ(found.size() + missed.size(), 24U);
  for (const StoredTest& test : found) EXPECT_TRUE(test.result.succeeded);
  EXPECT_EQ(message_of(store->test(49)), "the store has no test 49");
}

TEST_F(StoreTest, IsContinuedWhereItWasLeft) {
  const std::vector<TestKey> all = cases();
  write(file("whole.gpkg"), description(), all);
  write(file("parts.gpkg"), description(), {all.begin() + 10, all.begin() + 23});
  EXPECT_FALSE(open(file("parts.gpkg"))->complete());
  {
    auto writer = ResultsWriter::resume(file("parts.gpkg"), description());
    EXPECT_EQ(writer.value()->had(), 13U);
    EXPECT_TRUE(writer.value()->had(all[10]));
    EXPECT_FALSE(writer.value()->had(all[9]));
    EXPECT_FALSE(writer.value()->had(all[23]));
  }
  write(file("parts.gpkg"), description(), all);
  const auto whole = open(file("whole.gpkg"));
  const auto parts = open(file("parts.gpkg"));
  EXPECT_TRUE(parts->complete());
  EXPECT_EQ(to_csv(parts->comparison().value()), to_csv(whole->comparison().value()));
  for (std::int64_t id = 1; id <= 48; ++id) {
    EXPECT_EQ(parts->recording(id).value(), whole->recording(id).value());
  }
}

TEST_F(StoreTest, SumsUpAsAnExperimentDoes) {
  write(file("a.gpkg"), description(), cases());
  const ExperimentOutcome direct = run_experiment(
      plan_, [&](const TestKey& test) -> Result<TestResult> { return run(test).result; },
      [](const Progress&) { return Proceed::yes; });
  const Comparison comparison = open(file("a.gpkg"))->comparison().value();
  ASSERT_EQ(comparison.summaries.size(), direct.summaries.size());
  for (std::size_t i = 0; i < direct.summaries.size(); ++i) {
    EXPECT_EQ(comparison.summaries[i].behaviour, direct.summaries[i].behaviour);
    EXPECT_EQ(comparison.summaries[i].score.mean, direct.summaries[i].score.mean);
    EXPECT_EQ(comparison.summaries[i].score.squares, direct.summaries[i].score.squares);
    EXPECT_EQ(comparison.summaries[i].cpu_us.squares, direct.summaries[i].cpu_us.squares);
  }
}

TEST_F(StoreTest, TakesTestsFromManyThreadsAtOnce) {
  write(file("one.gpkg"), description(), cases());
  auto writer = ResultsWriter::create(file("many.gpkg"), description());
  ASSERT_TRUE(writer.ok());
  const std::vector<TestKey> all = cases();
  {
    std::vector<std::jthread> threads;
    for (std::size_t first = 0; first < 8; ++first) {
      threads.emplace_back([&, first] {
        for (std::size_t i = first; i < all.size(); i += 8) writer.value()->add(run(all[i]));
      });
    }
  }
  EXPECT_EQ(writer.value()->finish(), std::nullopt);
  EXPECT_EQ(to_csv(open(file("many.gpkg"))->comparison().value()),
            to_csv(open(file("one.gpkg"))->comparison().value()));
}

TEST_F(StoreTest, KeepsAssessmentsAndReplacesThem) {
  const std::vector<AssessmentRow> first = {
      {.id = "min_distance", .value = 0.25, .tick = 7, .actor = 2},
      {.id = "A1", .tick = 3, .robustness = -HUGE_VAL, .verdict = StoredVerdict::fail}};
  TestRecord record = run(cases().front());
  record.assessments = first;
  {
    auto writer = ResultsWriter::create(file("a.gpkg"), description());
    writer.value()->add(std::move(record));
    EXPECT_EQ(writer.value()->finish(), std::nullopt);
  }
  EXPECT_EQ(open(file("a.gpkg"))->assessments(1).value(), first);
  const AssessmentRow again{.id = "A1", .robustness = 1, .verdict = StoredVerdict::pass};
  {
    auto writer = AssessmentWriter::open(file("a.gpkg"));
    ASSERT_TRUE(writer.ok());
    writer.value()->replace(1, {again});
    EXPECT_EQ(writer.value()->finish(), std::nullopt);
  }
  EXPECT_THAT(open(file("a.gpkg"))->assessments(1).value(),
              testing::ElementsAre(first.front(), again));
}

}  // namespace
}  // namespace jaywalk
