// SPDX-License-Identifier: Apache-2.0
// Sections that draw on the world's ground: where preconditions were met, tests to look at.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/report.h"
#include "tests/unit/report/world.h"

namespace jaywalk::reporting {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Behaviours on the crossing of the paper, with one and two agents each; no precondition was met.
ReportData data_of(const std::vector<std::string>& behaviours) {
  ReportData data;
  data.prepared = world_of("proximity");
  for (const std::string& name : behaviours) {
    data.description.behaviours.push_back({.name = name});
    for (const std::uint32_t agents : {1U, 2U}) {
      data.comparison.summaries.push_back({.behaviour = name, .agents = agents, .tests = 10});
    }
  }
  data.facts.resize(data.comparison.summaries.size());
  return data;
}

TEST(PlacesSection, IsLeftOutWhereNothingIsKnownOfTests) {
  ReportData data = data_of({"walk"});
  data.facts.clear();
  EXPECT_EQ(section::places(data), "");
}

TEST(PlacesSection, HasAPictureForEachBehaviourThoughNobodyMetIt) {
  const std::string html = section::places(data_of({"walk", "<run>"}));
  EXPECT_EQ(times(html, "<figure"), 2U);
  EXPECT_EQ(times(html, "nobody met it"), 2U);
  EXPECT_THAT(html, HasSubstr("&lt;run&gt;<small>"));
  EXPECT_THAT(html, Not(HasSubstr("class=\"heat\""))) << "nor is there a scale of nothing";
}

TEST(PlacesSection, AddsUpAllNumbersOfAgents) {
  ReportData data = data_of({"walk", "run"});
  data.facts[0].places[{5, 40}] = 2;
  data.facts[1].places[{5, 40}] = 1;
  data.facts[3].places[{5, 40}] = 9;
  const std::string html = section::places(data);
  EXPECT_THAT(html, HasSubstr("walk<small>3 agents; most at"));
  EXPECT_THAT(html, HasSubstr("run<small>9 agents; most at"));
}

TEST(PlacesSection, SaysWhereTheMostWereAndWhatShareThatIs) {
  ReportData data = data_of({"walk"});
  const double cell_m = data.prepared->scenario().world->plan().cell_m;
  ASSERT_EQ(cell_m, 1.5);
  // Squares of half a metre: the cell from 15 m to 16.5 m has 30 to 32, the one behind 33.
  data.facts[0].places[{9, 30}] = 1;
  data.facts[0].places[{9, 31}] = 1;
  data.facts[0].places[{10, 32}] = 1;
  data.facts[0].places[{9, 33}] = 1;
  const std::string html = section::places(data);
  EXPECT_THAT(html, HasSubstr("4 agents; most at 15.75 m along the road"));
  EXPECT_THAT(html, HasSubstr("<title>15.75 m along, 5.25 m from the left: 3 (75.0 %)</title>"));
  EXPECT_THAT(html, HasSubstr("<title>17.25 m along, 5.25 m from the left: 1 (25.0 %)</title>"));
  EXPECT_THAT(html, HasSubstr("in a square of 1.5 m"));
}

TEST(PlacesSection, HasStrongerColoursWhereMoreWere) {
  ReportData data = data_of({"walk"});
  data.facts[0].places[{0, 0}] = 100;
  data.facts[0].places[{0, 30}] = 25;
  data.facts[0].places[{0, 60}] = 1;
  data.facts[0].places[{0, 90}] = 0;
  const std::string html = section::places(data);
  // The root: 1, 1/2, 1/10.
  for (const char* opacity : {"\"1.00\"", "\"0.50\"", "\"0.10\"", "\"0.06\""}) {
    EXPECT_THAT(html, HasSubstr(std::string("fill-opacity=") + opacity));
  }
  // The scale has samples of one, a quarter and all.
  EXPECT_THAT(html, HasSubstr(">100</text>"));
  EXPECT_THAT(html, HasSubstr(">25</text>"));
  EXPECT_THAT(html, HasSubstr(">1</text>"));
}

TEST(PlacesSection, CoarsensSquaresOfALongRoad) {
  ReportData data = data_of({"walk"});
  data.prepared = world_of("proximity", "world: {length: 300}\n");
  data.facts[0].places[{9, 30}] = 1;
  const std::string html = section::places(data);
  EXPECT_THAT(html, HasSubstr("in a square of 4.5 m")) << "three cells: 100 squares, not 300";
}

/// Somebody walks one metre a tick to the right, beside the AV that drives ahead.
Recording walk(bool met) {
  Recording recording(1, {{"av", ActorKind::vehicle, 4, 2}, {"<p1>", ActorKind::pedestrian, 1, 1}});
  for (int tick = 0; tick < 3; ++tick) {
    recording.add(std::vector<ActorState>{{4, 2.0 + 9 * tick, 9, 1.57}, {1.0 + tick, 30, 1, 0}});
  }
  if (met) recording.add(RecordedEvent{.tick = 2, .actor = 1, .kind = "precondition"});
  return recording;
}

ReportData data_with(ReplayLink link) {
  ReportData data = data_of({"walk", "sprint & stop"});
  data.store_path = "runs.gpkg";
  data.replays.push_back(std::move(link));
  return data;
}

TEST(ReplaysSection, IsLeftOutWithoutTestsOrWithoutAWorld) {
  EXPECT_EQ(section::replays(data_of({"walk"})), "");
  ReportData data = data_with({.test = {.behaviour = 0, .agents = 1, .number = 3}});
  data.prepared = nullptr;
  EXPECT_EQ(section::replays(data), "");
}

TEST(ReplaysSection, SaysWhichTestAndWhy) {
  const std::string html = section::replays(
      data_with({.test = {.behaviour = 0, .agents = 2, .number = 17}, .reason = "the <first>"}));
  EXPECT_THAT(html, HasSubstr("walk, 2 agents, test 17<small>the &lt;first&gt;</small>"));
  EXPECT_THAT(html, HasSubstr("<code>jaywalk replay runs.gpkg --behaviour walk --agents 2 "
                              "--test 17</code>"));
  EXPECT_THAT(html, Not(HasSubstr("<svg"))) << "the store has no scenes of it";
  EXPECT_THAT(html, Not(HasSubstr("<a href")));
}

TEST(ReplaysSection, LinksThePageThatPlaysTheTest) {
  const std::string html = section::replays(data_with(
      {.test = {.behaviour = 0, .agents = 1, .number = 0}, .page = "r-replays/a&b.html"}));
  EXPECT_THAT(html, HasSubstr("<a href=\"r-replays/a%26b.html\">walk, 1 agent, test 0</a>"));
}

TEST(ReplaysSection, HasACommandThatAShellTakesAsItIsMeant) {
  ReportData data = data_with({.test = {.behaviour = 1, .agents = 1, .number = 0}});
  data.store_path = "my runs/a.gpkg";
  EXPECT_THAT(section::replays(data),
              HasSubstr("jaywalk replay 'my runs/a.gpkg' --behaviour 'sprint &amp; "
                        "stop' --agents 1 --test 0"));
}

TEST(ReplaysSection, HasACommandForAStoreThatIsStillToBeMade) {
  ReportData data = data_with({.test = {.behaviour = 0, .agents = 1, .number = 0}});
  data.store_path.clear();
  EXPECT_THAT(section::replays(data), HasSubstr("jaywalk replay STORE.gpkg --behaviour walk"));
}

TEST(ReplaysSection, DrawsEverybodysWayAndWhereItEnds) {
  const ReplayLink link{.test = {.behaviour = 0, .agents = 1, .number = 0},
                        .recording = walk(true)};
  const std::string html = section::replays(data_with(link));
  EXPECT_THAT(html, HasSubstr("<g class=\"ink\"><path d=\"M"));
  EXPECT_EQ(times(html, "class=\"av\""), 1U) << "the AV is a box";
  EXPECT_THAT(html, HasSubstr("<title>&lt;p1&gt;, met the precondition</title>"));
  EXPECT_THAT(html, HasSubstr("r=\"3.5\""));
  // Three scenes: a way of one begin and two pieces.
  const std::size_t begin = html.find("<g class=\"c1\"><path d=\"M");
  ASSERT_NE(begin, html.npos);
  const std::string path = html.substr(begin, html.find("\"/>", begin) - begin);
  EXPECT_EQ(std::ranges::count(path, 'L'), 2);
}

TEST(ReplaysSection, TellsWhoMetThePreconditionFromTheOthers) {
  const ReplayLink link{.test = {.behaviour = 0, .agents = 1, .number = 0},
                        .recording = walk(false)};
  const std::string html = section::replays(data_with(link));
  EXPECT_THAT(html, HasSubstr("<g class=\"c0\"><path"));
  EXPECT_THAT(html, HasSubstr("<title>&lt;p1&gt;</title>"));
  EXPECT_THAT(html, Not(HasSubstr("met the precondition</title>")));
}

/// Two rows of an unpublished behaviour.
ReportData figures_of(const std::string& behaviour) {
  ReportData data;
  data.comparison.tests = 100;
  for (const std::uint32_t agents : {1U, 10U}) {
    data.comparison.summaries.push_back({.behaviour = behaviour,
                                         .agents = agents,
                                         .tests = 100,
                                         .successes = 40 + agents,
                                         .score = {.count = 41, .mean = 30.5, .squares = 10},
                                         .ticks_all = {.count = 100, .mean = 8, .squares = 10},
                                         .cpu_us = {.count = 100, .mean = 2.5}});
  }
  return data;
}

TEST(FiguresSection, IsLeftOutWhereNothingIsFinished) { EXPECT_EQ(section::figures({}), ""); }

TEST(FiguresSection, HasFourFiguresAndTheirNumbersAsATable) {
  const std::string html = section::figures(figures_of("mine"));
  EXPECT_EQ(times(html, "<figure"), 4U);
  EXPECT_THAT(html, Not(HasSubstr("combined_normalised"))) << "which is the paper's alone";
  EXPECT_THAT(html, HasSubstr("<summary>The same numbers as a table</summary>"));
  EXPECT_THAT(html, HasSubstr("<td>41.0</td>")) << "accuracy with one agent";
  EXPECT_THAT(html, HasSubstr("<td>50.0</td>"));
  EXPECT_THAT(html, HasSubstr("<td>30.50</td>"));
}

TEST(FiguresSection, HasNoColumnOfPublishedValuesWhereThereAreNone) {
  EXPECT_THAT(section::figures(figures_of("mine")), Not(HasSubstr(">published</th>")));
  EXPECT_THAT(section::figures(figures_of("mine")), Not(HasSubstr("Dashed")));
}

TEST(FiguresSection, LeavesARowOutThatIsNotFinished) {
  ReportData data = figures_of("mine");
  data.comparison.summaries.pop_back();
  const std::string html = section::figures(data);
  EXPECT_THAT(html, HasSubstr("<td>1</td>"));
  EXPECT_THAT(html, Not(HasSubstr("<td>10</td>")));
}

TEST(FiguresSection, HasADashWhereAMeasureHasNoValue) {
  ReportData data = figures_of("mine");
  data.comparison.summaries[0].successes = 0;
  data.comparison.summaries[0].score = {};
  EXPECT_THAT(section::figures(data), HasSubstr("<td>–</td>"));
}

}  // namespace
}  // namespace jaywalk::reporting
