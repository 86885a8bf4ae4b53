// SPDX-License-Identifier: Apache-2.0
// What tests cover: the agents' programs, situations, and feedback of these to later tests (F2).

#include <algorithm>

#include <gtest/gtest.h>

#include "experiment/compare/feedback.h"
#include "experiment/judge/situations/situations.h"
#include "experiment/test_run/plan_coverage.h"
#include "scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::behaviour;
using testing_scenario::paper;
using testing_scenario::scenario;

TEST(AnObserver, ChangesNoTest) {
  const auto prepared = paper();
  PlanCoverage coverage(*prepared, all_behaviours(*prepared, 4));
  for (std::size_t each = 0; each < prepared->behaviours().size(); ++each) {
    for (std::uint64_t test = 0; test < 10; ++test) {
      const TestSetup setup{.behaviour = each, .agents = 4, .test = test};
      Recording alone;
      Recording observed;
      const TestRun first = run_test(*prepared, setup, {.record = &alone});
      const PlanCoverage::Borrowed observer(coverage);
      const TestRun second =
          run_test(*prepared, setup, {.record = &observed, .observer = observer.get()});
      EXPECT_EQ(alone, observed) << prepared->behaviours()[each].name << ", test " << test;
      EXPECT_EQ(first.cycles, second.cycles);
    }
  }
}

std::string plan_coverage_on(unsigned threads) {
  const auto prepared = paper();
  PlanCoverage coverage(*prepared, all_behaviours(*prepared, 3));
  const ExperimentPlan plan{
      .behaviours = {"proximity", "election"}, .agents = {1, 3}, .tests = 60, .threads = threads};
  const auto test = [&](const TestKey& each) -> Result<TestResult> {
    const PlanCoverage::Borrowed observer(coverage);
    const std::size_t index = behaviour(*prepared, plan.behaviours[each.behaviour]);
    (void)run_test(*prepared, {.behaviour = index, .agents = each.agents, .test = each.number},
                   {.observer = observer.get()});
    return TestResult{};
  };
  (void)run_experiment(plan, test, [](const Progress&) { return Proceed::yes; });
  return coverage_text(coverage.total());
}

TEST(PlanCoverageOfAnExperiment, DoesNotDependOnThreads) {
  const std::string one = plan_coverage_on(1);
  EXPECT_NE(one.find("election.asl"), std::string::npos);
  EXPECT_EQ(one, plan_coverage_on(4));
}

std::vector<std::string> covered_files(const PreparedScenario& prepared,
                                       const BehavioursRun& behaviours) {
  std::vector<std::string> names;
  for (const auto& [name, file] : PlanCoverage(prepared, behaviours).total().files) {
    names.push_back(name.substr(name.rfind('/') + 1));
  }
  return names;
}

TEST(PlanCoverageOfAnExperiment, LeavesOutProgramsThatNoAgentLoads) {
  const auto all = paper();
  EXPECT_EQ(covered_files(*all, {{behaviour(*all, "random_action"), 3}}),
            (std::vector<std::string>{"random_action.asl", "ways.asl"}));
  const auto team = scenario("team");
  const std::size_t mixed = behaviour(*team, "mixed");
  const auto has = [&](std::uint32_t agents, const std::string& file) {
    const auto files = covered_files(*team, {{mixed, agents}});
    return std::ranges::find(files, file) != files.end();
  };
  EXPECT_FALSE(has(2, "coverage_directed.asl"));
  EXPECT_TRUE(has(3, "coverage_directed.asl"));
  const auto traffic = scenario("traffic");
  const auto files = covered_files(*traffic, {{0, 1}});
  EXPECT_NE(std::ranges::find(files, "cyclist.asl"), files.end()) << "actors are always there";
}

TEST(PlanCoverageOfAnExperiment, SeesWhatABehaviourNeverDoes) {
  const std::string listing = plan_coverage_on(2);
  // The radius itself is near only where the scenario says so.
  EXPECT_NE(listing.find("^ never true: radius_limit(inclusive)"), std::string::npos) << listing;
}

