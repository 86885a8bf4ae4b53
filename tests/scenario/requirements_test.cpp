// SPDX-License-Identifier: Apache-2.0
// The case study's requirements on judging and logging (section 7): a scenario shows each.

#include <cmath>

#include <gtest/gtest.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/results/store/geometry.h"
#include "scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::run;
using testing_scenario::scenario;
using testing_scenario::verdicts;

constexpr std::uint64_t kRequirementTests = 60;

double mean_natural_steps(const PreparedScenario& prepared, const std::string& name) {
  const Ground on = prepared.scenario().world->ground();
  double sum = 0;
  for (std::uint64_t test = 0; test < 100; ++test) {
    const Recording recording = run(prepared, name, 3, test).recording;
    sum += measured(*find_metric("natural_steps"), TestView(recording, on))->value;
  }
  return sum / 100;
}

TEST(Naturalness, TellsPedestriansWhoMoveAsPeopleDoFromThoseWhoDoAnything) {  // F14
  const auto prepared = scenario("naturalness");
  const double random = mean_natural_steps(*prepared, "random_action");
  EXPECT_LT(random, 0.8);
  EXPECT_GT(mean_natural_steps(*prepared, "random_behaviour"), random + 0.15);
  EXPECT_GT(mean_natural_steps(*prepared, "intersect"), random + 0.15);
}

TEST(RulesOfTheRoad, AreBrokenByAnAvThatIsTooFast) {  // F22
  EXPECT_EQ(verdicts(*scenario("rules_of_the_road"), "near", "speed_limit", kRequirementTests)
                .of(Verdict::fail),
            0U);
  const auto fast = scenario("rules_of_the_road", {"world.av.speed_mps=12"});
  EXPECT_EQ(verdicts(*fast, "near", "speed_limit", kRequirementTests).of(Verdict::pass), 0U);
  EXPECT_EQ(verdicts(*fast, "near", "lane_keeping", kRequirementTests).of(Verdict::fail), 0U);
}

TEST(Avoidability, TellsCollisionsThatNobodyAvoidsFromThoseOfABadDriver) {  // F23
  const auto constant = scenario("rules_of_the_road", {"world.av.model=constant"});
  const VerdictCounts bad = verdicts(*constant, "near", "avoidability", kRequirementTests);
  EXPECT_GT(bad.of(Verdict::fail), 0U);
  EXPECT_GT(bad.of(Verdict::unavoidable), 0U);
  const VerdictCounts good =
      verdicts(*scenario("rules_of_the_road"), "near", "avoidability", kRequirementTests);
  EXPECT_EQ(good.of(Verdict::fail), 0U);
  EXPECT_EQ(good.of(Verdict::unavoidable), bad.of(Verdict::unavoidable))
      << "what nobody avoids does not depend on who drives";
}

TEST(APlaceOnTheEarth, IsWhereTheStoresPointsLie) {  // F10
  const auto prepared = scenario("geospatial");
  const Placement placement(prepared->scenario().anchor);
  EXPECT_EQ(placement.srs_id(), 32630);
  const Recording recording = run(*prepared, "intersect", 3, 0).recording;
  const ActorState& first = recording.scene(0)[0];
  const ActorState& last = recording.scene(recording.scenes() - 1)[0];
  const auto [east, north] = placement.place(first.x_m, first.y_m);
  const auto [far_east, far_north] = placement.place(last.x_m, last.y_m);
  EXPECT_NEAR(std::hypot(far_east - east, far_north - north), last.y_m - first.y_m, 1e-6);
  // The AV drives 35 degrees east of north.
  EXPECT_NEAR(std::atan2(far_east - east, far_north - north) * 180 / 3.14159265358979, 35, 1e-6);
}

TEST(Measures, OfThePaperAreAllThere) {  // F18
  // Tests with scores and ticks that are easy to sum up.
  const std::vector<TestResult> results{{true, false, 4, 50, 10, 20},
                                        {true, false, 6, 70, 10, 20},
                                        {false, false, 11, -11, 10, 20},
                                        {false, false, 11, -11, 10, 20},
                                        {false, true, 3, 0, 90, 90}};
  Summary summary = summarise(results);
  summary.code_lines = 34;
  const auto value = [&](const char* name) { return *find_measure(name)->estimate(summary).value; };
  EXPECT_DOUBLE_EQ(value("accuracy_pct"), 50);
  EXPECT_DOUBLE_EQ(value("score_mean"), 60);
  EXPECT_DOUBLE_EQ(value("combined"), 3);
  EXPECT_DOUBLE_EQ(value("ticks_success_mean"), 5);
  EXPECT_DOUBLE_EQ(value("ticks_all_mean"), 8);
  EXPECT_DOUBLE_EQ(value("cpu_us_per_test"), 10);
  EXPECT_DOUBLE_EQ(value("code_lines"), 34);
}

}  // namespace
}  // namespace jaywalk
