// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/per_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/summary.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;

const ExperimentPlan kPlan{.behaviours = {"walk", "a,b"}, .agents = {1, 3}, .tests = 4};

TEST(PerTestCsv, HasALineForEachTestInTheOrderOfThePlan) {
  PerTestTable table(kPlan, {"away", "slow"});
  table.add({.behaviour = 1, .agents = 3, .number = 0},
            {.ticks = 11, .precondition_ticks = 4, .ended_by = "precondition", .impact_mps = 2.5},
            {.judgements = {{.verdict = Verdict::fail}, {.verdict = Verdict::pass}}});
  table.add({.behaviour = 0, .agents = 1, .number = 2}, {.ticks = 9, .ended_by = "road_end"},
            {.judgements = {{.verdict = Verdict::vacuous}, {.verdict = Verdict::unavoidable}}});
  table.add({.behaviour = 0, .agents = 1, .number = 1}, {.ticks = 3, .ended_by = "errored"}, {});
  EXPECT_EQ(
      table.csv(),
      "behaviour,agents,test,ended_by,ticks,precondition_ticks,collision,impact_mps,away,slow\n"
      "walk,1,1,errored,3,,0,,,\n"
      "walk,1,2,road_end,9,,0,,vacuous,unavoidable\n"
      "\"a,b\",3,0,precondition,11,4,1,2.5,fail,pass\n");
}

TEST(PerTestCsv, NamesTheVehicleWhereThereAreSeveral) {
  ExperimentPlan plan = kPlan;
  plan.vehicles = {"given", "latency=0.3"};
  const PerTestLines lines(plan, {});
  EXPECT_THAT(lines.header(), HasSubstr("behaviour,agents,vehicle,test,"));
  EXPECT_EQ(lines.line({.agents = 1, .number = 3, .vehicle = 1},
                       {.ticks = 2, .ended_by = "collision"}, {}),
            "walk,1,latency=0.3,3,collision,2,,0,\n");
}

TEST(PerTestCsv, OfNothingIsItsHeader) {
  EXPECT_EQ(PerTestTable(kPlan, {}).csv(),
            "behaviour,agents,test,ended_by,ticks,precondition_ticks,collision,impact_mps\n");
}

TEST(Summarise, TakesScoresOfTheTestsThatSucceeded) {
  const std::vector<TestResult> tests{{.succeeded = true, .ticks = 4, .score = 10},
                                      {.succeeded = false, .ticks = 11, .score = -5},
                                      {.succeeded = true, .ticks = 6, .score = 30}};
  const Summary summary = summarise(tests);
  EXPECT_EQ(summary.tests, 3U);
  EXPECT_EQ(summary.successes, 2U);
  EXPECT_EQ(summary.score.count, 2U);
  EXPECT_DOUBLE_EQ(summary.score.mean, 20);
  EXPECT_DOUBLE_EQ(summary.score.squares, 200) << "10^2 + 10^2 around the mean";
  EXPECT_DOUBLE_EQ(summary.ticks_success.mean, 5);
  EXPECT_DOUBLE_EQ(summary.ticks_all.mean, 7);
}

TEST(Summarise, LeavesOutTestsThatEndedErrored) {
  const std::vector<TestResult> tests{
      {.succeeded = true, .ticks = 4, .score = 10},
      {.succeeded = true, .errored = true, .ticks = 900, .score = 99}};
  const Summary summary = summarise(tests);
  EXPECT_EQ(summary.tests, 2U);
  EXPECT_EQ(summary.errored, 1U);
  EXPECT_EQ(summary.judged(), 1U);
  EXPECT_EQ(summary.successes, 1U);
  EXPECT_DOUBLE_EQ(summary.score.mean, 10);
  EXPECT_DOUBLE_EQ(summary.ticks_all.mean, 4);
}

TEST(Summarise, OfNothingIsEmpty) {
  const Summary summary = summarise(std::vector<TestResult>{});
  EXPECT_EQ(summary.tests, 0U);
  EXPECT_EQ(summary.score.count, 0U);
}

}  // namespace
}  // namespace jaywalk
