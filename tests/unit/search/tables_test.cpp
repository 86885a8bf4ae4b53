// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "search/report/search_page.h"
#include "search/report/search_tables.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

SearchRun run_of(std::string_view generator, std::uint32_t repetition,
                 std::initializer_list<double> fitness) {
  SearchRun run{.generator = std::string(generator), .repetition = repetition, .complete = true};
  run.seed = 100 + repetition;
  for (const double each : fitness) {
    TestRow row{.candidates = 2, .invalid = 1};
    row.test = {.input = {Form::vector, {each, 0}},
                .outcome = {.simulated_s = 5, .measures = {each}},
                .fitness = each,
                .failed = each >= 0.9};
    run.tests.push_back(row);
  }
  return run;
}

/// Two generators with two searches each: `random` finds one failing test, `nsga2` three.
class SearchTables : public testing::Test {
 protected:
  SearchTables() {
    experiment_.name = "e.yaml";
    experiment_.sut = "corner";
    experiment_.measure = "nearness";
    experiment_.plan = corner_plan("random", 3);
    experiment_.plan.generators[0].name = "plain";
    experiment_.plan.generators.push_back(experiment_.plan.generators[0]);
    experiment_.plan.generators[1].name = "clever";
    experiment_.plan.repetitions = 2;
    results_.runs = {run_of("plain", 0, {0.1, 0.2, 0.3}), run_of("plain", 1, {0.1, 0.95, 0.3}),
                     run_of("clever", 0, {0.5, 0.95, 1}), run_of("clever", 1, {0.5, 0.6, 1})};
  }
  [[nodiscard]] std::vector<GeneratorResults> grouped() const {
    return group(experiment_, results_);
  }

  SearchExperiment experiment_;
  SearchResults results_;
};

TEST_F(SearchTables, GroupSearchesByTheirGeneratorInTheOrderOfThePlan) {
  const std::vector<GeneratorResults> generators = grouped();
  ASSERT_EQ(generators.size(), 2U);
  EXPECT_EQ(generators[0].name, "plain");
  EXPECT_THAT(generators[0].values(&RunSummary::failures), ElementsAre(0, 1));
  EXPECT_THAT(generators[1].values(&RunSummary::failures), ElementsAre(2, 1));
}

TEST_F(SearchTables, LeaveOutSearchesThatAreNotComplete) {
  results_.runs[3].complete = false;
  EXPECT_EQ(grouped()[1].runs.size(), 1U);
  EXPECT_THAT(compared(grouped()), IsEmpty()) << "one search cannot be paired with two";
}

TEST_F(SearchTables, HaveADashForAGeneratorWithoutASearch) {
  results_.runs.erase(results_.runs.begin() + 2, results_.runs.end());
  for (const ResultRow& row : result_rows(grouped())) EXPECT_EQ(row.cells[1], "-") << row.title;
}

TEST_F(SearchTables, LeaveOutColumnsWithoutAnyValue) {
  std::size_t roads = 0;
  for (const SummaryColumn& column : summary_columns()) {
    roads += std::isnan(grouped()[0].summaries[0].*column.value) &&
             std::isnan(grouped()[0].summaries[1].*column.value) &&
             std::isnan(grouped()[1].summaries[0].*column.value);
  }
  EXPECT_GT(roads, 0U) << "those of roads";
  EXPECT_EQ(result_rows(grouped()).size(), summary_columns().size() - roads);
}

TEST_F(SearchTables, SayMeanAndDeviation) {
  const std::vector<ResultRow> rows = result_rows(grouped());
  const auto failures = std::ranges::find_if(
      rows, [](const ResultRow& row) { return row.cells[1].starts_with("1.5"); });
  ASSERT_NE(failures, rows.end()) << "the mean of 2 and 1";
  EXPECT_THAT(failures->cells[1], StartsWith("1.5"));
  EXPECT_THAT(failures->cells[1], HasSubstr("(0.7")) << "the root of a half";
}

TEST_F(SearchTables, PairGeneratorsWithAsManySearches) {
  const std::vector<GeneratorResults> generators = grouped();
  const std::vector<GeneratorPair> pairs = compared(generators);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].first->name, "plain");
  EXPECT_EQ(pairs[0].second->name, "clever");
  // Differences of -2 and 0: the one that is left has a sign of chance 1/2, twice.
  EXPECT_DOUBLE_EQ(pairs[0].p(&RunSummary::failures), 1);
}

TEST_F(SearchTables, ArePrintedWithTheirComparisons) {
  const std::string text = render_table(grouped());
  EXPECT_THAT(text, StartsWith("mean (standard deviation)"));
  EXPECT_THAT(text, HasSubstr("plain            clever\n"));
  EXPECT_THAT(text, HasSubstr("Wilcoxon signed-rank, p"));
  EXPECT_THAT(text, HasSubstr("plain / clever"));
}

TEST_F(SearchTables, OfOneGeneratorCompareNothing) {
  experiment_.plan.generators.pop_back();
  EXPECT_THAT(render_table(grouped()), Not(HasSubstr("Wilcoxon")));
}

