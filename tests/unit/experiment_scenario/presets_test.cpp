#include <gtest/gtest.h>

#include "experiment/scenario.h"
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
  EXPECT_EQ(presets().size(), 4U);
  for (const Preset& each : presets()) {
    EXPECT_EQ(preset(std::string(each.name)).preset, each.name);
    EXPECT_FALSE(each.summary.empty());
  }
}

TEST(Presets, DraftCountsTheDraftsMoney) {
  const ScoringParameters scoring = preset("draft").world.scoring;
  EXPECT_EQ(scoring.reward, 20);
  EXPECT_EQ(scoring.pavement_cost, 1);
  EXPECT_EQ(scoring.road_cost, 7);
  EXPECT_EQ(scoring.costs, RoadCost::add);
}

TEST(Presets, PublishedTestsTheSameCellsFromFurtherBack) {
  const CrossingParameters world = preset("published").world;
  EXPECT_EQ(world.av.start, -8);
  EXPECT_EQ(zone_origin(world, 0), 0);
  EXPECT_EQ(zone_ahead(world), (Interval{1, 6}));
}

TEST(Presets, PublishedLiteralMovesTheZoneAndTheDeadZones) {
  const CrossingParameters world = preset("published-literal").world;
  EXPECT_EQ(world.av.start, 0);
  EXPECT_EQ(zone_origin(world, 0), 0);
  EXPECT_EQ(zone_ahead(world), (Interval{9, 14}));
  EXPECT_EQ(world.spawn.dead_zones, (std::map<int, int>{{0, 12}, {1, 6}, {10, 30}, {11, 48}}));
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
  EXPECT_EQ(parse(text, options).value().world.scoring.reward, 30);
  EXPECT_EQ(parse(text, options).value().world.scoring.road_cost, 7);
  options.sets = {"world.scoring.reward=40"};
  EXPECT_EQ(parse(text, options).value().world.scoring.reward, 40);
}

}  // namespace
}  // namespace jaywalk
