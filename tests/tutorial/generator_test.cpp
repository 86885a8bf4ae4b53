// SPDX-License-Identifier: Apache-2.0
// The generator that docs/internals/add_generator.md adds works as the page says.

#include <gtest/gtest.h>

#include "search/run_summary.h"
#include "search/search_experiment.h"

namespace jaywalk::search {
namespace {

SearchExperiment experiment(const std::string& generators) {
  const std::string text =
      "sut: {kind: lane-keeping}\nbudget: {tests: 150, virtual_s: 0}\nrepetitions: 3\n"
      "generators: [" +
      generators + "]\n";
  Result<SearchExperiment> read = parse_search(std::make_shared<const Source>("t.yaml", text));
  EXPECT_TRUE(read.ok()) << read.diagnostics().render();
  return std::move(read).value();
}

TEST(Tutorial, AddsAGeneratorByOneFileAndOneRow) {
  ASSERT_NE(find_generator("climber"), nullptr);
  EXPECT_EQ(find_generator("climber")->parameters.size(), 2U);
  EXPECT_NE(find_generator("random"), nullptr);
}

TEST(Tutorial, HasAGeneratorThatFindsWorseTestsThanChance) {
  const SearchExperiment both = experiment("random, climber");
  const SearchResults results = run_searches(both.plan, nullptr);
  ASSERT_TRUE(results.complete);
  double random = 0;
  double climber = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    random += summarise(results.runs[i], *both.plan.model).fitness_last_80;
    climber += summarise(results.runs[3 + i], *both.plan.model).fitness_last_80;
  }
  EXPECT_GT(climber, 1.3 * random);
}

TEST(Tutorial, HasAGeneratorWhoseParametersAnExperimentMaySet) {
  const SearchExperiment set = experiment("{generator: climber, step: 0.05}");
  EXPECT_DOUBLE_EQ(set.plan.generators[0].values[0], 0.05);
}

}  // namespace
}  // namespace jaywalk::search
