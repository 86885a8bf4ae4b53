// SPDX-License-Identifier: Apache-2.0
// Where the sources of the case study disagree, each reading can be chosen, and it matters.

#include <gtest/gtest.h>

#include "tests/scenario/scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::outcome;
using testing_scenario::paper;

constexpr std::uint64_t kReadingTests = 200;

struct Results {
  std::uint64_t successes = 0;
  double score = 0;  // the sum over successful tests
  std::vector<std::pair<bool, int>> tests;
};

Results run(const std::string& program, const ScenarioOptions& options) {
  const auto prepared = paper(options);
  Results results;
  for (std::uint64_t test = 0; test < kReadingTests; ++test) {
    const CrossingResult result = outcome(*prepared, program, 2, test);
    results.tests.emplace_back(result.success, result.ticks);
    if (!result.success) continue;
    ++results.successes;
    results.score += result.score();
  }
  return results;
}

Results with(const std::string& program, std::vector<std::string> sets) {
  return run(program, {.preset = {}, .sets = std::move(sets), .behaviours = {}});
}

Results preset(const std::string& program, const std::string& name) {
  return run(program, {.preset = name, .sets = {}, .behaviours = {}});
}

TEST(Readings, OfTheZoneMatter) {
  const Results paper_results = with("proximity", {});
  EXPECT_NE(with("proximity", {"world.zone.ahead=[9, 14]"}).tests, paper_results.tests);
  EXPECT_LT(with("random_action", {"world.zone.rows=[3, 4]"}).successes,
            with("random_action", {}).successes);
  EXPECT_EQ(with("random_action", {"world.zone.rows=av"}).tests,
            with("random_action", {"world.zone.rows=[3, 4]"}).tests);
}

TEST(Readings, OfSpawningMatter) {
  const Results paper_results = with("proximity", {});
  // More agents begin on the left pavement, beside the AV's lane.
  EXPECT_GT(with("proximity", {"world.spawn.choose=cell"}).successes, paper_results.successes);
  EXPECT_NE(with("proximity", {"world.spawn.dead_zones={0: 12, 1: 6, 10: 30, 11: 48}"}).tests,
            paper_results.tests);
}

TEST(Readings, OfTheBehavioursParametersMatter) {
  const std::string random = "behaviours.random_behaviour.parameters.";
  const Results random_results = with("random_behaviour", {});
  EXPECT_GT(with("random_behaviour", {random + "crossing_probability=1/5"}).successes,
            random_results.successes);
  EXPECT_NE(with("random_behaviour", {random + "first_way=back"}).tests, random_results.tests);
  const std::string near = "behaviours.proximity.parameters.";
  const Results proximity_results = with("proximity", {});
  EXPECT_NE(with("proximity", {near + "radius_limit=inclusive"}).tests, proximity_results.tests);
  EXPECT_EQ(with("proximity", {near + "radius_limit=inclusive", near + "radius=14"}).tests,
            proximity_results.tests);  // whole distances: up to 14 is below 15
}

TEST(Readings, OfTheRoadsEndAndTheAvsLengthChangeNothing) {
  const Results paper_results = with("proximity", {});
  EXPECT_EQ(with("proximity", {"world.road_end=66"}).tests, paper_results.tests);
  EXPECT_EQ(with("proximity", {"world.av.length=4"}).tests, paper_results.tests);
  EXPECT_NE(with("proximity", {"world.road_end=50"}).tests, paper_results.tests);
}

TEST(Readings, OfTheDraftChangeTheScoreAlone) {
  const Results paper_results = with("proximity", {});
  const Results draft = preset("proximity", "draft");
  EXPECT_EQ(draft.tests, paper_results.tests);
  EXPECT_LT(draft.score, paper_results.score);
}

TEST(Readings, OfThePublishedTextGiveTheSameNumbersMeasuredFromTheStoppingDistance) {
  for (const char* program : {"proximity", "intersect", "election"}) {
    const Results paper_results = with(program, {});
    const Results published = preset(program, "published");
    EXPECT_EQ(published.tests, paper_results.tests) << program;
    EXPECT_DOUBLE_EQ(published.score, paper_results.score) << program;
  }
}

TEST(Readings, OfThePublishedTextTakenLiterallyMatter) {
  EXPECT_NE(preset("proximity", "published-literal").tests, with("proximity", {}).tests);
}

}  // namespace
}  // namespace jaywalk
