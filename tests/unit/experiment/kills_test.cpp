// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/kills/kills.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/kills/kills_file.h"
#include "experiment/compare/kills/predictors.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/report/tables/tables.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;

KillCell cell(std::uint64_t tests, std::uint64_t kills) { return {.tests = tests, .kills = kills}; }

/// Each row's kills out of ten tests with each of the defects a, b, c, …
KillMatrix matrix_of(const std::vector<std::vector<std::uint64_t>>& kills) {
  KillMatrix matrix;
  for (std::size_t i = 0; i < kills.front().size(); ++i) {
    matrix.defects.emplace_back(1, static_cast<char>('a' + i));
  }
  for (std::size_t row = 0; row < kills.size(); ++row) {
    KillRow each{.behaviour = "r" + std::to_string(row), .agents = 1};
    for (const std::uint64_t number : kills[row]) each.cells.push_back(cell(10, number));
    matrix.rows.push_back(each);
  }
  return matrix;
}

ExperimentPlan plan() {
  return {.behaviours = {"p", "q"}, .agents = {1, 3}, .tests = 4, .vehicles = {"healthy", "late"}};
}

TEST(KillTable, CountsTestsThatBlameTheDefectiveAvAndNotTheHealthyOne) {
  KillTable table(plan(), 4);
  for (std::uint64_t test = 0; test < 4; ++test) {
    table.add({.behaviour = 1, .agents = 3, .number = test}, test == 0);
    table.add({.behaviour = 1, .agents = 3, .number = test, .vehicle = 1}, test != 1);
  }
  const KillRow row = table.matrix().rows.at(3);
  EXPECT_EQ(row.behaviour, "q");
  EXPECT_EQ(row.agents, 3U);
  EXPECT_EQ(row.healthy_failures, 1U);
  EXPECT_EQ(row.cells.at(0).tests, 4U);
  EXPECT_EQ(row.cells.at(0).kills, 2U);
  EXPECT_EQ(row.cells.at(0).first, 3U);
}

TEST(KillTable, LeavesOutTestsThatEndedErroredWithEitherAv) {
  KillTable table(plan(), 4);
  for (std::uint64_t test = 0; test < 4; ++test) {
    const TestKey healthy{.number = test};
    const TestKey late{.number = test, .vehicle = 1};
    test == 0 ? table.add_errored(healthy) : table.add(healthy, false);
    test == 1 ? table.add_errored(late) : table.add(late, true);
  }
  const KillRow row = table.matrix().rows.at(0);
  EXPECT_EQ(row.cells.at(0).tests, 2U);
  EXPECT_EQ(row.cells.at(0).errored, 2U);
  EXPECT_EQ(row.cells.at(0).kills, 2U);
  EXPECT_EQ(row.cells.at(0).first, 1U);
  EXPECT_EQ(row.errored(), 2U);
  EXPECT_THAT(render_kills(table.matrix()), HasSubstr("p (1): without 2 tests that ended errored"));
}

TEST(KillTable, LeavesOutCellsWhoseTestsAreNotAllFinished) {
  KillTable table(plan(), 4);
  for (std::uint64_t test = 0; test < 3; ++test) {
    table.add({.number = test}, false);
    table.add({.number = test, .vehicle = 1}, true);
  }
  EXPECT_EQ(table.matrix().rows.at(0).cells.at(0).tests, 0U);
}

TEST(KillTable, OfAShardCountsTheShardsTests) {
  KillTable table(plan(), 2);
  for (const std::uint64_t test : {1U, 3U}) {
    table.add({.number = test}, false);
    table.add({.number = test, .vehicle = 1}, test == 3);
  }
  EXPECT_EQ(table.matrix().rows.at(0).cells.at(0).tests, 2U);
  EXPECT_EQ(table.matrix().rows.at(0).cells.at(0).kills, 1U);
}

TEST(KillTable, IsEmptyWithoutDefects) {
  ExperimentPlan one = plan();
  one.vehicles = {"given"};
  KillTable table(one, 4);
  table.add({}, true);
  EXPECT_TRUE(table.matrix().empty());
}

// Of ten tests one kills: five have it among them with a chance of a half.
TEST(FirstKillMedian, IsTheMedianOverAllOrdersOfTheTests) {
  EXPECT_EQ(first_kill_median(cell(10, 1)), 5U);
  EXPECT_EQ(first_kill_median(cell(10, 5)), 1U);
  EXPECT_EQ(first_kill_median(cell(10, 4)), 2U);
  EXPECT_EQ(first_kill_median(cell(10, 10)), 1U);
  EXPECT_EQ(first_kill_median(cell(10, 0)), std::nullopt);
}

TEST(FirstKillMedian, OfARowTakesDefectsThatLiveAsLongerThanAny) {
  EXPECT_EQ(first_kill_median(matrix_of({{1, 5, 0}}).rows[0]), 5U);
  EXPECT_EQ(first_kill_median(matrix_of({{1, 0, 0}}).rows[0]), std::nullopt);
  EXPECT_EQ(first_kill_median(matrix_of({{1, 0}}).rows[0]), 5U);
}

