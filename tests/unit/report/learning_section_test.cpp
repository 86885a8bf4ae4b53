// SPDX-License-Identifier: Apache-2.0
// The section about what was learned, and the maps of what a policy chooses.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/policy/policy.h"
#include "experiment/report/policy_map.h"
#include "experiment/report/report.h"
#include "tests/unit/report/world.h"

namespace jaywalk::reporting {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A policy of the learner's plans that has learned nothing yet.
std::string policy_text() {
  const std::vector<LearnedPlans> plans{
      {.policy = "step", .options = {"forward", "back", "across", "stand"}}};
  PolicyOrigin origin{
      .behaviour = "learner", .scenario = "<l>.yaml", .agents = 2, .seed = 99, .tests = 12345};
  origin.spec.learner = "q-table";
  origin.spec.discount = 0.75;
  origin.curve = {{.tests = 6000, .reward = 1.5, .success_pct = 20},
                  {.tests = 12345, .reward = 2.5, .success_pct = 65}};
  return Policy(std::move(origin), plans).text();
}

std::shared_ptr<const PreparedScenario> learned_world() {
  return world_of("learner", "", policy_text());
}

/// The learner and another behaviour, with one and three agents.
ReportData data_of(std::shared_ptr<const PreparedScenario> prepared) {
  ReportData data;
  data.prepared = std::move(prepared);
  for (const char* name : {"learner", "other"}) {
    data.description.behaviours.push_back({.name = name});
    for (const std::uint32_t agents : {1U, 3U}) {
      data.comparison.summaries.push_back({.behaviour = name,
                                           .agents = agents,
                                           .tests = 100,
                                           .successes = 20 * agents,
                                           .score = {.count = 20, .mean = 30.25}});
    }
  }
  data.description.tests = 3;
  data.description.seed = 5;
  return data;
}

TEST(LearningSection, IsLeftOutWhereNothingWasLearned) {
  EXPECT_EQ(section::learning({}), "");
  EXPECT_EQ(section::learning(data_of(world_of("proximity"))), "");
  EXPECT_EQ(section::learning(data_of(world_of("learner"))), "") << "it chooses by chance";
}

TEST(LearningSection, SaysWhereThePolicyComesFrom) {
  const std::string html = section::learning(data_of(learned_world()));
  EXPECT_THAT(html, HasSubstr("<td class=\"l\">learner</td><td class=\"l\">q-table</td>"
                              "<td class=\"l\">&lt;l&gt;.yaml</td><td>2</td><td>99</td>"
                              "<td>12,345</td><td>0.75</td>"));
}

TEST(LearningSection, DrawsHowLearningWent) {
  const std::string html = section::learning(data_of(learned_world()));
  EXPECT_THAT(html, HasSubstr("Tests that met the precondition, %"));
  EXPECT_THAT(html, HasSubstr("Discounted reward of an agent"));
  EXPECT_THAT(html, HasSubstr("tests learned from"));
}

TEST(LearningSection, SetsItBesideTheOtherBehaviours) {
  const std::string html = section::learning(data_of(learned_world()));
  EXPECT_THAT(html, HasSubstr("<td class=\"l\">learner</td><td class=\"l\">yes</td><td>1</td>"
                              "<td>20.0</td><td>30.2</td>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"l\">other</td><td class=\"l\">no</td><td>3</td>"
                              "<td>60.0</td>"));
}

TEST(LearningSection, LeavesOutAPolicyWhoseBehaviourIsNotCompared) {
  ReportData data = data_of(learned_world());
  std::erase_if(data.comparison.summaries,
                [](const Summary& each) { return each.behaviour == "learner"; });
  EXPECT_EQ(section::learning(data), "");
}

TEST(LearningSection, MapsWhatIsChosenWhere) {
  const std::string html = section::learning(data_of(learned_world()));
  EXPECT_THAT(html, HasSubstr("learner: step<small>"));
  EXPECT_THAT(html, HasSubstr("m ahead, "));
  for (const char* option : {"forward", "back", "across", "stand"}) {
    EXPECT_THAT(html, HasSubstr(">" + std::string(option) + "</text>"));
  }
}

TEST(PolicyMaps, CountEachChoiceInItsSquare) {
  const auto maps = policy_maps(*learned_world(), {.agents = 2, .seed = 5, .count = 4});
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_EQ(maps[0].part, "step");
  EXPECT_THAT(maps[0].options, ElementsAre("forward", "back", "across", "stand"));
  std::uint64_t sum = 0;
  for (const auto& [square, chosen] : maps[0].places) {
    ASSERT_EQ(chosen.size(), 4U);
    for (const std::uint64_t count : chosen) sum += count;
  }
  EXPECT_GT(sum, 0U);
  EXPECT_EQ(sum, maps[0].choices);
}

TEST(PolicyMaps, AreTheSameAgainAndThoseOfPartsAddUp) {
  const auto world = learned_world();
  const PolicyMapTests tests{.agents = 2, .seed = 5, .count = 6};
  EXPECT_EQ(policy_maps(*world, tests)[0].places, policy_maps(*world, tests)[0].places);
  const auto first = policy_maps(*world, {.agents = 2, .seed = 5, .count = 2});
  const auto rest = policy_maps(*world, {.agents = 2, .seed = 5, .first = 2, .count = 4});
  EXPECT_EQ(first[0].choices + rest[0].choices, policy_maps(*world, tests)[0].choices);
}

TEST(PolicyMaps, AreNoneOfNoTests) {
  EXPECT_TRUE(policy_maps(*learned_world(), {.seed = 5, .count = 0}).empty());
}

}  // namespace
}  // namespace jaywalk::reporting
