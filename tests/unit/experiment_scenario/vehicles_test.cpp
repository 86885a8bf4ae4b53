// SPDX-License-Identifier: Apache-2.0
// Which automated vehicles the tests of an experiment are run with.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/test_run/covered_bins.h"
#include "experiment/test_run/tested_vehicles.h"
#include "parse.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing_scenario::errors;
using testing_scenario::with;

std::vector<TestedVehicle> vehicles(std::vector<std::string> sets) {
  const Result<Scenario> scenario = with(std::move(sets));
  EXPECT_TRUE(scenario.ok()) << errors(scenario);
  return scenario.ok() ? tested_vehicles(scenario.value()) : std::vector<TestedVehicle>{};
}

std::vector<std::string> names(std::vector<std::string> sets) {
  std::vector<std::string> names;
  for (const TestedVehicle& vehicle : vehicles(std::move(sets))) names.push_back(vehicle.name);
  return names;
}

TEST(TestedVehicles, AreUsuallyTheGivenOneAlone) {
  EXPECT_THAT(names({}), ElementsAre("given"));
  EXPECT_EQ(vehicles({"world.av.model=idm"})[0].parameters.model, "idm");
}

TEST(TestedVehicles, KeepADefectThatIsGiven) {
  const auto all = vehicles({"world.av.model=idm", "world.av.defect=blind-left"});
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].parameters.defects.size(), 1U);
  EXPECT_EQ(all[0].parameters.defects[0].name, "blind-left");
}

TEST(TestedVehicles, BeginWithTheHealthyOneWhereDefectsAreLookedFor) {
  const auto all = vehicles({"world.av.model=idm", "experiment.defects=[latency=0.6, blind-left]"});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].name, "healthy");
  EXPECT_TRUE(all[0].parameters.defects.empty());
  EXPECT_EQ(all[1].name, "latency=0.6");
  ASSERT_EQ(all[1].parameters.defects.size(), 1U);
  EXPECT_EQ(all[1].parameters.defects[0].severity, 0.6);
  EXPECT_EQ(all[2].parameters.defects[0].name, "blind-left");
  for (const TestedVehicle& each : all) EXPECT_EQ(each.parameters.model, "idm") << each.name;
}

TEST(TestedVehicles, HaveTheGivenOneBesideTheHealthyOneWhereThatIsAnother) {
  EXPECT_THAT(names({"world.av.model=idm", "world.av.defect=weak-brakes",
                     "experiment.defects=[blind-left]"}),
              ElementsAre("healthy", "given", testing::StartsWith("blind-left")));
}

TEST(TestedVehicles, AreModelsWhereTheseAreCompared) {
  const auto all = vehicles({"experiment.avs=[constant, aeb, idm]"});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].name, "aeb");
  EXPECT_EQ(all[1].parameters.model, "aeb");
  EXPECT_EQ(all[2].parameters.model, "idm");
}

TEST(TestedVehicles, AreTheSameButForTheirModel) {
  for (const TestedVehicle& each :
       vehicles({"world.av.reaction=0.7", "experiment.avs=[constant, aeb]"})) {
    EXPECT_EQ(each.parameters.reaction_s, 0.7) << each.name;
  }
}

TEST(ComparesModels, IsNotSoOfAHealthyOneAndItsDefects) {
  EXPECT_TRUE(compares_models({"constant", "aeb"}));
  EXPECT_FALSE(compares_models({"given"}));
  EXPECT_FALSE(compares_models({"healthy", "latency=0.3"}));
}

TEST(FeedbackOfACoverage, HasTheBinsThatWereCovered) {
  SituationCoverage coverage;
  EXPECT_TRUE(feedback_of(coverage).empty());
  SituationBins bins(situation_items().size());
  bins[0] = 1;
  coverage.add(bins);
  coverage.add(bins);
  EXPECT_EQ(feedback_of(coverage),
            (std::vector<CoveredBin>{{std::string(situation_items()[0].name), 2, 2}}))
      << "counted from 1";
}

}  // namespace
}  // namespace jaywalk