TEST(MutationScore, IsTheExpectedShareOfDefectsKilled) {
  const KillRow row = matrix_of({{10, 1, 0}}).rows[0];
  EXPECT_DOUBLE_EQ(mutation_score(row, 0), 0);
  EXPECT_NEAR(mutation_score(row, 1), (1 + 0.1) / 3, 1e-12);
  EXPECT_NEAR(mutation_score(row, 5), (1 + 0.5) / 3, 1e-12);
  EXPECT_NEAR(mutation_score(row, 10), 2.0 / 3, 1e-12);
}

// Always taking the row that kills most takes three: 2 first, then 0 and 1.
TEST(SmallestTeam, IsSmallerThanWhatTheGreedyChoiceFinds) {
  const KillMatrix matrix = matrix_of({
      {1, 1, 1, 0, 0, 0},
      {0, 0, 0, 1, 1, 1},
      {9, 9, 0, 9, 9, 0},
  });
  EXPECT_EQ(smallest_team(matrix), (std::vector<std::size_t>{0, 1}));
}

TEST(SmallestTeam, OfEqualSizeIsTheOneWithMostKills) {
  EXPECT_EQ(smallest_team(matrix_of({{1, 1}, {5, 5}, {1, 0}})), (std::vector<std::size_t>{1}));
}

