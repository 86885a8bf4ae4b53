// SPDX-License-Identifier: Apache-2.0
// Tables for the terminal and for Markdown.

#include "experiment/report/tables/tables.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/export/comparison_files.h"
#include "experiment/report/stored_coverage.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Summary summary_of(const std::string& behaviour, std::uint32_t agents) {
  return {.behaviour = behaviour,
          .agents = agents,
          .tests = 10,
          .successes = 5,
          .score = {.count = 5, .mean = 30, .squares = 0},
          .ticks_success = {.count = 5, .mean = 4, .squares = 0},
          .ticks_all = {.count = 10, .mean = 7.5, .squares = 0},
          .cpu_us = {.count = 10, .mean = 2},
          .wall_us = {.count = 10, .mean = 3}};
}

TEST(Markdown, HasAColumnForEachMeasure) {
  Comparison comparison;
  comparison.summaries = {summary_of("walk", 3)};
  const std::string text = to_markdown(comparison);
  EXPECT_THAT(text,
              StartsWith("| behaviour | agents | tests | successes | errored | accuracy_pct |"));
  const auto columns = [](std::string_view line) { return std::ranges::count(line, '|'); };
  const std::size_t first = text.find('\n');
  const std::size_t second = text.find('\n', first + 1);
  EXPECT_EQ(columns(text.substr(0, first)), columns(text.substr(first, second - first)));
  EXPECT_EQ(columns(text.substr(0, first)), columns(text.substr(second)));
}

TEST(Markdown, WritesIntervalsAndWhatIsMissing) {
  Comparison comparison;
  comparison.summaries = {summary_of("walk", 3), {.behaviour = "idle", .agents = 1, .tests = 4}};
  const std::string text = to_markdown(comparison);
  EXPECT_THAT(text, HasSubstr("| walk | 3 | 10 | 5 | 0.00 | 50.00 (23.66 to 76.34) |"));
  EXPECT_THAT(text, HasSubstr("| idle | 1 | 4 | 0 | 0.00 | 0.00 (0.00 to 48.99) | – |"));
}

TEST(Markdown, KeepsNamesFromEndingTheirCells) {
  Comparison comparison;
  comparison.summaries = {summary_of("a|b\nc", 1)};
  EXPECT_THAT(to_markdown(comparison), HasSubstr("\n| a\\|b c | 1 |"));
}

VerdictCounts verdicts(std::uint64_t vacuous, std::uint64_t pass, std::uint64_t fail,
                       std::uint64_t unavoidable) {
  return {.tests = {vacuous, pass, fail, unavoidable}};
}

TEST(VerdictTable, HasARowForEachAssertionOfEachBehaviour) {
  Comparison comparison{.assertions = {"away", "slow"}};
  comparison.summaries = {summary_of("walk", 1), summary_of("walk", 3), summary_of("run", 1)};
  comparison.assessments = {{.verdicts = {verdicts(5, 3, 1, 1), verdicts(10, 0, 0, 0)}},
                            {.verdicts = {verdicts(0, 10, 0, 0), verdicts(0, 0, 10, 0)}},
                            {.verdicts = {verdicts(9, 1, 0, 0), verdicts(9, 0, 0, 1)}}};
  EXPECT_EQ(render_verdicts(comparison),
            "verdicts                agents  exercised %     pass     fail  unavoidable\n"
            "walk\n"
            "  away                       1         50.0        3        1            1\n"
            "  slow                       1          0.0        0        0            0\n"
            "  away                       3        100.0       10        0            0\n"
            "  slow                       3        100.0        0       10            0\n"
            "run\n"
            "  away                       1         10.0        1        0            0\n"
            "  slow                       1         10.0        0        0            1\n");
}

TEST(VerdictTable, IsEmptyWhereNothingWasJudged) {
  Comparison comparison;
  comparison.summaries = {summary_of("walk", 1)};
  EXPECT_EQ(render_verdicts(comparison), "");
  EXPECT_EQ(render_metrics(comparison), "");
}

