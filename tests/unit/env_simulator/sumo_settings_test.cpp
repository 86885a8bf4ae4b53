// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/sumo_settings.h"

#include <map>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/simulator/simulator.h"
#include "env/simulator/sumo/sumo_routes.h"
#include "tests/unit/env/sumo_street.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SettingValue number(double value) {
  SettingValue setting;
  setting.number = value;
  return setting;
}

using Flow = std::map<std::string, std::string>;

SimulatorParameters with_flow(const Flow& flow) {
  SimulatorParameters parameters{.name = "sumo"};
  parameters.settings["traffic"].maps = {flow};
  return parameters;
}

std::string problems_of(const SimulatorParameters& parameters) {
  std::string said;
  for (const SettingProblem& each : check_sumo(parameters, nullptr)) said += each.message + '\n';
  return said;
}

TEST(SumoSettings, HaveTheirDefaults) {
  const SumoSettings settings = sumo_settings({.name = "sumo"});
  EXPECT_EQ(settings.av.name, "Krauss");
  EXPECT_EQ(settings.av.accel_mps2, -1) << "the world's";
  EXPECT_EQ(settings.av.decel_mps2, std::nullopt);
  EXPECT_EQ(settings.av.min_gap_m, 2.5);
  EXPECT_TRUE(settings.brakes_for_pedestrians);
  EXPECT_THAT(settings.traffic, IsEmpty());
  EXPECT_EQ(settings.net, "");
}

TEST(SumoSettings, TakeWhatTheScenarioSays) {
  SimulatorParameters parameters{.name = "sumo", .step_s = 0.25};
  parameters.settings["model"] = text("IDM");
  parameters.settings["accel"] = number(1.5);
  parameters.settings["decel"] = number(3);
  parameters.settings["emergencyDecel"] = number(8);
  parameters.settings["minGap"] = number(1);
  parameters.settings["tau"] = number(0.8);
  parameters.settings["sigma"] = number(0.1);
  parameters.settings["brakes_for_pedestrians"] = number(0);
  parameters.settings["net"] = text("town.net.xml");
  parameters.settings["route"] = text(" in  up\tout ");
  parameters.settings["begin"] = number(12);
  const SumoSettings settings = sumo_settings(parameters);
  EXPECT_EQ(settings.av.name, "IDM");
  EXPECT_EQ(settings.av.accel_mps2, 1.5);
  EXPECT_EQ(settings.av.decel_mps2, 3);
  EXPECT_EQ(settings.av.emergency_decel_mps2, 8);
  EXPECT_EQ(settings.av.min_gap_m, 1);
  EXPECT_EQ(settings.av.tau_s, 0.8);
  EXPECT_EQ(settings.av.sigma, 0.1);
  EXPECT_FALSE(settings.brakes_for_pedestrians);
  EXPECT_EQ(settings.step_s, 0.25);
  EXPECT_EQ(settings.net, "town.net.xml");
  EXPECT_THAT(settings.route, ElementsAre("in", "up", "out"));
  EXPECT_EQ(settings.begin_m, 12);
}

TEST(SumoSettings, OfAFlowTakeEachOfItsKeys) {
  const SumoFlow flow = sumo_settings(with_flow({{"lane", "2"},
                                                 {"every", "7.5"},
                                                 {"speed", "12"},
                                                 {"length", "8"},
                                                 {"width", "2.5"},
                                                 {"model", "ACC"},
                                                 {"accel", "1"},
                                                 {"decel", "2"},
                                                 {"emergencyDecel", "3"},
                                                 {"minGap", "4"},
                                                 {"tau", "5"},
                                                 {"sigma", "0.5"}}))
                            .traffic.at(0);
  EXPECT_EQ(flow.lane, 2);
  EXPECT_EQ(flow.every_s, 7.5);
  EXPECT_EQ(flow.speed_mps, 12);
  EXPECT_EQ(flow.length_m, 8);
  EXPECT_EQ(flow.width_m, 2.5);
  EXPECT_EQ(flow.model.name, "ACC");
  EXPECT_EQ(flow.model.accel_mps2, 1);
  EXPECT_EQ(flow.model.decel_mps2, 2);
  EXPECT_EQ(flow.model.emergency_decel_mps2, 3);
  EXPECT_EQ(flow.model.min_gap_m, 4);
  EXPECT_EQ(flow.model.tau_s, 5);
  EXPECT_EQ(flow.model.sigma, 0.5);
}