struct FeedbackRun {
  std::uint64_t covered = 0;
  std::vector<std::vector<std::uint64_t>> counts;
  int successes = 0;
};

/// 1000 tests of scenarios/coverage_feedback.yaml; a generation of 0: without feedback.
FeedbackRun feedback_run(std::uint64_t generation, unsigned threads, std::uint64_t tests = 1000) {
  const auto prepared = scenario("coverage_feedback");
  const Ground on = prepared->scenario().world->ground();
  const ExperimentPlan plan{
      .behaviours = {"coverage_directed"}, .agents = {1}, .tests = tests, .threads = threads};
  SituationTable table(plan);
  std::optional<CoverageFeedback> feedback;
  if (generation > 0) feedback.emplace(plan, generation, table);
  std::atomic<int> successes = 0;
  const auto test = [&](const TestKey& each) -> Result<TestResult> {
    TestSetup setup{.behaviour = behaviour(*prepared, "coverage_directed"),
                    .agents = each.agents,
                    .test = each.number};
    if (feedback) setup.feedback = *feedback->wait_for(each);
    Recording recording;
    const TestRun result = run_test(*prepared, setup, {.record = &recording});
    successes += result.outcome.success ? 1 : 0;
    table.add(each, covered_bins(recording, on));
    if (feedback) feedback->finished(each);
    return TestResult{};
  };
  (void)run_experiment(plan, test, [](const Progress&) { return Proceed::yes; });
  const SituationCoverage coverage = table.coverage(0, 1, tests);
  return {coverage.covered(), coverage.counts(), successes};
}

TEST(CoverageFeedbackToAgents, CoversMoreBinsInAThousandTests) {  // F2
  const FeedbackRun with = feedback_run(20, 2);
  const FeedbackRun without = feedback_run(0, 2);
  EXPECT_GE(with.covered, without.covered + 10);
  EXPECT_GT(with.successes, 950) << "and hardly any test is spent in vain";
}

TEST(CoverageFeedbackToAgents, DoesNotDependOnThreads) {
  const FeedbackRun one = feedback_run(7, 1, 200);
  EXPECT_EQ(one.counts, feedback_run(7, 4, 200).counts);
  EXPECT_NE(one.counts, feedback_run(50, 4, 200).counts) << "but on the generations";
}

TEST(CoverageFeedbackToAgents, DoesNotConcernTheFirstGeneration) {
  const ExperimentPlan plan{.behaviours = {"a"}, .agents = {1}, .tests = 10};
  SituationTable table(plan);
  CoverageFeedback feedback(plan, 4, table);
  const auto told = feedback.wait_for({.behaviour = 0, .agents = 1, .number = 3});
  ASSERT_TRUE(told);
  EXPECT_TRUE(told->empty());
}

TEST(CoverageFeedbackToAgents, EndsWaitingWhenItIsGivenUp) {
  const ExperimentPlan plan{.behaviours = {"a"}, .agents = {1}, .tests = 10};
  SituationTable table(plan);
  CoverageFeedback feedback(plan, 4, table);
  feedback.give_up();
  EXPECT_FALSE(feedback.wait_for({.behaviour = 0, .agents = 1, .number = 5}));
}

TEST(FeedbackTexts, AreReadAsTheyAreWritten) {
  const std::vector<CoveredBin> feedback{{"entry_ttc", 3, 17}, {"start_side", 1, 40}};
  EXPECT_EQ(feedback_text(feedback), "entry_ttc 3 17; start_side 1 40");
  EXPECT_EQ(parse_feedback(feedback_text(feedback)), feedback);
  EXPECT_EQ(parse_feedback(""), std::vector<CoveredBin>{});
  for (const char* const wrong : {"x", "x 1", "x 1 2;", "x 1 2 3", " 1 2", "x y 2"}) {
    EXPECT_FALSE(parse_feedback(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace jaywalk
