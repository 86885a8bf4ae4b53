// SPDX-License-Identifier: Apache-2.0
// The pedestrians' world as a system under test.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/run_summary.h"
#include "search/search_experiment.h"
#include "search/search_kills.h"
#include "search/sut.h"

namespace jaywalk::search {
namespace {

using namespace std::string_literals;
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
      read_search(std::string(JAYWALK_SOURCE_DIR) + "/scenarios/search/crossing-search.yaml",
                  {.sets = {"budget.tests=20", "repetitions=1"}});
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  const SearchResults results = run_searches(experiment.value().plan, nullptr);
  EXPECT_TRUE(results.complete) << results.trouble.render();
  for (const SearchRun& run : results.runs) {
    for (const TestRow& row : run.tests) EXPECT_EQ(row.test.outcome.error, "");
  }
}

// Only what a test input changes is read anew from one test to the next.
TEST(CrossingSut, GivesTheSameOutcomeWhateverWasRunBefore) {
  for (const std::string& keys : {std::string(kScripted),
                                  "  behaviour: scripted\n  agents: 1\n  parameters:\n"
                                  "    behaviours.scripted.parameters.first_way: [forward, back]\n"
                                  "    world.av.speed: [4, 6]\n"s}) {
    const Result<SearchExperiment> experiment = read(keys);
    ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
    const auto kept = experiment.value().plan.model->make();
    for (const double first : {-1.0, 1.0, -0.4}) {
      const std::vector<double> values{first, 0.2, -0.3, 0.1};
      Outcome again = kept->run({Form::vector, values}, 0);
      const Outcome alone = run(keys, values);
      // These two are about the tests before.
      for (const char* name : {"new_bins", "rarity"}) {
        const auto index = find_measure(experiment.value().plan.model->measures(), name).value();
        again.measures[index] = alone.measures[index];
      }
      EXPECT_EQ(again, alone);
    }
  }
}

/// A search's SUT, the space of its measures, and a test that meets the precondition.
struct Searching {
  Result<SearchExperiment> experiment =
      read("  behaviour: scripted\n  agents: 1\n  starts: {walks: search/manual.csv}\n");
  const SutModel& model = *experiment.value().plan.model;
  std::unique_ptr<Sut> sut = model.make();
  TestInput input{Form::vector, {-1}};