TEST(MetricTable, HasADashWhereNoTestHasAValue) {
  Comparison comparison;
  comparison.summaries = {summary_of("walk", 1)};
  AssessmentSummary assessment;
  assessment.metrics.resize(metrics().size());
  assessment.metrics[0] = distribution({1, 2, 6});
  comparison.assessments = {assessment};
  const std::string text = render_metrics(comparison);
  EXPECT_THAT(text, StartsWith("metrics              agents   tests      mean       min    median"
                               "       max\nwalk\n"
                               "  min_distance            1       3     3.000     1.000     2.000"
                               "     6.000\n"
                               "  min_distance_time       1       0         -         -         -"
                               "         -\n"));
}

Criteria criteria_of(std::vector<std::string> ids) {
  Criteria criteria{.metrics = true};
  for (std::string& id : ids) {
    Assertion assertion;
    assertion.id = std::move(id);
    criteria.assertions.push_back(std::move(assertion));
  }
  return criteria;
}

const std::vector<Actor> kActors{{"av", ActorKind::vehicle, 4, 2},
                                 {"p1", ActorKind::pedestrian, 0.5, 0.5},
                                 {"p2", ActorKind::pedestrian, 0.5, 0.5}};

TEST(AssessmentText, SaysVerdictsWithTheirReasons) {
  TestAssessment assessment;
  assessment.judgements = {
      {.verdict = Verdict::fail, .robustness = -0.25, .tick = 4, .witnesses = {1, 2}},
      {.verdict = Verdict::pass, .robustness = 2.5},
      {.verdict = Verdict::vacuous, .exercised = -1.5}};
  EXPECT_EQ(render_assessment(criteria_of({"away", "slow", "zebra"}), assessment, kActors),
            "away                    fail         robustness -0.25, violated at tick 4 (p1, p2)\n"
            "slow                    pass         robustness 2.5\n"
            "zebra                   vacuous      precondition missed by 1.5\n");
}

TEST(AssessmentText, SaysTheMetricsThatHaveValues) {
  TestAssessment assessment;
  assessment.metrics.resize(metrics().size());
  assessment.metrics[0] = MetricValue{.value = 0.75, .tick = 3, .actor = 2};
  EXPECT_EQ(render_assessment(criteria_of({}), assessment, kActors),
            "min_distance            0.75 m at tick 3 (p2)\n");
}

TEST(AssessmentText, LeavesOutTheUnitOfANumberWithoutOne) {
  TestAssessment assessment;
  assessment.metrics.resize(metrics().size());
  const auto btn = static_cast<std::size_t>(find_metric("max_btn") - metrics().data());
  assessment.metrics[btn] = MetricValue{.value = 1.2, .tick = 3, .actor = 1};
  EXPECT_EQ(render_assessment(criteria_of({}), assessment, kActors),
            "max_btn                 1.2 at tick 3 (p1)\n");
}

AvCell av_cell(std::uint64_t tests, std::uint64_t successes, std::uint64_t collisions,
               std::uint64_t avoidable, std::int64_t impact_um_s) {
  return {.tests = tests,
          .successes = successes,
          .collisions = collisions,
          .avoidable = avoidable,
          .unavoidable = collisions - avoidable,
          .impact_um_s = impact_um_s};
}

AvRanking ranking_of_two() {
  AvRanking ranking{.avs = {"constant", "aeb"}, .judged = true};
  ranking.rows = {{.behaviour = "walk",
                   .agents = 1,
                   .cells = {av_cell(10, 5, 4, 3, 20'000'000), av_cell(10, 5, 1, 0, 2'000'000)}},
                  {.behaviour = "walk",
                   .agents = 3,
                   .cells = {av_cell(10, 7, 6, 5, 40'000'000), av_cell(10, 6, 2, 1, 7'000'000)}}};
  return ranking;
}

TEST(AvCells, AddUpAndHaveAMeanImpact) {
  AvCell all = av_cell(10, 5, 4, 3, 20'000'000);
  all += av_cell(10, 7, 6, 5, 40'000'000);
  EXPECT_EQ(all.tests, 20U);
  EXPECT_EQ(all.collisions, 10U);
  EXPECT_DOUBLE_EQ(*all.mean_impact_mps(), 6);
  EXPECT_DOUBLE_EQ(share_pct(all.avoidable, all), 40);
  EXPECT_EQ(AvCell{}.mean_impact_mps(), std::nullopt);
  EXPECT_EQ(share_pct(0, AvCell{}), 0);
}