TEST(SmallestTeam, IgnoresWhatNobodyKills) {
  const KillMatrix matrix = matrix_of({{0, 2}, {0, 1}});
  EXPECT_EQ(smallest_team(matrix), (std::vector<std::size_t>{0}));
  EXPECT_EQ(survivors(matrix), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(smallest_team(matrix_of({{0, 0}})).empty());
}

TEST(BestKiller, IsTheFirstOfEquals) {
  EXPECT_EQ(best_killer(matrix_of({{1}, {3}, {3}}), 0), 1U);
  EXPECT_EQ(best_killer(matrix_of({{0}, {0}}), 0), std::nullopt);
}

TEST(BlamesTheAv, OnlyForWhatCouldHaveBeenAvoided) {
  const auto assessment = [](Verdict verdict) {
    return TestAssessment{.judgements = {{.verdict = Verdict::pass}, {.verdict = verdict}}};
  };
  EXPECT_TRUE(blames_the_av(assessment(Verdict::fail)));
  EXPECT_FALSE(blames_the_av(assessment(Verdict::unavoidable)));
  EXPECT_FALSE(blames_the_av(assessment(Verdict::vacuous)));
}

TEST(KillsCsv, HasARowForEachBehaviourAndDefect) {
  KillMatrix matrix = matrix_of({{5, 0}});
  matrix.defects = {"latency=0.3", "blind-left"};
  EXPECT_EQ(to_kills_csv(matrix),
            "behaviour,agents,defect,severity,tests,kills,kill_pct,low,high,first_kill_median\n"
            "r0,1,latency,0.3,10,5,50,23.659309,76.340691,1\n"
            "r0,1,blind-left,,10,0,0,0,27.75328,\n");
}

TEST(KillTableText, TellsWhoKillsWhatAndWhatNobodyDoes) {
  Comparison comparison;
  comparison.kills = matrix_of({{5, 0}, {1, 0}});
  const std::string text = render_kills(comparison);
  EXPECT_NE(text.find("r0 (1)        5   25.00    1 /  2           1"), std::string::npos) << text;
  EXPECT_NE(text.find("a       2 of 2; best r0 (1): 5 of 10"), std::string::npos) << text;
  EXPECT_NE(text.find("b       nobody"), std::string::npos) << text;
  EXPECT_NE(text.find("kills all that anybody kills: r0 (1)"), std::string::npos) << text;
}

TEST(RankCorrelation, IsSpearmansWithSharedRanks) {
  EXPECT_DOUBLE_EQ(*rank_correlation(std::vector{1.0, 2.0, 9.0}, std::vector{3.0, 5.0, 6.0}), 1);
  EXPECT_DOUBLE_EQ(*rank_correlation(std::vector{1.0, 2.0, 9.0}, std::vector{6.0, 5.0, 3.0}), -1);
  // Ranks 1, 2.5, 2.5, 4 and 1, 2, 3, 4.
  EXPECT_NEAR(*rank_correlation(std::vector{1.0, 2.0, 2.0, 9.0}, std::vector{1.0, 2.0, 3.0, 4.0}),
              0.9486832980505138, 1e-12);
  EXPECT_FALSE(rank_correlation(std::vector{1.0, 1.0}, std::vector{1.0, 2.0}));
}

constexpr auto kHeader =
    "behaviour,agents,defect,severity,tests,kills,kill_pct,low,high,first_kill_median\n";

Result<std::vector<KillLine>> parse(const std::string& lines) {
  return parse_kills(std::make_shared<const Source>("kills.csv", kHeader + lines));
}

std::string errors_of(const std::string& lines) {
  const auto parsed = parse(lines);
  return parsed.ok() ? std::string() : parsed.diagnostics().render();
}

TEST(KillsFile, HasWhatWasWritten) {
  KillMatrix matrix{.defects = {"latency=0.3", "blind-left", "given"}, .rows = {}};
  matrix.rows.push_back(
      {.behaviour = "by-the-text", .agents = 2, .cells = {cell(10, 3), cell(0, 0), cell(7, 0)}});
  const std::string text = to_kills_csv(matrix);
  const auto lines = parse_kills(std::make_shared<const Source>("kills.csv", text));
  ASSERT_TRUE(lines.ok()) << lines.diagnostics().render();
  KillMatrix again{.defects = matrix.defects, .rows = {}};
  add_kills(lines.value(), again);
  EXPECT_EQ(to_kills_csv(again), text);
  ASSERT_EQ(again.rows.size(), 1U);
  EXPECT_TRUE(again.rows[0].kills_alone);
  EXPECT_EQ(again.rows[0].behaviour, "by-the-text");
}

TEST(KillsFile, KeepsTheFirstKillOfTestsWhoseOrderMatters) {
  const auto lines = parse("s,1,latency,0.3,10,5,50,0,0,7\ns,1,blind-left,,10,1,10,0,0,\n");
  ASSERT_TRUE(lines.ok()) << lines.diagnostics().render();
  KillMatrix matrix{.defects = {"latency=0.3", "blind-left"}, .rows = {}};
  add_kills(lines.value(), matrix);
  EXPECT_EQ(first_kill_median(matrix.rows.at(0).cells[0]), 7U);
  // Most repetitions of the search never killed it.
  EXPECT_EQ(first_kill_median(matrix.rows.at(0).cells[1]), std::nullopt);
}

TEST(KillsFile, PointsAtMistakes) {
  EXPECT_THAT(errors_of("s,1,latncy,0.3,10,5,50,0,0,7\n"),
              HasSubstr("kills.csv:2:5: error: unknown defect 'latncy=0.3'"));
  EXPECT_THAT(errors_of("s,1,latency,0.3,10,11,50,0,0,7\n"),
              HasSubstr("kills.csv:2:20: error: expected a whole number up to 10, found '11'"));
  EXPECT_THAT(errors_of("s,one,latency,0.3,10,5,50,0,0,7\n"), HasSubstr("found 'one'"));
  EXPECT_THAT(errors_of("=HYPERLINK(1),1,latency,0.3,10,5,50,0,0,7\n"),
              HasSubstr("kills.csv:2:1: error: '=HYPERLINK(1)' cannot be the name of a behaviour"));
  EXPECT_THAT(errors_of("s,1,latency\n"), HasSubstr("expected 10 fields, found 3"));
  EXPECT_THAT(errors_of("s,1,latency,0.3,10,5,50,0,0,7\ns,1,latency,0.30,10,5,50,0,0,7\n"),
              HasSubstr("kills.csv:3:1: error: a second line for s (1) and latency=0.3"));
  const auto other = parse_kills(std::make_shared<const Source>("x.csv", "a,b\n1,2\n"));
  EXPECT_THAT(other.diagnostics().render(), HasSubstr("x.csv:1:1: error: expected the header"));
  EXPECT_FALSE(parse_kills(std::make_shared<const Source>("x.csv", "")).ok());
}

TEST(KillsFile, StandsBesideRowsOfOtherNamesAlone) {
  const ExperimentPlan planned{.behaviours = {"p", "q"},
                               .agents = {1, 3},
                               .tests = 4,
                               .vehicles = {"healthy", "latency=0.3"}};
  const auto lines = parse("s,1,latency,0.3,10,5,50,0,0,7\ns,1,blind-left,,10,1,10,0,0,\n").value();
  EXPECT_FALSE(mistakes_of(lines, planned, {}).has_errors());
  EXPECT_EQ(other_defects(lines, planned), std::vector<std::string>{"blind-left"});
  EXPECT_THAT(mistakes_of(lines, planned, lines).render(),
              HasSubstr("a second row s (1) beside the same one"));
  const auto mine = parse("p,3,latency,0.3,10,5,50,0,0,7\np,2,latency,0.3,10,5,50,0,0,7\n").value();
  EXPECT_THAT(mistakes_of(mine, planned, {}).render(), HasSubstr("a second row p (3)"));
  const auto foreign = parse("s,1,blind-left,,10,1,10,0,0,\n").value();
  EXPECT_THAT(mistakes_of(foreign, planned, {}).render(),
              HasSubstr("none of these defects is looked for here"));
}

// Their share of kills is no reason to believe that accuracy predicts it.
TEST(Predictors, LeaveOutRowsOfWhichOnlyKillsAreKnown) {
  Comparison comparison;
  comparison.kills = matrix_of({{1}, {2}, {3}});
  for (const KillRow& row : comparison.kills.rows) {
    Summary summary{.behaviour = row.behaviour, .agents = 1, .tests = 10};
    summary.successes = 4 * comparison.summaries.size();
    comparison.summaries.push_back(summary);
  }
  ASSERT_FALSE(predictors(comparison).empty());
  comparison.kills.rows[1].kills_alone = true;
  EXPECT_TRUE(predictors(comparison).empty());
}

}  // namespace
}  // namespace jaywalk