TEST_F(SearchTables, HaveALineOfCsvForEachSearch) {
  const std::string csv = to_csv(grouped());
  EXPECT_THAT(csv, StartsWith("generator,repetition,seed,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_THAT(csv, HasSubstr("\nplain,0,100,3,0,"));
  EXPECT_THAT(csv, HasSubstr("\nclever,1,101,3,1,"));
  const auto fields = [&](std::size_t from) {
    const std::size_t end = csv.find('\n', from);
    return std::count(csv.begin() + static_cast<std::ptrdiff_t>(from),
                      csv.begin() + static_cast<std::ptrdiff_t>(end), ',');
  };
  EXPECT_EQ(fields(0), fields(csv.find("plain"))) << "empty where there is no value";
}

TEST_F(SearchTables, HaveEveryTestInJson) {
  results_.runs[0].tests[1].test.outcome = {.error = "crashed"};
  const auto json = nlohmann::json::parse(to_json(experiment_, grouped()));
  EXPECT_EQ(json["experiment"], "e.yaml");
  EXPECT_EQ(json["measures"], nlohmann::json::parse(R"(["nearness"])"));
  EXPECT_EQ(json["fitness"]["fails_at"], 0.9);
  EXPECT_EQ(json["generators"][1]["name"], "clever");
  const auto& tests = json["generators"][0]["searches"][0]["tests"];
  ASSERT_EQ(tests.size(), 3U);
  EXPECT_EQ(tests[0]["form"], "vector");
  EXPECT_EQ(tests[0]["input"], nlohmann::json::parse("[0.1, 0.0]"));
  EXPECT_EQ(tests[0]["candidates"], 2);
  EXPECT_FALSE(tests[0].contains("error"));
  EXPECT_EQ(tests[1]["error"], "crashed");
  EXPECT_EQ(json["comparisons"].size(), 1U);
}

TEST_F(SearchTables, SayNullInJsonWhereThereIsNoValue) {
  const auto json = nlohmann::json::parse(to_json(experiment_, grouped()));
  EXPECT_TRUE(json["generators"][0]["summary"]["sparseness"]["mean"].is_null());
}

TEST_F(SearchTables, SayHowManySearchesFoundAFailureAndWhen) {
  const std::vector<GeneratorResults> generators = grouped();
  const std::vector<ResultRow> rows = first_rows(generators);
  ASSERT_EQ(rows.size(), 1U) << "there are no requirements";
  EXPECT_THAT(rows[0].cells, ElementsAre("1 of 2, > 3", "2 of 2, 2.5"));
  EXPECT_THAT(render_table(generators), HasSubstr("1 of 2, > 3       2 of 2, 2.5\n"));
  EXPECT_THAT(to_html(experiment_, generators), HasSubstr("1 of 2, &gt; 3"));
  const auto json = nlohmann::json::parse(to_json(experiment_, generators));
  EXPECT_EQ(json["generators"][1]["first_failure"],
            nlohmann::json::parse(R"({"found": 2, "searches": 2, "median_tests": 2.5})"));
  EXPECT_TRUE(json["generators"][0]["first_failure"]["median_tests"].is_null());
  EXPECT_EQ(json["generators"][0]["searches"][1]["tests"][1]["described"], "0.95 0");
}

/// Two requirements, of which the tests' first measure and what is left to 1 are the robustness.
class TwiceJudged : public CornerSut {
 public:
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kJudged; }

  static constexpr std::array kJudged = {
      MeasureKind{.name = "a_robustness", .meaning = "", .requirement = "a"},
      MeasureKind{.name = "b_robustness", .meaning = "", .requirement = "b"}};
};

TEST_F(SearchTables, SayWhichRequirementsWereViolatedAndWhen) {
  experiment_.plan.model = std::make_shared<TwiceJudged>();
  for (SearchRun& run : results_.runs) {
    for (TestRow& row : run.tests) {
      const double each = row.test.fitness;
      row.test.outcome.measures = {0.4 - each, each - 0.2};
    }
  }
  const std::vector<GeneratorResults> generators = grouped();
  const std::vector<ResultRow> rows = first_rows(generators);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].title, "a");
  EXPECT_THAT(rows[1].cells, ElementsAre("1 of 2, > 3", "2 of 2, 1"));
  EXPECT_THAT(rows[2].cells, ElementsAre("2 of 2, 1", "0 of 2, > 3"));
  const std::string csv = to_csv(generators);
  EXPECT_THAT(csv, HasSubstr(",execution_ms,tests_to_violate_a,tests_to_violate_b\n"));
  EXPECT_THAT(csv.substr(csv.find("plain,0")), HasSubstr(",,1\nplain,1"));
  const auto json = nlohmann::json::parse(to_json(experiment_, generators));
  EXPECT_EQ(json["generators"][1]["requirements"]["a"]["found"], 2);
}

TEST_F(SearchTables, GroupFailingTestsThatAreAlike) {
  const std::vector<GeneratorResults> generators = grouped();
  const std::string html = clusters_html(generators[1], *experiment_.plan.model, 0);
  EXPECT_THAT(html, HasSubstr("3 failing tests"));
  EXPECT_THAT(html, HasSubstr("2 repetitions"));
}

TEST_F(SearchTables, SayThatNoTestFailed) {
  results_.runs.pop_back();
  results_.runs.pop_back();
  results_.runs.pop_back();
  EXPECT_THAT(clusters_html(grouped()[0], *experiment_.plan.model, 0),
              HasSubstr("No test failed."));
}

}  // namespace
}  // namespace jaywalk::search
