// Pedestrians who are told an assertion to go for exercise it more than others (F1).

#include <algorithm>

#include <gtest/gtest.h>

#include "experiment/findings.h"
#include "scenarios.h"

namespace jaywalk::testing_scenario {
namespace {

/// The number of tests in which a behaviour's only pedestrian has led to each verdict.
VerdictCounts counts(const PreparedScenario& prepared, const std::string& told,
                     std::string_view judged) {
  const auto& assertions = prepared.scenario().assertions;
  const auto assertion = std::ranges::find(assertions, judged, &Assertion::id);
  const Ground on = ground(prepared.scenario().world);
  VerdictCounts result;
  for (std::uint64_t test = 0; test < 200; ++test) {
    Recording recording;
    (void)run_trial(prepared, {.behaviour = behaviour(prepared, told), .agents = 1, .test = test},
                    {.record = &recording});
    const Judgement judgement = judge(*assertion, TestView(recording, on));
    ++result.tests[static_cast<std::size_t>(judgement.verdict)];
  }
  return result;
}

TEST(SeveralAssertions, AreExercisedMostByThoseWhoAreToldTo) {
  const auto scenario = read_scenario(project_file("scenarios/several_assertions.yaml"));
  ASSERT_TRUE(scenario) << scenario.diagnostics().render();
  Diagnostics warnings;
  const auto prepared = PreparedScenario::prepare(scenario.value(), warnings);
  ASSERT_TRUE(prepared) << prepared.diagnostics().render();
  const PreparedScenario& ready = *prepared.value();

  EXPECT_EQ(counts(ready, "collision_avoidance", "collision_avoidance").exercised(), 200U);
  EXPECT_LT(counts(ready, "recovery", "collision_avoidance").exercised(), 20U);

  EXPECT_GT(counts(ready, "recovery", "recovery").exercised(), 50U);
  EXPECT_LT(counts(ready, "collision_avoidance", "recovery").exercised(), 20U);

  // Whoever stands in the AV's way in good time shows that it does not brake when it could.
  EXPECT_EQ(counts(ready, "avoidability", "avoidability").of(Verdict::unavoidable), 0U);
  EXPECT_GT(counts(ready, "avoidability", "avoidability").exercised(), 100U);
}

TEST(SeveralAssertions, NobodyIsToldOneThatIsNotJudged) {
  ScenarioOptions options;
  options.sets = {"behaviours.recovery.parameters.assertion=recoverry"};
  const auto scenario = read_scenario(project_file("scenarios/several_assertions.yaml"), options);
  ASSERT_FALSE(scenario);
  EXPECT_NE(scenario.diagnostics().render().find("no assertion 'recoverry' is judged by this "
                                                 "scenario\n  hint: did you mean 'recovery'?"),
            std::string::npos)
      << scenario.diagnostics().render();
}

}  // namespace
}  // namespace jaywalk::testing_scenario
