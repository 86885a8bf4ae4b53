// SPDX-License-Identifier: Apache-2.0
// What tests can meet at all, and the walks that meet it.

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/test_run/test_run.h"
#include "search/model_based/reachable_situations.h"

namespace jaywalk::search {
namespace {

using testing::HasSubstr;

/// The paper's road, shorter, so that all walks are followed in a moment.
std::shared_ptr<const PreparedScenario> prepared(const std::string& more = {}) {
  const std::string text =
      "preset: paper\n"
      "world: {length: 40, until: precondition" +
      more +
      "}\n"
      "behaviours:\n"
      "  - ../agents/crossing/scripted.asl\n"
      "  - ../agents/crossing/random_behaviour.asl\n"
      "  - ../agents/crossing/coverage_directed.asl\n";
  Result<Scenario> scenario = parse_scenario(std::make_shared<const Source>(
      std::string(JAYWALK_SOURCE_DIR) + "/scenarios/test.yaml", text));
  EXPECT_TRUE(scenario.ok()) << scenario.diagnostics().render();
  Diagnostics warnings;
  auto result = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

SituationBins bins_of(const PreparedScenario& scenario, const TestSetup& setup) {
  TestRunner runners(scenario);
  Recording recording;
  (void)runners.run(setup, {.record = &recording});
  return covered_bins(recording, scenario.scenario().world->ground());
}

class Reaching : public testing::Test {
 protected:
  std::shared_ptr<const PreparedScenario> prepared_ = prepared();
  Reach reach_ = reach({.prepared = prepared_, .tests = 500, .threads = 2});
};

TEST_F(Reaching, EndsWithAWalkToEachSituationThatIsFound) {
  ASSERT_TRUE(reach_.complete);
  std::size_t walks = 0;
  for (std::size_t item = 0; item < reach_.walks.size(); ++item) {
    for (std::size_t bin = 0; bin < reach_.walks[item].size(); ++bin) {
      const auto& walk = reach_.walks[item][bin];
      if (!walk) continue;
      ++walks;
      const SituationBins bins = bins_of(
          *prepared_,
          {.agents = 1, .starts = {walk->start}, .parameters = {{"moves", {walk->moves}, {}}}});
      EXPECT_EQ(bins[item], bin) << situation_items()[item].name << ' ' << walk->moves;
    }
  }
  EXPECT_GT(walks, 40U);
}

// Behaviours that decide for themselves meet nothing else, however many tests.
TEST_F(Reaching, FindsAllThatAnyTestMeets) {
  std::set<std::pair<std::size_t, std::uint32_t>> met;
  for (const std::size_t behaviour : {1U, 2U}) {
    for (std::uint64_t test = 0; test < 500; ++test) {
      const SituationBins bins =
          bins_of(*prepared_, {.behaviour = behaviour, .agents = 1, .test = test});
      for (std::size_t item = 0; item < bins.size(); ++item) {
        if (!bins[item]) continue;
        met.emplace(item, *bins[item]);
        EXPECT_TRUE(reach_.walks[item][*bins[item]])
            << situation_items()[item].name << ": " << situation_items()[item].bins[*bins[item]];
      }
    }
  }
  EXPECT_GT(met.size(), 30U);
}

// The AV never brakes, is alone, and is two rows wide: its middle lies in neither row.
TEST_F(Reaching, LeavesOutWhatNoTestCanMeet) {
  std::size_t index = 0;
  for (const SituationItem& item : situation_items()) {
    const auto& walks = reach_.walks[index++];
    if (item.name == "av_speed" || item.name == "others") {
      EXPECT_EQ(reachable(walks), 1U) << item.name;
    }
  }
  EXPECT_THAT(reach_text(reach_), HasSubstr("  never: 3 or more\n"));
  EXPECT_THAT(reach_csv(reach_), HasSubstr("others,4,\"3 or more\",0,,,\n"));
}

TEST_F(Reaching, DependsOnNoThread) {
  EXPECT_EQ(reach_csv(reach({.prepared = prepared_, .tests = 500, .threads = 3})),
            reach_csv(reach_));
}

TEST_F(Reaching, SaysWhereItWasGivenUp) {
  const Reach some = reach({.prepared = prepared_, .tests = 500, .most_ticks = 2});
  EXPECT_FALSE(some.complete);
  EXPECT_THAT(reach_text(some), HasSubstr("not all walks were followed to their end"));
}

}  // namespace
}  // namespace jaywalk::search