  [[nodiscard]] double measure(const Outcome& outcome, std::string_view name) const {
    return outcome.measures.at(find_measure(model.measures(), name).value());
  }
};

TEST(CrossingSut, CountsTheSituationsThatNoTestOfTheSearchMetBefore) {
  Searching searching;
  const Outcome first = searching.sut->run(searching.input, 0);
  EXPECT_EQ(searching.measure(first, "precondition"), 1);
  const auto bins = situation_bins(first, searching.model.measures());
  ASSERT_TRUE(bins.has_value());
  const auto met = static_cast<double>(
      std::ranges::count_if(*bins, [](const auto& bin) { return bin.has_value(); }));
  EXPECT_GT(met, 8);
  EXPECT_EQ(searching.measure(first, "new_bins"), met);
  EXPECT_NEAR(searching.measure(first, "rarity"), met / 12.0, 1e-9);
  const Outcome second = searching.sut->run(searching.input, 1);
  EXPECT_EQ(searching.measure(second, "new_bins"), 0);
  EXPECT_NEAR(searching.measure(second, "rarity"), met / 24.0, 1e-9);
}

TEST(CrossingSut, RemembersTheTestsOfAnEarlierProcess) {
  Searching searching;
  const Outcome first = searching.sut->run(searching.input, 0);
  const Outcome second = searching.sut->run(searching.input, 1);
  const auto resumed = searching.model.make();
  resumed->remember(first);
  EXPECT_EQ(resumed->run(searching.input, 1), second);
}

TEST(CrossingSut, RepeatsWalksOfAFile) {
  const Searching searching;
  const SearchSpace& space = searching.model.space();
  EXPECT_EQ(space.distinct_values(), std::vector<std::size_t>{29});
  EXPECT_EQ(space.describe(searching.input), "from row 1, cell 22, moves sssrrrrrrrrr");
  const auto errors = [](const std::string& keys) {
    Result<SearchExperiment> result = read(keys);
    return result.ok() ? std::string() : result.diagnostics().render();
  };
  const std::string walks = "  starts: {walks: search/manual.csv}\n";
  EXPECT_THAT(errors("  behaviour: scripted\n  agents: 2\n" + walks),
              HasSubstr("walks are of one pedestrian, not of 2"));
  EXPECT_THAT(errors("  behaviour: proximity\n" + walks), HasSubstr("moves"));
  EXPECT_THAT(errors("  behaviour: scripted\n  starts: {walks: none.csv}\n"),
              HasSubstr("no file of walks is at"));
}

TEST(CrossingSut, StartsWhereTestsThatDrawTheirStartsDo) {
  const Result<SearchExperiment> spawn = read("  behaviour: scripted\n  starts: spawn\n");
  ASSERT_TRUE(spawn.ok()) << spawn.diagnostics().render();
  const SearchSpace& space = spawn.value().plan.model->space();
  // Of rows 0, 1, 10 and 11 the paper leaves out the first 18, 12, 36 and 54 of 66 cells.
  EXPECT_EQ(space.distinct_values(), (std::vector<std::size_t>{4, 54}));
  EXPECT_EQ(space.describe({Form::vector, {-1, -1}}), "from row 0, cell 18");
  EXPECT_EQ(space.describe({Form::vector, {1, -1}}), "from row 11, cell 54");
}

// As in comparisons: coverage_directed goes for what the tests before have left.
TEST(CrossingSut, TellsAgentsWhatTheTestsBeforeHaveCovered) {
  const auto bins = [](const std::string& feedback) {
    const Result<SearchExperiment> experiment = parse_search(std::make_shared<const Source>(
        std::string(JAYWALK_SOURCE_DIR) + "/scenarios/test.yaml",
        "sut: {kind: crossing, scenario: search/coverage.yaml, behaviour: coverage_directed,\n"
        "  starts: chance, parameters: {experiment.feedback: [" +
            feedback + "]}}\nbudget: {tests: 200, virtual_s: 0}\ngenerators: [random]\n"));
    EXPECT_TRUE(experiment.ok()) << experiment.diagnostics().render();
    const SearchPlan& plan = experiment.value().plan;
    return summarise(run_searches(plan, nullptr).runs[0], *plan.model).situation_bins;
  };
  EXPECT_GT(bins("20"), bins("0"));
}

// Of 200 tests about 98 meet a rare situation, and about 63 of random ones.
TEST(MapElitesOfSituations, MeetsRareOnesMoreOftenThanChance) {
  const Result<SearchExperiment> experiment =
      read_search(std::string(JAYWALK_SOURCE_DIR) + "/scenarios/search/defects-search.yaml",
                  {.sets = {"defects=[]", "seed=1", "fitness.measure=rarity", "fitness.harmless=0",
                            "fitness.worst=1", "fitness.fails_at=0.05", "sut.starts=spawn",
                            "sut.behaviour=" JAYWALK_SOURCE_DIR "/agents/crossing/scripted.asl"},
                   .generators = {"random", "map-elites"}});
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  const SearchPlan& plan = experiment.value().plan;
  const SearchResults results = run_searches(plan, nullptr);
  const double chance = summarise(results.runs[0], *plan.model).failures;
  EXPECT_GT(summarise(results.runs[1], *plan.model).failures, 1.2 * chance);
}

TEST(CrossingSut, StartsWhereItIsTold) {
  const Result<SearchExperiment> some =
      read("  behaviour: scripted\n  starts: {rows: [1, 10], cells: [20, 30, 40]}\n");
  ASSERT_TRUE(some.ok()) << some.diagnostics().render();
  EXPECT_EQ(some.value().plan.model->space().distinct_values(), (std::vector<std::size_t>{2, 3}));
  const auto errors = [](const std::string& starts) {
    Result<SearchExperiment> result = read("  behaviour: scripted\n  starts: " + starts + "\n");
    return result.ok() ? std::string() : result.diagnostics().render();
  };
  EXPECT_THAT(errors("{rows: [5]}"), HasSubstr("no pavement has the row 5"));
  EXPECT_THAT(errors("{cells: [700]}"), HasSubstr("the road has no cell 700"));
  EXPECT_THAT(errors("{cells: {}}"), HasSubstr("expected a list of whole numbers"));
  EXPECT_THAT(errors("given"), HasSubstr("the scenario gives no start cells of 1 pedestrians"));
}

TEST(CrossingSut, TellsHowManyValuesEachDimensionHas) {
  const Result<SearchExperiment> experiment = read(
      "  behaviour: scripted\n  starts: chance\n  parameters:\n"
      "    behaviours.scripted.parameters: {cross_at: {whole: [1, 12], step: 4}}\n"
      "    behaviours.scripted.parameters.pause: [0.5, 1, 4]\n"
      "    world.av.speed: [5, 6]\n");
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  EXPECT_EQ(experiment.value().plan.model->space().distinct_values(),
            (std::vector<std::size_t>{3, 3, 0}));
}

// A file has dotted keys, --set makes maps of them.
TEST(CrossingSut, LetsAnOptionReplaceADimension) {
  const Result<SearchExperiment> experiment =
      read(std::string(kScripted) + "    behaviours: {scripted: {parameters: {cross_at: [3]}}}\n");
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  EXPECT_EQ(experiment.value().plan.model->space().distinct_values(),
            (std::vector<std::size_t>{2, 1, 4, 66}));
}

Result<SearchExperiment> read_defects(const std::string& rest) {
  const std::string text = "sut:\n  kind: crossing\n  scenario: defects.yaml\n  behaviour: " +
                           std::string(JAYWALK_SOURCE_DIR) +
                           "/agents/crossing/scripted.asl\n"
                           "  starts: {rows: [1], cells: [44, 46]}\n  parameters:\n"
                           "    behaviours.scripted.parameters.first_way: [none]\n"
                           "    behaviours.scripted.parameters.ahead: [0, 3]\n" +
                           rest;
  return parse_search(std::make_shared<const Source>(
      std::string(JAYWALK_SOURCE_DIR) + "/scenarios/test.yaml", text));
}

// The search of an AV without brakes to speak of finds scripts that a healthy one survives.
TEST(SearchKills, AreTestsThatBlameTheDefectiveAvAndNotTheHealthyOne) {
  Result<SearchExperiment> experiment = read_defects(
      "defects: [weak-brakes=10, fast-as-noise]\nbudget: {tests: 0, virtual_s: 1e9}\n"
      "generators: [{generator: exhaustive, raster: 7}]\n");
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  SearchKills kills(experiment.value());
  const SearchResults results = run_searches(
      experiment.value().plan, nullptr,
      {.finished = [&](std::size_t search, SearchRun& each) { kills.add(search, each); }});
  ASSERT_TRUE(results.complete);
  const KillMatrix matrix = kills.matrix();
  ASSERT_EQ(matrix.rows.size(), 1U);
  const KillRow& row = matrix.rows[0];
  EXPECT_EQ(row.behaviour, "exhaustive");
  EXPECT_EQ(row.agents, 1U);
  EXPECT_EQ(matrix.defects, (std::vector<std::string>{"weak-brakes=10", "fast-as-noise=2.5"}));
  EXPECT_EQ(row.cells[0].tests, 14U);  // two cells, seven moments
  EXPECT_GT(row.cells[0].kills, 0U);
  EXPECT_LT(row.cells[0].kills, 14U);
  EXPECT_EQ(first_kill_median(row.cells[0]), row.cells[0].first);
  const std::vector<SearchKills::Team> best = kills.best_tests(0);
  ASSERT_EQ(best.size(), 1U);  // two kill no more
  EXPECT_EQ(best[0].killed, 1U);
  EXPECT_THAT(experiment.value().plan.model->space().describe(best[0].tests.at(0)),
              testing::StartsWith("first_way none, ahead "));
  // Nobody is as fast as that.
  EXPECT_EQ(row.cells[1].kills, 0U);
  EXPECT_EQ(row.cells[1].tests, 14U);
}

TEST(SearchKills, ComeFromTheSameInputsForEachDefect) {
  Result<SearchExperiment> experiment = read_defects(
      "defects: latency,low-friction\nbudget: {tests: 5, virtual_s: 0}\n"
      "generators: [random]\n");
  ASSERT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  const SearchResults results = run_searches(experiment.value().plan, nullptr);
  for (std::size_t test = 0; test < 5; ++test) {
    EXPECT_EQ(results.runs[0].tests[test].test.input, results.runs[1].tests[test].test.input);
  }
}

TEST(SearchKills, NeedASystemWithAnAvThatBrakes) {
  const auto errors = [](Result<SearchExperiment> result) {
    return result.ok() ? std::string() : result.diagnostics().render();
  };
  EXPECT_THAT(errors(read_defects("defects: latncy\n")), HasSubstr("did you mean 'latency'?"));
  EXPECT_THAT(errors(read("  behaviour: scripted\ndefects: latency\n")),
              HasSubstr("without assertions nothing blames an AV"));
  EXPECT_THAT(errors(read("  behaviour: scripted\ndefects: latency\n")),
              HasSubstr("no defect shows in it"));
  EXPECT_THAT(errors(parse_search(std::make_shared<const Source>(
                  "test.yaml",
                  "sut: {kind: lane-keeping, controller: paper-rate}\n"
                  "defects: latency\n"))),
              HasSubstr("'lane-keeping' has no AV with defects"));
}

}  // namespace
}  // namespace jaywalk::search
