// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "env/environments.h"
#include "experiment/scenario/scenario.h"
#include "parse.h"

namespace jaywalk {
namespace {

using testing_scenario::errors;
using testing_scenario::parse;

Scenario preset(const std::string& name) {
  ScenarioOptions options;
  options.preset = name;
  Result<Scenario> result = parse("behaviours: [walk.asl]\n", options);
  EXPECT_TRUE(result.ok()) << errors(result);
  return result.ok() ? std::move(result).value() : Scenario{};
}

TEST(Presets, AreAllReadable) {
  EXPECT_EQ(presets().size(), 5U);
  for (const Preset& each : presets()) {
    EXPECT_EQ(preset(std::string(each.name)).preset, each.name);
    EXPECT_FALSE(each.summary.empty());
  }
}

TEST(Presets, DraftCountsTheDraftsMoney) {
  const ScoringParameters scoring = crossing_parameters(*preset("draft").world).scoring;
  EXPECT_EQ(scoring.reward, 20);
  EXPECT_EQ(scoring.pavement_cost, 1);
  EXPECT_EQ(scoring.road_cost, 7);
  EXPECT_EQ(scoring.costs, RoadCost::add);
}

TEST(Presets, PublishedTestsTheSameCellsFromFurtherBack) {
  const CrossingParameters world = crossing_parameters(*preset("published").world);
  EXPECT_EQ(world.av.start, -8);
  EXPECT_EQ(zone_origin(world, 0), 0);
  EXPECT_EQ(zone_ahead(world), (Interval{1, 6}));
}

TEST(Presets, PublishedLiteralMovesTheZoneAndTheDeadZones) {
  const CrossingParameters world = crossing_parameters(*preset("published-literal").world);
  EXPECT_EQ(world.av.start, 0);
  EXPECT_EQ(zone_origin(world, 0), 0);
  EXPECT_EQ(zone_ahead(world), (Interval{9, 14}));
  EXPECT_EQ(world.spawn.dead_zones, (std::map<int, int>{{0, 12}, {1, 6}, {10, 30}, {11, 48}}));
}

/// The parameters of a behaviour, as `name=value`.
std::vector<std::string> parameters(const Scenario& scenario, const std::string& name) {
  std::vector<std::string> found;
  for (const BehaviourSpec& behaviour : scenario.behaviours) {
    if (behaviour.name != name) continue;
    for (const ParameterSetting& each : behaviour.parameters) {
      found.push_back(each.name + '=' + std::get<std::string>(each.values.front()));
    }
  }
  return found;
}

TEST(Presets, SetParametersOfTheBehavioursThatTheScenarioHas) {
  ScenarioOptions options{.preset = "as-published-program"};
  const std::string text =
      "behaviours: [random_behaviour.asl, proximity.asl,\n"
      "  {program: mine.asl, name: election, parameters: {radius_limit: inclusive}}]\n";
  const Scenario read = parse(text, options).value();
  EXPECT_TRUE(read.world->carries_over());
  EXPECT_EQ(parameters(read, "random_behaviour"), std::vector<std::string>{"first_way=back"});
  EXPECT_TRUE(parameters(read, "proximity").empty());
  EXPECT_EQ(parameters(read, "election"), std::vector<std::string>{"radius_limit=inclusive"})
      << "what the file says counts";
  options.sets = {"behaviours.random_behaviour.parameters.first_way=forward"};
  EXPECT_EQ(parameters(parse(text, options).value(), "random_behaviour"),
            std::vector<std::string>{"first_way=forward"});
  options.behaviours = {"elsewhere/random_behaviour.asl"};
  options.sets = {};
  EXPECT_EQ(parameters(parse(text, options).value(), "random_behaviour"),
            std::vector<std::string>{"first_way=back"});
}

TEST(Presets, AreNamedInTheFileByTheOptionOrBySetting) {
  EXPECT_EQ(parse("preset: draft\nbehaviours: [a.asl]\n").value().preset, "draft");
  ScenarioOptions options;
  options.preset = "published";
  EXPECT_EQ(parse("preset: draft\nbehaviours: [a.asl]\n", options).value().preset, "published");
  options.sets = {"preset=paper"};
  EXPECT_EQ(parse("preset: draft\nbehaviours: [a.asl]\n", options).value().preset, "paper");
}

TEST(Presets, AreOverriddenByTheFileAndTheFileBySettings) {
  ScenarioOptions options;
  options.preset = "draft";
  const std::string text = "behaviours: [a.asl]\nworld: {scoring: {reward: 30}}\n";
  EXPECT_EQ(crossing_parameters(*parse(text, options).value().world).scoring.reward, 30);
  EXPECT_EQ(crossing_parameters(*parse(text, options).value().world).scoring.road_cost, 7);
  options.sets = {"world.scoring.reward=40"};
  EXPECT_EQ(crossing_parameters(*parse(text, options).value().world).scoring.reward, 40);
}

}  // namespace
}  // namespace jaywalk
