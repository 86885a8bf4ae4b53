// SPDX-License-Identifier: Apache-2.0
// The AgentSpeak programs meet the precondition as often as they exactly should: 2,000 tests of a
// fixed seed, within the 99.9 % interval of a proportion.

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "tests/scenario/exact.h"
#include "tests/scenario/scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::behaviour;
using testing_scenario::paper;

constexpr std::uint64_t kAccuracyTests = 2000;

double measured_accuracy(const PreparedScenario& prepared, const std::string& program,
                         std::size_t agents) {
  const std::size_t index = behaviour(prepared, program);
  std::atomic<std::uint64_t> next = 0;
  std::atomic<std::uint64_t> successes = 0;
  std::atomic<bool> completed = true;
  const auto work = [&] {
    for (std::uint64_t test = next++; test < kAccuracyTests; test = next++) {
      const TestRun result = run_test(prepared, {.behaviour = index,
                                                 .agents = static_cast<std::uint32_t>(agents),
                                                 .seed = 0,
                                                 .test = test});
      if (result.outcome.success) ++successes;
      if (!result.completed) completed = false;
    }
  };
  std::thread other(work);
  work();
  other.join();
  EXPECT_TRUE(completed);
  return static_cast<double>(successes) / static_cast<double>(kAccuracyTests);
}

TEST(Accuracy, OfIndependentAgentsIsExact) {
  const auto prepared = paper();
  ASSERT_NE(prepared, nullptr);
  for (const exact::Answer& answer : exact::kAnswers) {
    for (const std::size_t agents : {1U, 3U, 10U}) {
      const double expected = exact::accuracy(answer.probability, agents);
      EXPECT_NEAR(measured_accuracy(*prepared, answer.program, agents), expected,
                  exact::tolerance(expected, kAccuracyTests) + 1e-12)
          << answer.program << ", " << agents;
    }
  }
}

// The expected values are known within 0.9 points; the interval of 2,000 tests comes on top.
TEST(Accuracy, OfElectionsIsAsSimulated) {
  const auto prepared = paper();
  ASSERT_NE(prepared, nullptr);
  for (const exact::ElectionAnswer& answer : exact::kElection) {
    if (answer.agents != 1 && answer.agents != 3 && answer.agents != 10) continue;
    EXPECT_NEAR(measured_accuracy(*prepared, "election", answer.agents), answer.accuracy,
                exact::tolerance(answer.accuracy, kAccuracyTests) + 0.009)
        << answer.agents;
  }
}

}  // namespace
}  // namespace jaywalk
