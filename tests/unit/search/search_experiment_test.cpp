// SPDX-License-Identifier: Apache-2.0
#include "search/search_experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk::search {
namespace {

using testing::HasSubstr;

Result<SearchExperiment> parse(const std::string& text, const SearchOptions& options = {}) {
  return parse_search(std::make_shared<const Source>("roads.yaml", text), options);
}

std::string errors(const std::string& text, const SearchOptions& options = {}) {
  Result<SearchExperiment> result = parse(text, options);
  return result.ok() ? "" : result.diagnostics().render();
}

constexpr auto kSmallest = "sut: {kind: lane-keeping}\n";

TEST(SearchExperiment, HasAllGeneratorsUnlessItNamesSome) {
  const Result<SearchExperiment> all = parse(kSmallest);
  ASSERT_TRUE(all.ok());
  EXPECT_EQ(all.value().plan.generators.size(), generators().size());
  EXPECT_EQ(all.value().measure, "max_oob");
  const Result<SearchExperiment> one = parse(std::string(kSmallest) + "generators: [wogan]\n");
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(one.value().plan.generators.size(), 1U);
}

TEST(SearchExperiment, TakesParametersOfAGeneratorUnderANameOfItsOwn) {
  const Result<SearchExperiment> result =
      parse(std::string(kSmallest) +
            "generators:\n- wogan\n- {generator: wogan, name: by-the-text, batch_norm: 0}\n");
  ASSERT_TRUE(result.ok());
  const auto& specs = result.value().plan.generators;
  ASSERT_EQ(specs.size(), 2U);
  EXPECT_EQ(specs[1].name, "by-the-text");
  EXPECT_NE(specs[0].values, specs[1].values);
}

TEST(SearchExperiment, TakesSettingsAndGeneratorsOfTheCommandLine) {
  const Result<SearchExperiment> result = parse(
      kSmallest,
      {.sets = {"budget.tests=7", "sut.controller=stanley"}, .generators = {"graft", "random"}});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().plan.budget.tests, 7U);
  EXPECT_EQ(result.value().plan.generators[0].name, "graft");
}

TEST(SearchExperiment, PointsAtEveryMistakeAtOnce) {
  const std::string text = errors(
      "sut:\n  kind: lane-keeping\n  controler: stanley\nfitness: {measure: max_ob}\n"
      "budget: {tests: many}\ngenerators: [wogen]\n");
  EXPECT_THAT(text, HasSubstr("roads.yaml:3:3: error: unknown key 'controler' in 'sut'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'controller'?"));
  EXPECT_THAT(text, HasSubstr("roads.yaml:4:20: error:"));
  EXPECT_THAT(text, HasSubstr("did you mean 'max_oob'?"));
  EXPECT_THAT(text, HasSubstr("roads.yaml:5:17: error: expected a whole number"));
  EXPECT_THAT(text, HasSubstr("did you mean 'wogan'?"));
}

TEST(SearchExperiment, RefusesABudgetThatNeverEnds) {
  EXPECT_THAT(errors(std::string(kSmallest) + "budget: {virtual_s: 0}\n"),
              HasSubstr("nothing bounds the number of tests"));
}

// The SBST tool competition charges simulated time alone.
TEST(SearchExperiment, TakesVirtualTimeWithoutOverhead) {
  const auto result = parse(std::string(kSmallest) + "budget: {virtual_s: 100, overhead_s: 0}\n");
  ASSERT_TRUE(result.ok()) << result.diagnostics().render();
  EXPECT_EQ(result.value().plan.budget.overhead_s, 0);
}

TEST(SearchExperiment, TakesTheCostOfGeneratingForEachGenerator) {
  const auto result = parse(std::string(kSmallest) +
                            "budget: {generation_s: 0.5}\n"
                            "generators: [random, {generator: wogan, generation_s: 5.1}]\n");
  ASSERT_TRUE(result.ok()) << result.diagnostics().render();
  const SearchPlan& plan = result.value().plan;
  EXPECT_DOUBLE_EQ(plan.generation_s(plan.generators[0]), 0.5);
  EXPECT_DOUBLE_EQ(plan.generation_s(plan.generators[1]), 5.1);
}

TEST(SearchExperiment, RefusesTwoGeneratorsOfOneName) {
  EXPECT_THAT(errors(std::string(kSmallest) + "generators: [random, random]\n"),
              HasSubstr("a second generator with the name 'random'"));
}

TEST(SearchExperiment, RefusesANameThatNoFileAndNoTableMayHave) {
  for (const std::string name : {"../x", "=HYPERLINK(1)", "two words"}) {
    EXPECT_THAT(errors(std::string(kSmallest) + "generators: [{generator: random, name: \"" + name +
                       "\"}]\n"),
                HasSubstr("'" + name + "' cannot be the name of a generator"));
  }
}

TEST(SearchExperiment, NeedsASystemUnderTest) {
  EXPECT_THAT(errors("seed: 1\n"), HasSubstr("no 'sut' to search"));
  EXPECT_THAT(errors(""), HasSubstr("the experiment is empty"));
  EXPECT_THAT(errors("sut: {kind: external}\n"), HasSubstr("no 'command'"));
}

TEST(SearchExperiment, SuggestsAGeneratorForTheOption) {
  EXPECT_THAT(errors(kSmallest, {.sets = {}, .generators = {"frenetik"}}),
              HasSubstr("did you mean 'frenetic'?"));
}

TEST(SearchExperiment, IsToldFromAScenarioByItsSystemUnderTest) {
  const auto source = [](const char* text) { return std::make_shared<const Source>("x", text); };
  EXPECT_TRUE(is_search(source(kSmallest)));
  EXPECT_FALSE(is_search(source("preset: paper\n")));
}

}  // namespace
}  // namespace jaywalk::search
