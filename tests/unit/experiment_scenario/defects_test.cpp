// SPDX-License-Identifier: Apache-2.0
// The keys world.av.defect and world.av.twin.

#include "env/vehicle/defects.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "env/vehicle/vehicle_section.h"
#include "parse.h"

namespace jaywalk {
namespace {

using testing_scenario::errors;
using testing_scenario::parse;
using testing_scenario::with;

using Defects = std::vector<VehicleDefect>;

AvParameters av_with(std::vector<std::string> sets) {
  sets.insert(sets.begin(), "world.av.model=braking");
  const Result<Scenario> result = with(std::move(sets));
  EXPECT_TRUE(result.ok()) << errors(result);
  return result.ok() ? crossing_parameters(*result.value().world).av : AvParameters{};
}

VehicleParameters twin_of(const AvParameters& av) { return healthy_twin(av.vehicle, av.twin); }

std::string errors_of(const std::string& av) {
  return errors(parse("behaviours: [walk.asl]\nworld:\n  av: {model: braking, " + av + "}\n"));
}

TEST(ScenarioDefects, AreOneOrAListInItsOrder) {
  EXPECT_EQ(av_with({}).vehicle.defects, Defects{});
  EXPECT_EQ(av_with({"world.av.defect=latency"}).vehicle.defects, (Defects{{"latency", 0.3}}));
  EXPECT_EQ(av_with({"world.av.defect=latency=0.6"}).vehicle.defects, (Defects{{"latency", 0.6}}));
  EXPECT_EQ(av_with({"world.av.defect=[range-bias=2, blind-left]"}).vehicle.defects,
            (Defects{{"range-bias", 2}, {"blind-left", 1}}));
}

TEST(ScenarioDefects, TakeThePlaceOfTheLayerBelow) {
  EXPECT_EQ(
      av_with({"world.av.defect=[latency, creeps]", "world.av.defect=gives-up"}).vehicle.defects,
      (Defects{{"gives-up", 2}}));
  EXPECT_EQ(av_with({"world.av.defect=latency", "world.av.defect=[]"}).vehicle.defects, Defects{});
}

TEST(ScenarioDefects, ReadBackAsTheyAreWritten) {
  const Defects defects{{"latency", 0.45}, {"blind-left", 1}, {"low-friction", 0.2}};
  std::string list;
  for (const VehicleDefect& each : defects) list += (list.empty() ? "" : ", ") + text_of(each);
  EXPECT_EQ(av_with({"world.av.defect=[" + list + "]"}).vehicle.defects, defects);
}

TEST(ScenarioDefects, PointAtAMisspeltOne) {
  EXPECT_EQ(errors_of("defect: [creeps, latncy=0.3]"),
            "folder/test.yaml:3:41: error: unknown defect 'latncy'\n"
            "    av: {model: braking, defect: [creeps, latncy=0.3]}\n"
            "                                          ^~~~~~~~~~\n"
            "  hint: did you mean 'latency'?\n");
  EXPECT_EQ(errors(with({"world.av.model=aeb", "world.av.defect=zzz"})),
            "--set world.av.defect=zzz: error: unknown defect 'zzz'\n"
            "  hint: `jaywalk list defects` shows them\n");
}

TEST(ScenarioDefects, SayWhatASeverityMayBe) {
  EXPECT_NE(errors_of("defect: latency=0")
                .find("expected 'latency=' and a positive number of s, found 'latency=0'"),
            std::string::npos);
  EXPECT_NE(errors_of("defect: weak-brakes=120")
                .find("expected 'weak-brakes=' and a positive number of % up to 100"),
            std::string::npos);
  EXPECT_NE(errors_of("defect: blind-left=2")
                .find("expected 'blind-left' alone, it has no severity, found 'blind-left=2'"),
            std::string::npos);
  EXPECT_NE(errors_of("defect: {latency: 0.3}")
                .find("expected a defect as latency or latency=0.6, or a list of them, found keys"),
            std::string::npos);
}

TEST(ScenarioDefects, AreAllReportedAtOnce) {
  const std::string found = errors_of("defect: [latncy, creeps=x], twin: brakin");
  EXPECT_NE(found.find("'latncy'"), std::string::npos) << found;
  EXPECT_NE(found.find("'creeps=x'"), std::string::npos) << found;
  EXPECT_NE(found.find("unknown model 'brakin'"), std::string::npos) << found;
}

TEST(ScenarioDefects, NeedAModelThatBrakes) {
  EXPECT_EQ(errors(parse("behaviours: [walk.asl]\nworld:\n  av: {defect: latency}\n")),
            "folder/test.yaml:3:16: error: the AV's model 'constant' does not brake, so that no "
            "defect of it shows\n"
            "    av: {defect: latency}\n"
            "                 ^~~~~~~\n"
            "  hint: the key is world.av.defect\n");
}

TEST(ScenarioTwin, IsTheVehicleWithoutItsDefectsIfNoneIsNamed) {
  const AvParameters av = av_with({"world.av.defect=latency", "world.av.reaction=0.7"});
  VehicleParameters expected = av.vehicle;
  expected.defects.clear();
  EXPECT_EQ(twin_of(av), expected);
  EXPECT_EQ(twin_of(av).reaction_s, 0.7);
}

TEST(ScenarioTwin, IsAModelACommandOrKeys) {
  EXPECT_EQ(twin_of(av_with({"world.av.twin=careful-competent"})).model, "careful-competent");
  const VehicleParameters command = twin_of(av_with({"world.av.twin=[python3, healthy.py]"}));
  EXPECT_EQ(command.model, "external");
  EXPECT_EQ(command.command, (std::vector<std::string>{"python3", "healthy.py"}));
  const VehicleParameters keys = twin_of(av_with({"world.av.twin={model: idm, deceleration: 5}"}));
  EXPECT_EQ(keys.model, "idm");
  EXPECT_EQ(keys.deceleration_mps2, 5);
}

TEST(ScenarioTwin, HasTheSensorsAndThePeriodOfTheVehicleAndNothingElseOfIt) {
  const VehicleParameters twin =
      twin_of(av_with({"world.av.twin=aeb", "world.av.range=30", "world.av.period=0.5",
                       "world.av.reaction=2", "world.av.defect=latency"}));
  EXPECT_EQ(twin.range_m, 30);
  EXPECT_EQ(twin.period_s, 0.5);
  EXPECT_EQ(twin.reaction_s, std::nullopt);
  EXPECT_EQ(twin.defects, Defects{});
}

TEST(ScenarioTwin, BrakesAndSoDoesItsVehicle) {
  EXPECT_NE(errors_of("twin: constant").find("so that it is nobody's healthy twin"),
            std::string::npos);
  EXPECT_NE(errors(with({"world.av.twin=braking"})).find("so that it has no healthy twin"),
            std::string::npos);
  EXPECT_NE(errors_of("twin: {defect: latency}").find("unknown key 'defect' in 'world.av.twin'"),
            std::string::npos);
}

}  // namespace
}  // namespace jaywalk
