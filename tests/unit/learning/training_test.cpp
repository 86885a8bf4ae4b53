// SPDX-License-Identifier: Apache-2.0
// Agents that learn from tests of a small world.

#include "experiment/learning/training.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

std::shared_ptr<const PreparedScenario> prepared(const std::string& more = "") {
  const std::string text =
      "behaviours: [" JAYWALK_SOURCE_DIR
      "/agents/crossing/learner.asl]\n"
      "learning: {generation: 8, reward: {score: 1}, q-table: {bins: [1, 2]}}\n" +
      more;
  auto scenario = parse_scenario(std::make_shared<const Source>("learning.yaml", text));
  EXPECT_TRUE(scenario.ok()) << scenario.diagnostics().render();
  Diagnostics warnings;
  auto made = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  EXPECT_TRUE(made.ok()) << made.diagnostics().render();
  return made.value();
}

/// The policy's file after `tests` tests.
std::string learned(TrainingPlan plan, std::uint64_t tests,
                    std::shared_ptr<Policy> policy = nullptr) {
  if (policy == nullptr) policy = new_policy(plan).value();
  EXPECT_EQ(why_not_the_same(plan, *policy), "");
  Training training(plan, policy);
  while (training.policy().origin().tests < tests) {
    std::string problem;
    EXPECT_EQ(training.run_generation(tests - training.policy().origin().tests, problem),
              Training::End::learned)
        << problem;
    if (!problem.empty()) break;
  }
  return policy->text();
}

class LearnedBy : public testing::TestWithParam<const char*> {};

TEST_P(LearnedBy, AnyNumberOfThreadsIsTheSame) {
  const auto scenario = prepared(GetParam());
  const std::string one = learned({.prepared = scenario, .agents = 2, .threads = 1}, 40);
  EXPECT_EQ(learned({.prepared = scenario, .agents = 2, .threads = 2}, 40), one);
  EXPECT_EQ(learned({.prepared = scenario, .agents = 2, .threads = 8}, 40), one);
}

TEST_P(LearnedBy, TwoProcessesIsTheSameAsByOne) {
  const auto scenario = prepared(GetParam());
  const TrainingPlan plan{.prepared = scenario, .agents = 2};
  const std::string half = learned(plan, 16);
  const auto again = parse_policy(std::make_shared<const Source>("half.json", half));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(learned(plan, 40, again.value()), learned(plan, 40));
}

INSTANTIATE_TEST_SUITE_P(Learners, LearnedBy,
                         testing::Values("", "experiment: {tests: 3}",
                                         "assertions: " JAYWALK_SOURCE_DIR
                                         "/scenarios/assertions/crossing.yaml"));

TEST(Training, NeedsPlansThatAreLearned) {
  const std::string text = "behaviours: [" JAYWALK_SOURCE_DIR "/agents/crossing/proximity.asl]\n";
  auto scenario = parse_scenario(std::make_shared<const Source>("learning.yaml", text));
  Diagnostics warnings;
  const TrainingPlan plan{
      .prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings).value()};
  EXPECT_THAT(new_policy(plan).diagnostics().render(),
              HasSubstr("no plan that is labelled learned"));
}

TEST(Training, GoesOnOnlyWithWhatItLearnedLikewise) {
  const auto scenario = prepared();
  const TrainingPlan plan{.prepared = scenario, .agents = 1, .seed = 3};
  const auto policy = new_policy(plan).value();
  EXPECT_EQ(why_not_the_same(plan, *policy), "");
  TrainingPlan other = plan;
  other.agents = 2;
  EXPECT_EQ(why_not_the_same(other, *policy), "it learned with 1 agent");
  other = plan;
  other.seed = 4;
  EXPECT_EQ(why_not_the_same(other, *policy), "it learned with seed 3");
  other = plan;
  other.sets = {"world.tick=0.5"};
  EXPECT_EQ(why_not_the_same(other, *policy), "the scenario is another one");
}

TEST(Training, LearnsOfEachAgentWhatItWasScored) {
  // Without costs and without success the reward is 0; costs make it less.
  const auto scenario = prepared("world: {scoring: {reward: 0, pavement_cost: 1, road_cost: 1}}\n");
  const TrainingPlan plan{.prepared = scenario};
  const auto policy = new_policy(plan).value();
  Training training(plan, policy);
  std::string problem;
  ASSERT_EQ(training.run_generation(8, problem), Training::End::learned);
  EXPECT_LT(policy->origin().curve.front().reward, -1);
  EXPECT_EQ(policy->origin().curve.front().tests, 8);
}

}  // namespace
}  // namespace jaywalk