TEST(AvTable, RanksThoseWithTheFewestAvoidableCollisionsFirst) {
  EXPECT_EQ(
      render_avs(ranking_of_two()),
      "AV models     tests  accuracy %  collisions %  avoidable %  unavoidable %  impact m/s\n"
      "1. aeb           20       55.00         15.00         5.00          10.00        3.00\n"
      "2. constant       20       60.00         50.00        40.00          10.00        6.00\n"
      "walk (1)\n"
      "  constant       10       50.00         40.00        30.00          10.00        5.00\n"
      "  aeb            10       50.00         10.00         0.00          10.00        2.00\n"
      "walk (3)\n"
      "  constant       10       70.00         60.00        50.00          10.00        6.67\n"
      "  aeb            10       60.00         20.00        10.00          10.00        3.50\n");
}

TEST(AvTable, KnowsNothingAvoidableWhereNothingWasJudged) {
  AvRanking ranking = ranking_of_two();
  ranking.judged = false;
  EXPECT_THAT(
      render_avs(ranking),
      HasSubstr("1. aeb           20       55.00         15.00            -              -"));
}

TEST(AvTable, LeavesOutWhatIsNotFinishedAndCountsWhatEndedErrored) {
  AvRanking ranking = ranking_of_two();
  ranking.rows[0].cells[1] = {};
  ranking.rows[1].cells[1] = {};
  ranking.rows[1].cells[0].errored = 2;
  const std::string text = render_avs(ranking);
  EXPECT_THAT(text, Not(HasSubstr("aeb")));
  EXPECT_THAT(text, HasSubstr("1. constant"));
  EXPECT_THAT(text, testing::EndsWith("\nwithout 2 tests that ended errored\n"));
  EXPECT_EQ(render_avs({}), "");
}

KillMatrix two_killers() {
  KillMatrix matrix{.defects = {"latency=0.3", "blind-left"}};
  matrix.rows = {
      {.behaviour = "walk",
       .agents = 1,
       .healthy_failures = 1,
       .cells = {{.tests = 10, .kills = 5, .first = 2}, {.tests = 10, .kills = 0}}},
      {.behaviour = "run",
       .agents = 3,
       .cells = {{.tests = 10, .kills = 1, .first = 9}, {.tests = 10, .kills = 2, .first = 1}}}};
  return matrix;
}

TEST(KillTable, SaysWhatEachKillsAndWhoKillsEach) {
  const std::string text = render_kills(two_killers());
  EXPECT_THAT(text, HasSubstr("walk (1)           5   25.00    1 /  2"));
  EXPECT_THAT(text, HasSubstr("run (3)            3   15.00    2 /  2"));
  EXPECT_THAT(text, HasSubstr("latency=0.3  2 of 2; best walk (1): 5 of 10 ("));
  EXPECT_THAT(text, HasSubstr("blind-left   1 of 2; best run (3): 2 of 10 ("));
  EXPECT_THAT(text,
              testing::EndsWith("smallest team that kills all that anybody kills: run (3)\n"));
}

TEST(KillTable, SaysWhereNobodyKills) {
  KillMatrix matrix = two_killers();
  matrix.rows.pop_back();
  EXPECT_THAT(render_kills(matrix), HasSubstr("blind-left   nobody\n"));
  matrix.rows[0].cells[0].kills = 0;
  EXPECT_THAT(render_kills(matrix), Not(HasSubstr("smallest team")));
  EXPECT_EQ(render_kills(KillMatrix{}), "");
}

TEST(KillTable, SaysWhichTestsAreLeftOut) {
  KillMatrix matrix = two_killers();
  matrix.rows[0].cells[0].errored = 2;
  EXPECT_THAT(render_kills(matrix),
              HasSubstr("walk (1): without 2 tests that ended errored, with the healthy AV or the "
                        "defective one\n"));
}

TEST(KillTable, SaysNothingOfTheHealthyAvWhereThatIsNotKnown) {
  KillMatrix matrix = two_killers();
  matrix.rows.resize(1);
  EXPECT_THAT(render_kills(matrix), HasSubstr("                1\n")) << "one healthy failure";
  matrix.rows[0].kills_alone = true;
  EXPECT_THAT(render_kills(matrix), HasSubstr("                -\n"));
}

