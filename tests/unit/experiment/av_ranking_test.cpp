// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/avs/av_ranking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/kills/kills.h"
#include "experiment/report/tables/tables.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ExperimentPlan models() {
  return {.behaviours = {"p", "q"}, .agents = {1}, .tests = 4, .vehicles = {"constant", "Krauss"}};
}

TestKey test_of(std::size_t behaviour, std::uint64_t number, std::size_t vehicle) {
  return {.behaviour = behaviour, .agents = 1, .number = number, .vehicle = vehicle};
}

std::vector<std::string> order(const AvRanking& ranking) {
  std::vector<std::string> names;
  for (const RankedAv& each : ranked(ranking)) names.push_back(each.name);
  return names;
}

/// constant: three collisions, two of them avoidable; Krauss: three at half the speed, none
/// avoidable.
AvRanking filled(bool judged = true) {
  AvTable table(models(), 4);
  for (std::size_t behaviour = 0; behaviour < 2; ++behaviour) {
    for (std::uint64_t test = 0; test < 4; ++test) {
      const TestResult result{.succeeded = test < 3};
      const bool hit = behaviour == 0 && test < 3;
      const auto impact = [&](double mps) { return hit ? std::optional(mps) : std::nullopt; };
      table.add(test_of(behaviour, test, 0), result, impact(9),
                test < 2 ? Blame::avoidable : Blame::unavoidable);
      table.add(test_of(behaviour, test, 1), result, impact(4.5), Blame::unavoidable);
    }
  }
  return table.ranking(judged);
}

TEST(AvRanking, CountsCollisionsByBehaviourAndModel) {
  const AvRanking ranking = filled();
  ASSERT_EQ(ranking.rows.size(), 2U);
  const AvCell& constant = ranking.rows[0].cells[0];
  EXPECT_EQ(constant.tests, 4U);
  EXPECT_EQ(constant.successes, 3U);
  EXPECT_EQ(constant.collisions, 3U);
  EXPECT_EQ(constant.avoidable, 2U);
  EXPECT_EQ(constant.unavoidable, 1U);
  EXPECT_EQ(constant.mean_impact_mps(), 9);
  EXPECT_EQ(ranking.rows[0].cells[1].mean_impact_mps(), 4.5);
  EXPECT_EQ(ranking.rows[1].cells[1].mean_impact_mps(), std::nullopt);
}

TEST(AvRanking, PutsFewestAvoidableCollisionsFirst) {
  EXPECT_THAT(order(filled()), ElementsAre("Krauss", "constant"));
}

TEST(AvRanking, GoesByImpactWhereNothingElseDiffers) {
  EXPECT_THAT(order(filled(false)), ElementsAre("Krauss", "constant"));
  AvTable table(models(), 1);
  table.add(test_of(0, 0, 0), {}, 3.0, Blame::unknown);
  table.add(test_of(0, 0, 1), {}, 4.0, Blame::unknown);
  EXPECT_THAT(order(table.ranking(false)), ElementsAre("constant", "Krauss"));
}

TEST(AvRanking, LeavesOutWhatIsNotFinishedAndWhatErrored) {
  AvTable table(models(), 2);
  table.add(test_of(0, 0, 0), {}, 3.0, Blame::avoidable);
  table.add(test_of(0, 0, 1), {.errored = true}, {}, Blame::unknown);
  table.add(test_of(0, 1, 1), {}, {}, Blame::unknown);
  const AvRanking ranking = table.ranking(true);
  EXPECT_EQ(ranking.rows[0].cells[0].tests, 0U);
  EXPECT_EQ(ranking.rows[0].cells[1].tests, 1U);
  EXPECT_EQ(ranking.rows[0].cells[1].errored, 1U);
  EXPECT_THAT(render_avs(ranking), HasSubstr("without 1 test that ended errored"));
}

TEST(AvRanking, IsATableForPeople) {
  const std::string text = render_avs(filled());
  EXPECT_THAT(text, HasSubstr("1. Krauss         8       75.00         37.50         0.00"));
  EXPECT_THAT(text, HasSubstr("2. constant        8       75.00         37.50        25.00"));
  EXPECT_THAT(text, HasSubstr("q (1)\n"));
}

TEST(AvRanking, IsOfModelsAlone) {
  const ExperimentPlan defects{
      .behaviours = {"p"}, .agents = {1}, .tests = 1, .vehicles = {"healthy", "latency=0.3"}};
  EXPECT_TRUE(AvTable(defects, 1).ranking(true).empty());
  EXPECT_EQ(render_avs(AvTable(defects, 1).ranking(true)), "");
  KillTable kills(models(), 4);
  EXPECT_TRUE(kills.matrix().empty());
}

}  // namespace
}  // namespace jaywalk
