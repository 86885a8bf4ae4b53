// SPDX-License-Identifier: Apache-2.0
#include "experiment/run/run_comparison.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/results/reader.h"
#include "tests/unit/experiment_results/experiment_runs.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RunComparison : public StoreTest {
 protected:
  /// The small experiment, judged by the rules of the crossing.
  [[nodiscard]] ComparisonRequest request() const {
    ComparisonRequest request = comparison_request(prepared_);
    request.options = {.behaviours = plan_.behaviours};
    request.plan.agents = plan_.agents;
    request.plan.tests = plan_.tests;
    auto rules =
        read_assertion_files({JAYWALK_SOURCE_DIR "/scenarios/assertions/crossing.yaml"}).value();
    request.criteria = {.assertions = rules.assertions, .metrics = true, .files = rules.sources};
    return request;
  }

  [[nodiscard]] ComparisonRequest stored_request(StoreOptions store) const {
    ComparisonRequest request = this->request();
    request.store = std::move(store);
    return request;
  }
};

ComparisonResults results_of(const ComparisonRequest& request, const ComparisonHooks& hooks = {}) {
  auto results = run_comparison(request, hooks);
  EXPECT_TRUE(results.ok()) << results.diagnostics().render();
  return std::move(results).value();
}

/// What does not depend on the time that tests take.
void expect_alike(const Comparison& left, const Comparison& right) {
  EXPECT_EQ(left.complete, right.complete);
  EXPECT_EQ(left.assertions, right.assertions);
  ASSERT_EQ(left.summaries.size(), right.summaries.size());
  ASSERT_EQ(left.assessments.size(), right.assessments.size());
  for (std::size_t row = 0; row < left.summaries.size(); ++row) {
    EXPECT_EQ(left.summaries[row].behaviour, right.summaries[row].behaviour);
    EXPECT_EQ(left.summaries[row].agents, right.summaries[row].agents);
    EXPECT_EQ(left.summaries[row].tests, right.summaries[row].tests);
    EXPECT_EQ(left.summaries[row].successes, right.summaries[row].successes);
    EXPECT_EQ(left.summaries[row].ticks_all.mean, right.summaries[row].ticks_all.mean);
    EXPECT_EQ(left.summaries[row].score.mean, right.summaries[row].score.mean);
    EXPECT_EQ(left.summaries[row].code_lines, right.summaries[row].code_lines);
    for (std::size_t i = 0; i < left.assertions.size(); ++i) {
      EXPECT_EQ(left.assessments[row].verdicts[i].tests, right.assessments[row].verdicts[i].tests);
    }
  }
}

TEST_F(RunComparison, KeepsJudgedTestsInItsStore) {
  ComparisonRequest request = stored_request({.path = file("a.gpkg")});
  request.plan.threads = 3;
  const ComparisonResults results = results_of(request);
  EXPECT_EQ(results.progress.done, 48U);
  EXPECT_EQ(results.progress.total, 48U);
  EXPECT_TRUE(results.comparison.complete);
  ASSERT_EQ(results.comparison.summaries.size(), 4U);

  const auto store = ResultsReader::open(file("a.gpkg"));
  ASSERT_TRUE(store.ok()) << store.diagnostics().render();
  EXPECT_EQ(store.value()->count(), 48U);
  EXPECT_TRUE(store.value()->complete());
  const std::vector<StoredTest> tests = store.value()->tests().value();
  std::uint64_t found = 0;
  for (const StoredTest& test : tests) {
    found += test.result.succeeded ? 1 : 0;
    const Recording recording = store.value()->recording(test.id).value();
    const TestAssessment judged =
        assess(request.criteria, recording, prepared_->scenario().world->ground());
    EXPECT_EQ(store.value()->assessments(test.id).value(), to_rows(request.criteria, judged));
  }
  std::uint64_t summed_up = 0;
  for (const Summary& summary : results.comparison.summaries) summed_up += summary.successes;
  EXPECT_GT(found, 0U);
  EXPECT_EQ(found, summed_up);
}

