// SPDX-License-Identifier: Apache-2.0
// Pedestrians directed at an assertion exercise it more than others (F1).

#include <gtest/gtest.h>

#include "experiment/compare/test_assessment.h"
#include "scenarios.h"

namespace jaywalk::testing_scenario {
namespace {

TEST(SeveralAssertions, AreExercisedMostByThoseWhoAreToldTo) {
  const auto prepared = scenario("several_assertions");
  const auto counts = [&](const std::string& told, std::string_view judged) {
    return verdicts(*prepared, told, judged, 200);
  };

  EXPECT_EQ(counts("collision_avoidance", "collision_avoidance").exercised(), 200U);
  EXPECT_LT(counts("recovery", "collision_avoidance").exercised(), 20U);

  EXPECT_GT(counts("recovery", "recovery").exercised(), 50U);
  EXPECT_LT(counts("collision_avoidance", "recovery").exercised(), 20U);

  // A pedestrian who stands in the AV's way early enough shows that it does not brake when it
  // could.
  EXPECT_EQ(counts("avoidability", "avoidability").of(Verdict::unavoidable), 0U);
  EXPECT_GT(counts("avoidability", "avoidability").exercised(), 100U);
}

TEST(SeveralAssertions, NobodyIsToldOneThatIsNotJudged) {
  ScenarioOptions options;
  options.sets = {"behaviours.recovery.parameters.assertion=recoverry"};
  const auto read = read_scenario(project_file("scenarios/several_assertions.yaml"), options);
  ASSERT_FALSE(read);
  EXPECT_NE(read.diagnostics().render().find("no assertion 'recoverry' is judged by this "
                                             "scenario\n  hint: did you mean 'recovery'?"),
            std::string::npos)
      << read.diagnostics().render();
}

}  // namespace
}  // namespace jaywalk::testing_scenario
