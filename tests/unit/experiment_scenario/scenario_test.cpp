// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/scenario.h"

#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "parse.h"

namespace jaywalk {
namespace {

using testing_scenario::errors;
using testing_scenario::parse;
using testing_scenario::with;

CrossingParameters world_with(std::vector<std::string> sets) {
  const Result<Scenario> result = with(std::move(sets));
  EXPECT_TRUE(result.ok()) << errors(result);
  return result.ok() ? crossing_parameters(*result.value().world) : CrossingParameters{};
}

TEST(Scenario, BeginsWithTheCaseStudysValues) {
  const Result<Scenario> result = parse("behaviours: [walk.asl]\n");
  ASSERT_TRUE(result.ok()) << errors(result);
  const Scenario& scenario = result.value();
  EXPECT_EQ(scenario.preset, "paper");
  EXPECT_EQ(scenario.experiment.tests, 1000U);
  EXPECT_EQ(scenario.experiment.agents,
            (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 15, 20}));
  EXPECT_EQ(scenario.experiment.seed, 0U);
  EXPECT_EQ(zone_ahead(crossing_parameters(*scenario.world)), (Interval{1, 6}));
}

TEST(Scenario, ReadsEveryKeyOfTheWorld) {
  const Result<Scenario> result = parse(R"(
world:
  environment: crossing
  length: 80
  cell: 1
  tick: 0.5
  bands:
    - {kind: lane, rows: 3, direction: back}
    - {kind: pavement, rows: 4}
  av: {length: 5, rows: [1, 2], start: -3, stopping_distance: 7, speed: 4.5}
  zone: {rows: av, from: stopping_distance, ttc: [1, 2]}
  road_end: 70
  aftermath: 2
  spawn:
    choose: cell
    dead_zones: {4: 10}
  scoring: {pavement_cost: 2, road_cost: 3, costs: add, reward: 50, rewarded: zone}
behaviours: [walk.asl]
experiment:
  {tests: 10, agents: "1..3,7", seed: 42, limits: {cycles: 9, inferences: 8, memory_mb: 7, time_s: 0.5}}
)");
  ASSERT_TRUE(result.ok()) << errors(result);
  const CrossingParameters& world = crossing_parameters(*result.value().world);
  EXPECT_EQ(world.length, 80);
  EXPECT_EQ(world.cell_m, 1);
  EXPECT_EQ(world.tick_s, 0.5);
  EXPECT_EQ(band_rows(world), (std::vector<Interval>{{0, 2}, {3, 6}}));
  EXPECT_EQ(world.bands[0].direction, Direction::back);
  EXPECT_EQ(world.av.length, 5);
  EXPECT_EQ(world.av.rows, (Interval{1, 2}));
  EXPECT_EQ(world.av.start, -3);
  EXPECT_EQ(world.av.stopping_distance, 7);
  EXPECT_EQ(world.av.speed, 4.5);
  EXPECT_EQ(zone_rows(world), (Interval{1, 2}));
  EXPECT_EQ(world.zone.origin, ZoneOrigin::stopping_distance);
  EXPECT_EQ(world.zone.ttc.from, 1);
  EXPECT_EQ(world.zone.ttc.to, 2);
  EXPECT_EQ(world.road_end, 70);
  EXPECT_EQ(world.aftermath, 2);
  EXPECT_EQ(world.spawn.choose, SpawnChoice::cell);
  EXPECT_EQ(world.spawn.dead_zones, (std::map<int, int>{{4, 10}}));
  EXPECT_EQ(world.scoring.pavement_cost, 2);
  EXPECT_EQ(world.scoring.road_cost, 3);
  EXPECT_EQ(world.scoring.costs, RoadCost::add);
  EXPECT_EQ(world.scoring.reward, 50);
  EXPECT_EQ(world.scoring.rewarded, Rewarded::zone);
  EXPECT_EQ(result.value().experiment.tests, 10U);
  EXPECT_EQ(result.value().experiment.agents, (std::vector<std::uint32_t>{1, 2, 3, 7}));
  EXPECT_EQ(result.value().experiment.seed, 42U);
  const TestLimits& limits = result.value().experiment.limits;
  EXPECT_EQ(limits.cycles, 9U);
  EXPECT_EQ(limits.inferences, 8U);
  EXPECT_EQ(limits.memory_mb, 7U);
  EXPECT_EQ(limits.time_s, 0.5);
}

TEST(Scenario, TakesTheAvsSpeedInMetresPerSecond) {
  EXPECT_DOUBLE_EQ(world_with({"world.av.speed_mps=9.0"}).av.speed, 6);
  EXPECT_DOUBLE_EQ(world_with({"world.av.speed_mps=9", "world.tick=0.5"}).av.speed, 3);
  EXPECT_DOUBLE_EQ(world_with({"world.av.speed_mps=9", "world.av.speed=5"}).av.speed, 5);
}

TEST(Scenario, SetsTheZoneInEitherUnit) {
  EXPECT_EQ(zone_ahead(world_with({"world.zone.ahead=[9, 14]"})), (Interval{9, 14}));
  EXPECT_EQ(zone_ahead(world_with({"world.zone.ahead=[9, 14]", "world.zone.ttc=[0, 0.5]"})),
            (Interval{1, 3}));
  EXPECT_EQ(zone_rows(world_with({"world.zone.rows=[3, 4]"})), (Interval{3, 4}));
  EXPECT_EQ(zone_rows(world_with({"world.zone.rows=av"})), (Interval{3, 4}));
  EXPECT_EQ(zone_rows(world_with({"world.zone.rows=av", "world.zone.rows=lane"})),
            (Interval{2, 5}));
}

TEST(Scenario, ChangesSingleDeadZonesOrNone) {
  EXPECT_EQ(world_with({"world.spawn.dead_zones.0=12"}).spawn.dead_zones,
            (std::map<int, int>{{0, 12}, {1, 12}, {10, 36}, {11, 54}}));
  EXPECT_TRUE(world_with({"world.spawn.dead_zones=none"}).spawn.dead_zones.empty());
}

TEST(Scenario, ForgetsTheDeadZonesOfOtherBands) {
  EXPECT_TRUE(world_with({"world.bands=[{kind: lane, rows: 6}, {kind: pavement, rows: 1}]"})
                  .spawn.dead_zones.empty());
}

TEST(Scenario, LetsTheLastSettingCount) {
  EXPECT_EQ(world_with({"world.length=70", "world.length=80"}).length, 80);
}

TEST(Scenario, FindsProgramsFromItsOwnFolder) {
  const Result<Scenario> result =
      parse("behaviours: [../agents/walk.asl, {program: run.asl, name: runner}, /tmp/fly.asl]\n");
  ASSERT_TRUE(result.ok()) << errors(result);
  const std::vector<BehaviourSpec>& behaviours = result.value().behaviours;
  ASSERT_EQ(behaviours.size(), 3U);
  EXPECT_EQ(behaviours[0].name, "walk");
  EXPECT_EQ(behaviours[0].program, "agents/walk.asl");
  EXPECT_EQ(behaviours[1].name, "runner");
  EXPECT_EQ(behaviours[1].program, "folder/run.asl");
  EXPECT_EQ(behaviours[2].program, "/tmp/fly.asl");
}

TEST(Scenario, ReadsParametersAsNumbersAndAtoms) {
  const Result<Scenario> result = parse(R"(
behaviours:
  - program: walk.asl
    parameters: {radius: 15, probability: 1/8, way: back, odds: [1, 11]}
    agents:
      2..3: {radius: 20}
)");
  ASSERT_TRUE(result.ok()) << errors(result);
  const BehaviourSpec& behaviour = result.value().behaviours[0];
  ASSERT_EQ(behaviour.parameters.size(), 4U);
  EXPECT_EQ(behaviour.parameters[0].name, "radius");
  EXPECT_EQ(behaviour.parameters[0].values, (std::vector<ParameterValue>{15.0}));
  EXPECT_EQ(behaviour.parameters[1].values, (std::vector<ParameterValue>{0.125}));
  EXPECT_EQ(behaviour.parameters[2].values, (std::vector<ParameterValue>{"back"}));
  EXPECT_EQ(behaviour.parameters[3].values, (std::vector<ParameterValue>{1.0, 11.0}));
  ASSERT_EQ(behaviour.agents.size(), 1U);
  EXPECT_EQ(behaviour.agents[0].agents, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(behaviour.agents[0].parameters[0].values, (std::vector<ParameterValue>{20.0}));
}

TEST(Scenario, ChangesListedBehavioursByName) {
  const Result<Scenario> result =
      with({"behaviours.walk.parameters.radius=15", "behaviours.walk.parameters.radius=20",
            "behaviours.walk.parameters.way=back"});
  ASSERT_TRUE(result.ok()) << errors(result);
  const std::vector<ParameterSetting>& parameters = result.value().behaviours[0].parameters;
  ASSERT_EQ(parameters.size(), 2U);
  EXPECT_EQ(parameters[0].values, (std::vector<ParameterValue>{20.0}));
}

TEST(Scenario, RunsTheBehavioursAskedFor) {
  ScenarioOptions options;
  options.behaviours = {"run", "other/fly.asl"};
  const Result<Scenario> result =
      parse("behaviours: [walk.asl, {program: run.asl, parameters: {radius: 1}}]\n", options);
  ASSERT_TRUE(result.ok()) << errors(result);
  ASSERT_EQ(result.value().behaviours.size(), 2U);
  EXPECT_EQ(result.value().behaviours[0].program, "folder/run.asl");
  EXPECT_EQ(result.value().behaviours[0].parameters.size(), 1U);
  EXPECT_EQ(result.value().behaviours[1].program, "other/fly.asl");
  EXPECT_EQ(result.value().behaviours[1].name, "fly");
}

}  // namespace
}  // namespace jaywalk
