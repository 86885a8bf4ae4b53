// SPDX-License-Identifier: Apache-2.0
// The set-up on a search's page, and its commands that reproduce the results.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/report/search_page.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

using testing::HasSubstr;
using testing::Not;

SearchExperiment corner_experiment() {
  SearchExperiment experiment;
  experiment.name = "my search.yaml";
  experiment.sut = "<corner>";
  experiment.measure = "nearness";
  experiment.text = "sut: corner # <b>\n";
  experiment.plan = corner_plan("random", 1200);
  experiment.plan.repetitions = 7;
  return experiment;
}

TEST(SearchSetup, NamesTheSystemWithItsSettings) {
  const std::string html = setup_html(corner_experiment());
  EXPECT_THAT(html, HasSubstr("<dt>system under test</dt><dd>&lt;corner&gt;</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>corner</dt><dd>upper</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>repetitions</dt><dd>7</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>seed</dt><dd>3</dd>"));
}

TEST(SearchSetup, SaysFromWhenOnATestFails) {
  SearchExperiment experiment = corner_experiment();
  experiment.plan.fitness = {.harmless = 2, .worst = -1, .fails_at = 0.5};
  EXPECT_THAT(setup_html(experiment),
              HasSubstr("from a fitness of 0.5 on; the fitness is nearness, 2 becomes 0 and -1 "
                        "becomes 1"));
}

TEST(SearchSetup, SaysEachPartOfTheBudget) {
  SearchExperiment experiment = corner_experiment();
  EXPECT_THAT(setup_html(experiment), HasSubstr("<dd>1,200 tests for each search</dd>"));
  experiment.plan.budget = {.tests = 5, .virtual_s = 60, .overhead_s = 2.5};
  experiment.plan.budget.failures = 3;
  const std::string html = setup_html(experiment);
  EXPECT_THAT(html, HasSubstr("60 virtual seconds: for each test the simulated time, 2.5 s of "
                              "overhead"));
  EXPECT_THAT(html, HasSubstr(", or 5 tests, or 3 failing tests for each search"));
}

TEST(SearchSetup, NamesOfAGeneratorWhatIsNotUsual) {
  SearchExperiment experiment = corner_experiment();
  experiment.plan.budget.generation_s = 0;
  experiment.plan.generators = {generator_spec("random"), generator_spec("ga")};
  EXPECT_THAT(setup_html(experiment), HasSubstr("<dt>generators</dt><dd>random; ga</dd>"));
  GeneratorSpec& own = experiment.plan.generators[1];
  own.name = "my <ga>";
  own.values[0] += 1;
  own.generation_s = 0.25;
  const std::string html = setup_html(experiment);
  EXPECT_THAT(html, HasSubstr("random; my &lt;ga&gt; (ga, "));
  EXPECT_THAT(html, HasSubstr(std::string(own.kind->parameters[0].name) + " "));
  EXPECT_THAT(html, HasSubstr("0.25 s for generating a test)"));
}

TEST(SearchSetup, NamesTheSystemOfAGeneratorThatHasItsOwn) {
  SearchExperiment experiment = corner_experiment();
  EXPECT_THAT(setup_html(experiment), Not(HasSubstr("<h3>")));
  experiment.plan.generators[0].model = std::make_shared<CornerSut>();
  EXPECT_THAT(setup_html(experiment), HasSubstr("<h3>The system that random searches</h3>"));
}

TEST(SearchReproduction, HasACommandThatAShellTakes) {
  SearchExperiment experiment = corner_experiment();
  experiment.options.sets = {"corner=upper", "name=a b"};
  experiment.options.generators = {"random", "ga"};
  EXPECT_THAT(reproduce_html(experiment),
              HasSubstr("<pre>jaywalk search 'my search.yaml' --set corner=upper --set 'name=a b' "
                        "--generators random,ga --repetitions 7 --seed 3</pre>"));
}

TEST(SearchReproduction, LeavesOutOptionsThatWereNotGiven) {
  const std::string html = reproduce_html(corner_experiment());
  EXPECT_THAT(html, Not(HasSubstr("--set")));
  EXPECT_THAT(html, Not(HasSubstr("--generators")));
}

TEST(SearchReproduction, HasTheExperimentsFileAsItIs) {
  EXPECT_THAT(reproduce_html(corner_experiment()),
              HasSubstr("<pre>sut: corner # &lt;b&gt;\n</pre>"));
}

TEST(PublishedSearch, IsOfRoadsAlone) {
  EXPECT_FALSE(is_as_published(corner_experiment()));
  EXPECT_EQ(published_table(corner_experiment()), "");
}

}  // namespace
}  // namespace jaywalk::search
