// The pedestrians' world as a system under test.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/experiment.h"

namespace jaywalk::search {
namespace {

using testing::HasSubstr;

Result<SearchExperiment> read(const std::string& keys) {
  const std::string text = "sut:\n  kind: crossing\n  scenario: search/crossing.yaml\n" + keys;
  return parse_search(std::make_shared<const Source>(
      std::string(JAYWALK_SOURCE_DIR) + "/scenarios/test.yaml", text));
}

Outcome run(const std::string& keys, const std::vector<double>& values) {
  const Result<SearchExperiment> experiment = read(keys);
  if (!experiment.ok()) {
    ADD_FAILURE() << experiment.diagnostics().render();
    return {};
  }
  return experiment.value().plan.model->make()->run({Form::vector, values}, 0);
}

constexpr auto kScripted =
    "  behaviour: scripted\n  agents: 1\n  parameters:\n"
    "    behaviours.scripted.parameters.first_way: [forward, back]\n"
    "    behaviours.scripted.parameters.cross_at: {whole: [1, 12]}\n";

double measure_of(const std::string& keys, const Outcome& outcome, std::string_view name) {
  const Result<SearchExperiment> experiment = read(keys);
  const auto index = find_measure(experiment.value().plan.model->measures(), name);
  return outcome.measures.at(index.value());
}

TEST(CrossingSut, HasADimensionForEachParameterAndTwoForEachStart) {
  const Result<SearchExperiment> experiment = read(kScripted);
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  EXPECT_EQ(experiment.value().plan.model->space().dimension(), 4U);
}

TEST(CrossingSut, MeetsThePreconditionWhenThePedestrianCrossesInTime) {
  // The AV drives 6 cells a tick in rows 2 to 5; the pedestrian starts beside the road far ahead.
  const Outcome never = run(kScripted, {1, 1, 1, -1});
  ASSERT_TRUE(never.executed()) << never.error;
  bool met = false;
  for (double tick = -1; tick <= 1 && !met; tick += 0.15) {
    const Outcome outcome = run(kScripted, {1, tick, -0.3, 0.1});
    ASSERT_TRUE(outcome.executed()) << outcome.error;
    met = measure_of(kScripted, outcome, "precondition") == 1;
    EXPECT_EQ(met, measure_of(kScripted, outcome, "exercised") == 1);
  }
  EXPECT_TRUE(met);
}

TEST(CrossingSut, GivesTheSameInputTheSameOutcome) {
  const std::string keys = "  behaviour: random_behaviour\n  agents: 2\n";
  EXPECT_EQ(run(keys, {0.1, 0.2, 0.3, 0.4}), run(keys, {0.1, 0.2, 0.3, 0.4}));
}

TEST(CrossingSut, KeepsItsMeasuresFinite) {
  for (const double value : run(kScripted, {0, 0, 0, 0}).measures) EXPECT_LE(std::fabs(value), 1e6);
}

TEST(CrossingSut, MeasuresAssertions) {
  const std::string keys = std::string(kScripted) + "  assertions: assertions/crossing.yaml\n";
  const Outcome outcome = run(keys, {0, 0, 0, 0});
  EXPECT_GE(measure_of(keys, outcome, "collision_avoidance_robustness"), -1e6);
}

TEST(CrossingSut, PointsAtMistakes) {
  const auto errors = [](const std::string& keys) {
    Result<SearchExperiment> result = read(keys);
    return result.ok() ? std::string() : result.diagnostics().render();
  };
  EXPECT_THAT(errors("  behaviour: scriptet\n"), HasSubstr("did you mean 'scripted'?"));
  EXPECT_THAT(errors("  parameters: {world.av.sped: [1, 2]}\n"), HasSubstr("unknown key 'sped'"));
  EXPECT_THAT(errors("  parameters: {world.av.speed: [2, 1]}\n"), HasSubstr("is greater than"));
  EXPECT_THAT(errors("  assertions: none.yaml\n"), HasSubstr("none.yaml"));
}

// A test that is searched has no test before it whose rest it could be given.
TEST(CrossingSut, RefusesTestsThatDependOnEachOther) {
  const std::string keys =
      "  behaviour: proximity\n  parameters: {world.av.carry_over: ['true']}\n";
  const Result<SearchExperiment> experiment = read(keys);
  ASSERT_FALSE(experiment.ok());
  EXPECT_THAT(experiment.diagnostics().render(), HasSubstr("world.av.carry_over"));
}

TEST(CrossingSut, ComparesBehavioursOnOneFooting) {
  const Result<SearchExperiment> experiment =
      read_search(std::string(JAYWALK_SOURCE_DIR) + "/scenarios/crossing-search.yaml",
                  {.sets = {"budget.tests=20", "repetitions=1"}});
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  const SearchResults results = run_searches(experiment.value().plan, nullptr);
  EXPECT_TRUE(results.complete) << results.trouble.render();
  for (const SearchRun& run : results.runs) {
    for (const TestRow& row : run.tests) EXPECT_EQ(row.test.outcome.error, "");
  }
}

}  // namespace
}  // namespace jaywalk::search
