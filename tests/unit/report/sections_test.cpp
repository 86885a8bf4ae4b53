// SPDX-License-Identifier: Apache-2.0
// Sections of the report by data made by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/report.h"

namespace jaywalk::reporting {
namespace {

using testing::HasSubstr;
using testing::Not;

Summary summary(const char* behaviour, std::uint32_t agents, std::uint64_t successes) {
  return {.behaviour = behaviour,
          .agents = agents,
          .tests = 100,
          .successes = successes,
          .score = {.count = successes, .mean = 30, .squares = 10},
          .ticks_all = {.count = 100, .mean = 8, .squares = 10},
          .cpu_us = {.count = 100, .mean = 2.5},
          .code_lines = 12};
}

/// Two behaviours with one and three agents.
ReportData data_of_two() {
  ReportData data;
  data.comparison = {.scenario = "s.yaml", .seed = 7, .tests = 100};
  data.comparison.summaries = {summary("walk", 1, 40), summary("walk", 3, 60),
                               summary("<run>", 1, 80), summary("<run>", 3, 20)};
  data.description.scenario = "s.yaml";
  data.description.behaviours = {{.name = "walk"}, {.name = "<run>"}};
  data.description.agents = {1, 3};
  data.description.tests = 100;
  data.description.seed = 7;
  return data;
}

TEST(OverviewSection, SaysWhatWasRun) {
  const std::string html = section::overview(data_of_two());
  EXPECT_THAT(html, HasSubstr("<dt>scenario</dt><dd><code>s.yaml</code></dd>"));
  EXPECT_THAT(html, HasSubstr("<dd>walk, &lt;run&gt;</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>numbers of agents</dt><dd>1, 3</dd>"));
  EXPECT_THAT(html, HasSubstr("100 for each behaviour and number of agents, 400 in all"));
  EXPECT_THAT(html, HasSubstr("<dt>seed</dt><dd>7</dd>"));
  EXPECT_THAT(html, Not(HasSubstr("shard")));
  EXPECT_THAT(html, Not(HasSubstr("warn")));
}

TEST(OverviewSection, SaysAtHowManyAgentsABehaviourIsBest) {
  const std::string html = section::overview(data_of_two());
  EXPECT_THAT(html, HasSubstr("60.0 <small>at 3</small>")) << "of walk";
  EXPECT_THAT(html, HasSubstr("80.0 <small>at 1</small>")) << "of run";
}

TEST(OverviewSection, SaysWhatIsSpecialAboutTheRun) {
  ReportData data = data_of_two();
  data.comparison.complete = false;
  data.description.preset = "paper";
  data.description.sets = {"world.av.speed=<3>"};
  data.description.shard = {.index = 2, .count = 5};
  data.store_path = "r.gpkg";
  const std::string html = section::overview(data);
  EXPECT_THAT(html, HasSubstr("Not all tests were run"));
  EXPECT_THAT(html, HasSubstr("<dt>preset</dt><dd>paper</dd>"));
  EXPECT_THAT(html, HasSubstr("world.av.speed=&lt;3&gt;"));
  EXPECT_THAT(html, HasSubstr("<dd>2 of 5</dd>"));
  EXPECT_THAT(html, HasSubstr("<code>r.gpkg</code>"));
}

TEST(OverviewSection, SaysThatNothingIsFinished) {
  EXPECT_THAT(section::overview({}), HasSubstr("No row is finished yet."));
}

TEST(AvsSection, IsLeftOutWithoutModels) { EXPECT_EQ(section::avs(data_of_two()), ""); }

AvRanking ranking(bool judged) {
  const auto cell = [](std::uint64_t collisions, std::uint64_t avoidable) {
    return AvCell{.tests = 100,
                  .successes = 50,
                  .collisions = collisions,
                  .avoidable = avoidable,
                  .unavoidable = collisions - avoidable,
                  .impact_um_s = static_cast<std::int64_t>(collisions) * 4'000'000};
  };
  AvRanking ranking{.avs = {"idm", "<aeb>"}, .judged = judged};
  ranking.rows = {{.behaviour = "walk", .agents = 1, .cells = {cell(20, 10), cell(10, 1)}}};
  return ranking;
}

TEST(AvsSection, RanksModelsAndShowsEachShare) {
  ReportData data = data_of_two();
  data.comparison.avs = ranking(true);
  const std::string html = section::avs(data);
  EXPECT_LT(html.find(">&lt;aeb&gt;<"), html.find(">idm<")) << "fewer avoidable collisions";
  EXPECT_THAT(html, HasSubstr("title=\"20 of 100 tests ("));
  EXPECT_THAT(html, HasSubstr("--share:0.20"));
  EXPECT_THAT(html, HasSubstr("<h3>Avoidable collisions, % of the tests</h3>"));
  EXPECT_THAT(html, HasSubstr("4.00"));
}

TEST(AvsSection, SaysNothingOfBlameWhereNothingWasJudged) {
  ReportData data = data_of_two();
  data.comparison.avs = ranking(false);
  EXPECT_THAT(section::avs(data), Not(HasSubstr("<h3>Avoidable")));
}

TEST(VerdictsSection, SaysHowToJudgeWhereNothingWas) {
  ReportData data = data_of_two();
  EXPECT_THAT(section::verdicts(data), HasSubstr("None were judged: <code>--assertions FILE"));
}

ReportData judged() {
  ReportData data = data_of_two();
  data.comparison.assertions = {"away"};
  for (int row = 0; row < 4; ++row) {
    AssessmentSummary assessment{.verdicts = {{.tests = {50, 30, 15, 5}}}};
    assessment.robustness = {distribution({-2, 0.5, 3})};
    data.comparison.assessments.push_back(assessment);
  }
  return data;
}

TEST(VerdictsSection, ShowsSharesOfAllNumbersOfAgentsTogether) {
  const std::string html = section::verdicts(judged());
  // Of walk's 200 tests 60 passed and 100 were vacuous.
  EXPECT_THAT(html, HasSubstr("<title>walk: pass 30.0 %</title>"));
  EXPECT_THAT(html, HasSubstr("<title>walk: vacuous 50.0 %</title>"));
  EXPECT_THAT(html, HasSubstr("<title>&lt;run&gt;: fail 15.0 %</title>"));
}

TEST(VerdictsSection, HasItsNumbersAsTables) {
  const std::string html = section::verdicts(judged());
  EXPECT_THAT(html, HasSubstr("<td>50.0</td><td>30</td><td>15</td><td>5</td><td>50</td>"
                              "<td>-2.000</td><td>0.500</td><td>3.000</td>"));
}

TEST(VerdictsSection, NamesWhatAnAssertionDemandsAndItsSource) {
  ReportData data = judged();
  Assertion away;
  away.id = "away";
  away.summary = "keeps a distance > 1";
  away.source = "a rule";
  data.assertions.push_back(std::move(away));
  EXPECT_THAT(section::verdicts(data),
              HasSubstr("away<small>major, keeps a distance &gt; 1 — a rule</small>"));
}

TEST(VerdictsSection, ListsEachBehavioursWorstViolation) {
  ReportData data = judged();
  EXPECT_THAT(section::verdicts(data), Not(HasSubstr("worst violation")));
  data.violations = {{.assertion = "away",
                      .test = {.behaviour = 1, .agents = 3, .number = 17},
                      .robustness = -0.25,
                      .tick = 4,
                      .witness = "p2"}};
  EXPECT_THAT(section::verdicts(data),
              HasSubstr("<td class=\"l\">&lt;run&gt;</td><td>3</td><td>17</td><td>-0.250</td>"
                        "<td>4</td><td class=\"l\">p2</td>"));
}

TEST(VerdictsSection, LinksAViolationWithTheMomentOnItsPage) {
  ReportData data = judged();
  const TestKey test{.behaviour = 1, .agents = 3, .number = 17};
  data.violations = {{.assertion = "away", .test = test, .robustness = -0.25, .tick = 4},
                     {.assertion = "away", .test = {.behaviour = 0, .agents = 3, .number = 17}}};
  data.replays = {{.test = test}};
  EXPECT_THAT(section::verdicts(data), HasSubstr("<td>17</td>")) << "no page was written";
  data.replays[0].page = "r #1-replays/a.html";
  const std::string html = section::verdicts(data);
  EXPECT_THAT(html,
              HasSubstr("<td>3</td><td><a href=\"r%20%231-replays/a.html#tick=4\">17</a></td>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"l\">walk</td><td>3</td><td>17</td>"));
  data.violations[0].tick.reset();
  EXPECT_THAT(section::verdicts(data), HasSubstr("<a href=\"r%20%231-replays/a.html\">17</a>"));
}

TEST(MetricsSection, SaysHowToMeasureWhereNothingWas) {
  EXPECT_THAT(section::metrics(data_of_two()), HasSubstr("<code>--metrics</code>"));
}

TEST(MetricsSection, HasABoxForEachBehaviourAndNumberOfAgents) {
  ReportData data = data_of_two();
  for (int row = 0; row < 4; ++row) {
    AssessmentSummary assessment;
    assessment.metrics.resize(jaywalk::metrics().size());
    assessment.metrics[0] = distribution({1, 2, 3, 4, 5});
    data.comparison.assessments.push_back(assessment);
  }
  const std::string html = section::metrics(data);
  EXPECT_THAT(html, HasSubstr("median 3, quartiles 2 and 4, from 1 to 5, 5 tests"));
  EXPECT_THAT(html, HasSubstr("<td>1</td><td>5</td><td>3.000</td><td>1.000</td><td>2.000</td>"));
  EXPECT_THAT(html, HasSubstr("<td>1</td><td>0</td><td>–</td>")) << "of the other metrics";
}

TEST(KillsSection, IsLeftOutWithoutDefects) { EXPECT_EQ(section::kills(data_of_two()), ""); }

ReportData with_kills() {
  ReportData data = data_of_two();
  data.comparison.kills.defects = {"latency=0.3", "blind-left", "creeps=0.5"};
  for (const Summary& each : data.comparison.summaries) {
    data.comparison.kills.rows.push_back(
        {.behaviour = each.behaviour,
         .agents = each.agents,
         .cells = {
             {.tests = 100, .kills = 25, .first = 2}, {.tests = 100, .kills = 0}, {.tests = 0}}});
  }
  return data;
}

TEST(KillsSection, ShowsTheShareOfEachPair) {
  const std::string html = section::kills(with_kills());
  EXPECT_THAT(html, HasSubstr("title=\"25 of 100 tests ("));
  EXPECT_THAT(html, HasSubstr("first kill after 3\">25.0</span>"));
  EXPECT_THAT(html, HasSubstr("<span class=\"note\">0</span>"));
  EXPECT_THAT(html, HasSubstr(">–<")) << "whose tests are not finished";
}

TEST(KillsSection, SaysWhoKillsAndWhatNobodyDoes) {
  const std::string html = section::kills(with_kills());
  EXPECT_THAT(html, HasSubstr("<dd>walk (1)</dd>")) << "the first of equals";
  EXPECT_THAT(html, HasSubstr("<dd>blind-left, creeps=0.5</dd>"));
  EXPECT_THAT(html, HasSubstr("&lt;run&gt; (3)"));
}

TEST(KillsSection, DrawsTheMutationScoreForEachNumberOfAgents) {
  const std::string html = section::kills(with_kills());
  EXPECT_THAT(html, HasSubstr("defects killed, %, 1 agent<"));
  EXPECT_THAT(html, HasSubstr("defects killed, %, 3 agents<"));
}

TEST(AgentsSection, IsLeftOutWhereNothingWentWrong) {
  EXPECT_EQ(section::agents(data_of_two()), "");
}

TEST(ReproduceSection, HasTheCommand) {
  ReportData data = data_of_two();
  data.description.scenario = "my file.yaml";
  data.description.preset = "paper";
  data.description.sets = {"world.tick=0.5"};
  data.description.assertion_files = {"a.yaml"};
  data.description.metrics = true;
  data.description.shard = {.index = 1, .count = 2};
  const std::string html = section::reproduce(data);
  EXPECT_THAT(html, HasSubstr("jaywalk compare"));
  EXPECT_THAT(html, HasSubstr("--seed 7 --tests 100 --agents 1,3 --preset paper --set "
                              "world.tick=0.5 --assertions a.yaml --metrics --shard 1/2</pre>"));
  EXPECT_THAT(html, Not(HasSubstr("compare my file.yaml"))) << "quoted for a shell";
  EXPECT_THAT(html, Not(HasSubstr("jaywalk replay")));
}

TEST(ReproduceSection, SaysHowToRunAStoresTests) {
  ReportData data = data_of_two();
  data.store_path = "r.gpkg";
  EXPECT_THAT(section::reproduce(data), HasSubstr("jaywalk replay r.gpkg --test N"));
}

TEST(ReproduceSection, ListsTheFilesWithTheirHashes) {
  ReportData data = data_of_two();
  data.description.inputs = {{.path = "a<b.asl", .text = "+!g.", .sha256 = "00ff"}};
  EXPECT_THAT(section::reproduce(data),
              HasSubstr("<code>a&lt;b.asl</code></td><td>4</td><td class=\"l\"><code>00ff</code>"));
}

}  // namespace
}  // namespace jaywalk::reporting