struct FlowRange {
  const char* key;
  double least;
  double most;
};

class SumoFlowRanges : public testing::TestWithParam<FlowRange> {};

TEST_P(SumoFlowRanges, AreKept) {
  const FlowRange& range = GetParam();
  const std::string refused = fmt::format("'{}' of a flow is a number from {:g} to {:g}\n",
                                          range.key, range.least, range.most);
  EXPECT_EQ(problems_of(with_flow({{range.key, fmt::format("{}", range.least)}})), "");
  EXPECT_EQ(problems_of(with_flow({{range.key, fmt::format("{}", range.most)}})), "");
  for (const std::string& beyond :
       {fmt::format("{}", range.least - 0.001), fmt::format("{}", range.most + 1),
        std::string("nan"), std::string("1 m"), std::string("fast")}) {
    EXPECT_EQ(problems_of(with_flow({{range.key, beyond}})), refused) << beyond;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SumoFlowRanges,
                         testing::Values(FlowRange{"lane", 1, 50}, FlowRange{"every", 0.5, 3600},
                                         FlowRange{"speed", 0.1, 100},
                                         FlowRange{"length", 0.1, 100}, FlowRange{"width", 0.1, 10},
                                         FlowRange{"minGap", 0, 1000}, FlowRange{"sigma", 0, 1}));

TEST(SumoFlows, HaveARouteOnAMapAndALaneElsewhere) {
  EXPECT_THAT(problems_of(with_flow({{"route", "in out"}})),
              HasSubstr("a flow's route is of a map"));
  SimulatorParameters on_map = with_flow({{"every", "5"}});
  on_map.settings["net"] = text("town.net.xml");
  on_map.settings["route"] = text("in out");
  EXPECT_THAT(problems_of(on_map), HasSubstr("on a map a flow needs a route"));
  EXPECT_THAT(problems_of(with_flow({{"route", "  "}})), HasSubstr("has no edges"));
}

TEST(SumoMaps, NeedTheRouteOfTheAv) {
  SimulatorParameters parameters{.name = "sumo"};
  parameters.settings["net"] = text("town.net.xml");
  EXPECT_EQ(problems_of(parameters), "a map needs the AV's route through it\n");
  parameters.settings["route"] = text(" ");
  EXPECT_EQ(problems_of(parameters), "a map needs the AV's route through it\n");
}

TEST(SumoSteps, AreAMillisecondAtLeast) {
  EXPECT_EQ(problems_of({.name = "sumo", .step_s = 0.0005}),
            "SUMO's steps are a millisecond at least\n");
  EXPECT_EQ(problems_of({.name = "sumo", .step_s = 0.001}), "");
}

TEST(SumoKeys, HaveModelsThatAreAllKnown) {
  for (const SettingKey& key : sumo_keys()) {
    if (key.name != kAvModelKey) continue;
    std::istringstream words{std::string(key.words)};
    int count = 0;
    for (std::string word; words >> word; ++count) {
      EXPECT_EQ(problems_of(with_flow({{"model", word}})), "") << word;
    }
    EXPECT_GT(count, 5);
  }
}

TEST(SumoBodies, AreAllButSignalsAndPedestriansThatNobodyBrakesFor) {
  SumoSettings settings;
  EXPECT_TRUE(is_body({.kind = ActorKind::pedestrian}, settings));
  EXPECT_TRUE(is_body({.kind = ActorKind::cyclist}, settings));
  EXPECT_FALSE(is_body({.kind = ActorKind::signal}, settings));
  settings.brakes_for_pedestrians = false;
  EXPECT_FALSE(is_body({.kind = ActorKind::pedestrian}, settings));
  EXPECT_TRUE(is_body({.kind = ActorKind::vehicle}, settings));
}

TEST(SumoBodies, HaveNamesOfTheirOwn) {
  EXPECT_NE(sumo_body(0), sumo_body(1));
  EXPECT_NE(sumo_body(0), kSumoAv);
}

}  // namespace
}  // namespace jaywalk