TEST_F(RunComparison, ComesOutAlikeWithAndWithoutStoreAndThreads) {
  ComparisonRequest threads = request();
  threads.plan.threads = 3;
  const ComparisonResults alone = results_of(threads);
  expect_alike(alone.comparison, results_of(request()).comparison);
  expect_alike(alone.comparison, results_of(stored_request({.path = file("a.gpkg")})).comparison);
}

TEST_F(RunComparison, GoesOnWhereItWasInterrupted) {
  const StoreOptions options{.path = file("a.gpkg"), .resume = true};
  std::atomic<int> ended = 0;
  const ComparisonHooks interrupt{
      .interrupted = [&] { return ended >= 5; },
      .measured = [&](const TestKey&, const TestResult&, const Recording&) { ++ended; }};
  const ComparisonResults begun = results_of(stored_request(options), interrupt);
  EXPECT_FALSE(begun.comparison.complete);
  EXPECT_EQ(begun.progress.done, 5U);
  EXPECT_THAT(begun.comparison.summaries, IsEmpty());

  std::atomic<int> skipped = 0;
  const ComparisonResults whole =
      results_of(stored_request(options), {.skipped = [&](const TestKey& /*test*/) { ++skipped; }});
  EXPECT_EQ(skipped, 5);
  EXPECT_EQ(whole.progress.total, 43U);
  expect_alike(whole.comparison, results_of(request()).comparison);
}

TEST_F(RunComparison, RunsTheTestsOfItsShard) {
  const ComparisonResults half =
      results_of(stored_request({.path = file("a.gpkg"), .shard = {.index = 2, .count = 2}}));
  EXPECT_EQ(half.progress.done, 24U);
  const auto store = ResultsReader::open(file("a.gpkg")).value()->tests().value();
  for (const StoredTest& test : store) EXPECT_EQ(test.test.number % 2, 1U);
}

TEST_F(RunComparison, LetsTheCallerListenToEachTest) {
  std::vector<std::uint64_t> numbers;
  ComparisonRequest one = request();
  one.plan.agents = {1};
  one.plan.tests = 2;
  results_of(one, {.around = [&](const TestKey& test, const TestSetup& setup, TestOptions&,
                                 const std::function<TestRun()>& run) {
               EXPECT_EQ(setup.test, test.number);
               numbers.push_back(one.plan.place_of(test));
               return run();
             }});
  EXPECT_THAT(numbers, ElementsAre(0, 1, 2, 3));
}

TEST_F(RunComparison, RefusesWhatCannotBeRun) {
  ComparisonRequest large = request();
  large.plan.tests = kMaxTests + 1;
  EXPECT_EQ(message_of(run_comparison(large)), "at most 10000000, found 10000001");
  const StoreOptions store{.path = file("a.gpkg")};
  results_of(stored_request(store));
  EXPECT_EQ(message_of(run_comparison(stored_request(store))), "the file exists");
  const auto begins = run_comparison(request(), {.opened = [] { return Proceed::no; }});
  ASSERT_FALSE(begins.ok());
  EXPECT_TRUE(begins.diagnostics().empty());
}

TEST_F(RunComparison, KeepsTheLevelOfAStoreThatIsContinued) {
  results_of(stored_request({.path = file("a.gpkg"), .level = StoreLevel::all}));
  results_of(stored_request({.path = file("a.gpkg"), .resume = true}));
  EXPECT_EQ(ResultsReader::open(file("a.gpkg")).value()->description().level, StoreLevel::all);
  EXPECT_EQ(message_of(run_comparison(stored_request(
                {.path = file("a.gpkg"), .level = StoreLevel::found, .resume = true}))),
            "the store's level is all, not found");
}

}  // namespace
}  // namespace jaywalk
