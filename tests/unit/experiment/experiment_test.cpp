// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/experiment.h"

#include <atomic>
#include <new>
#include <string>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

const ExperimentPlan kPlan = {
    .behaviours = {"walk", "cross"}, .agents = {1, 3, 20}, .tests = 101, .threads = 1};

ExperimentPlan with_threads(unsigned threads) {
  ExperimentPlan plan = kPlan;
  plan.threads = threads;
  return plan;
}

/// A made-up test whose outcome is a function of its case, with sums that depend on their order.
TestResult invented(const TestKey& test) {
  const std::uint64_t hash = (test.number * 7919 + test.agents * 31 + test.behaviour * 17) % 1000;
  return {.succeeded = hash % 3 != 0,
          .ticks = static_cast<std::uint32_t>(hash % 11),
          .score = 1.0 / static_cast<double>(hash + 3)};
}

Proceed always(const Progress& progress) {
  EXPECT_LE(progress.done, progress.total);
  return Proceed::yes;
}

TEST(Experiment, SumsUpEachBehaviourAndNumberOfAgentsInTheOrderOfThePlan) {
  const ExperimentOutcome outcome = run_experiment(kPlan, invented, always);
  EXPECT_TRUE(outcome.complete());
  ASSERT_EQ(outcome.summaries.size(), 6U);
  std::string order;
  for (const Summary& summary : outcome.summaries) {
    EXPECT_EQ(summary.tests, 101U);
    EXPECT_EQ(summary.score.count, summary.successes);
    order += summary.behaviour + std::to_string(summary.agents) + ' ';
  }
  EXPECT_EQ(order, "walk1 walk3 walk20 cross1 cross3 cross20 ");
}

/// Vehicles with the numbers of their tests, in the order in which one thread runs them.
std::string order_of_tests(TestOrder order, const std::string& first_vehicle) {
  const ExperimentPlan plan{.behaviours = {"walk"},
                            .agents = {1},
                            .tests = 3,
                            .vehicles = {first_vehicle, "b"},
                            .order = order,
                            .threads = 1};
  std::string tests;
  const auto note = [&](const TestKey& test) -> Result<TestResult> {
    tests += plan.vehicles[test.vehicle] + std::to_string(test.number) + ' ';
    return invented(test);
  };
  EXPECT_TRUE(run_experiment(plan, note, always).complete());
  return tests;
}

TEST(Experiment, RunsATestWithOneVehicleAfterAnother) {
  EXPECT_EQ(order_of_tests(TestOrder::any, "healthy"), "healthy0 b0 healthy1 b1 healthy2 b2 ");
}

// Each may need a simulator of its own, of which a thread keeps one.
TEST(Experiment, RunsAllTestsOfAModelBeforeThoseOfTheNext) {
  EXPECT_EQ(order_of_tests(TestOrder::any, "a"), "a0 a1 a2 b0 b1 b2 ");
}

TEST(Experiment, RunsAChainToItsEndWithEachVehicle) {
  EXPECT_EQ(order_of_tests(TestOrder::chained, "healthy"), "healthy0 healthy1 healthy2 b0 b1 b2 ");
}

TEST(Experiment, SumsUpTheFirstOfManyVehicles) {
  ExperimentPlan plan = with_threads(4);
  const ExperimentOutcome alone = run_experiment(plan, invented, always);
  plan.vehicles.assign(60, "another");
  plan.vehicles.front() = "healthy";
  const auto others_succeed = [](const TestKey& test) -> Result<TestResult> {
    if (test.vehicle > 0) return TestResult{.succeeded = true};
    return invented(test);
  };
  const ExperimentOutcome many = run_experiment(plan, others_succeed, always);
  EXPECT_EQ(many.progress.done, 60U * 606U);
  ASSERT_EQ(many.summaries.size(), alone.summaries.size());
  for (std::size_t i = 0; i < many.summaries.size(); ++i) {
    EXPECT_EQ(many.summaries[i].successes, alone.summaries[i].successes);
  }
}

TEST(Experiment, HasTheSameOutcomeForAnyNumberOfThreads) {
  const ExperimentOutcome one = run_experiment(kPlan, invented, always);
  for (const unsigned threads : {2U, 8U}) {
    const ExperimentOutcome many = run_experiment(with_threads(threads), invented, always);
    ASSERT_EQ(many.summaries.size(), one.summaries.size());
    for (std::size_t i = 0; i < one.summaries.size(); ++i) {
      EXPECT_EQ(many.summaries[i].successes, one.summaries[i].successes);
      EXPECT_EQ(many.summaries[i].score.mean, one.summaries[i].score.mean);
      EXPECT_EQ(many.summaries[i].score.squares, one.summaries[i].score.squares);
      EXPECT_EQ(many.summaries[i].ticks_all.mean, one.summaries[i].ticks_all.mean);
    }
  }
}

TEST(Experiment, ReportsTheFirstTestThatCannotBeRunForAnyNumberOfThreads) {
  const auto failing = [](const TestKey& test) -> Result<TestResult> {
    if (test.behaviour == 0 || test.agents == 1 || test.number < 50) return invented(test);
    Diagnostics diagnostics;
    diagnostics.error("test", std::to_string(test.number));
    return diagnostics;
  };
  for (const unsigned threads : {1U, 2U, 8U}) {
    const ExperimentOutcome outcome = run_experiment(with_threads(threads), failing, always);
    EXPECT_FALSE(outcome.complete());
    ASSERT_TRUE(outcome.failed_test);
    EXPECT_EQ(outcome.failed_test->behaviour, 1U);
    EXPECT_EQ(outcome.failed_test->agents, 3U);
    EXPECT_EQ(outcome.failed_test->number, 50U);
    EXPECT_EQ(outcome.failure.items().front().message, "50");
    EXPECT_GE(outcome.summaries.size(), 4U);
  }
}

TEST(Experiment, EndsWhenItIsToldToAndKeepsWhatIsFinished) {
  std::atomic<bool> told = false;
  // The third of six pairs never ends by itself.
  const auto endless = [&told](const TestKey& test) -> Result<TestResult> {
    if (test.behaviour == 0 && test.agents == 20) told.wait(false);
    return invented(test);
  };
  const auto stop = [&told](const Progress& progress) {
    if (progress.done < 202) return Proceed::yes;
    told = true;
    told.notify_all();
    return Proceed::no;
  };
  const ExperimentOutcome outcome = run_experiment(kPlan, endless, stop);
  EXPECT_TRUE(told);
  EXPECT_FALSE(outcome.failed_test);
  EXPECT_GE(outcome.summaries.size(), 2U);
}

TEST(Experiment, ThrowsWhatATestThrows) {
  const auto throwing = [](const TestKey& test) -> Result<TestResult> {
    if (test.number == 40) throw std::bad_alloc();
    return invented(test);
  };
  EXPECT_THROW((void)run_experiment(with_threads(2), throwing, always), std::bad_alloc);
}

TEST(Experiment, TellsItsProgressToTheEnd) {
  Progress last;
  (void)run_experiment(with_threads(2), invented, [&last](const Progress& progress) {
    last = progress;
    return Proceed::yes;
  });
  EXPECT_EQ(last.done, 606U);
  EXPECT_EQ(last.total, 606U);
}

}  // namespace
}  // namespace jaywalk