/// Bins of one test: that of the first item alone, or of the first and the second.
SituationBins bins_of(std::optional<std::uint32_t> first,
                      std::optional<std::uint32_t> second = {}) {
  SituationBins bins(situation_items().size());
  bins[0] = first;
  bins[1] = second;
  return bins;
}

SituationRow covering_row() {
  SituationRow row{.behaviour = "walk", .agents = 1};
  for (int i = 0; i < 3; ++i) row.coverage.add(bins_of(0));
  row.coverage.add(bins_of(1, 2));
  return row;
}

TEST(SituationTable, CountsBinsAndTheTestsUntilThem) {
  const std::string text = situation_text({covering_row()});
  // 3 bins after 4 tests; half of them, 1.5, are there after 4 tests, too.
  EXPECT_THAT(text, HasSubstr("walk           1        4      3 of "));
  EXPECT_THAT(text, HasSubstr("          4          4\n"));
  EXPECT_THAT(text,
              HasSubstr("\nstart_side (side of the AV's lane where the pedestrian started): 2 "
                        "of 2\n"
                        "  left                                        3\n"
                        "  right                                       1\n"));
  EXPECT_THAT(text, HasSubstr("  1st sixth                                hole\n"));
}

TEST(SituationTable, CallsNoHoleWhatNoTestCanCover) {
  SituationRow row = covering_row();
  row.reachable.resize(situation_items().size());
  for (std::size_t i = 0; i < row.reachable.size(); ++i) {
    row.reachable[i].assign(situation_items()[i].bins.size(), true);
  }
  row.reachable[1][0] = false;
  const std::string text = situation_text({row});
  EXPECT_THAT(text, HasSubstr("  1st sixth                               never\n"));
  EXPECT_THAT(text, HasSubstr("in sixths of its length): 1 of 5\n"));
  EXPECT_THAT(text, Not(HasSubstr("another world")));
}

TEST(SituationTable, SaysWhereWhatCannotBeWasCovered) {
  SituationRow row = covering_row();
  row.reachable.resize(situation_items().size());
  for (std::size_t i = 0; i < row.reachable.size(); ++i) {
    row.reachable[i].assign(situation_items()[i].bins.size(), true);
  }
  row.reachable[0][1] = false;
  EXPECT_THAT(situation_text({row}),
              HasSubstr("experiment.reachable is of another world: 1 bins that it leaves out"));
}

TEST(SituationTable, OfSeveralRowsAddsThemUp) {
  SituationRow other{.behaviour = "run", .agents = 3};
  other.coverage.add(bins_of(1));
  const std::string text = situation_text({covering_row(), other});
  EXPECT_THAT(text, HasSubstr("  right                                       2\n"));
}

TEST(SituationCsv, HasALineForEachBin) {
  const std::string csv = situation_csv({covering_row()});
  EXPECT_THAT(csv, StartsWith("behaviour,agents,tests,item,bin,name,times\n"
                              "walk,1,4,start_side,1,\"left\",3\n"
                              "walk,1,4,start_side,2,\"right\",1\n"
                              "walk,1,4,start_band,1,\"1st sixth\",0\n"));
  std::size_t bins = 0;
  for (const SituationItem& item : situation_items()) bins += item.bins.size();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), bins + 1);
}

TEST(SituationJson, HasItemsAndCounts) {
  const auto json = nlohmann::json::parse(situation_json({covering_row()}));
  EXPECT_EQ(json["items"][0]["name"], "start_side");
  EXPECT_EQ(json["results"][0]["tests"], 4);
  EXPECT_EQ(json["results"][0]["covered"], 3);
  EXPECT_EQ(json["results"][0]["times"][0], nlohmann::json::parse("[3, 1]"));
  EXPECT_EQ(json["results"][0]["growth"], nlohmann::json::parse("[[1, 1], [4, 3]]"));
}

TEST(ReachableWith, IsKnownOfOneAgentAlone) {
  const ReachableBins reachable{{true, false}};
  EXPECT_EQ(reachable_with(reachable, 1), reachable);
  EXPECT_TRUE(reachable_with(reachable, 2).empty());
}

}  // namespace
}  // namespace jaywalk
