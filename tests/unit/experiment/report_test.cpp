// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/report.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/comparison_files.h"
#include "experiment/report/charts/plot.h"
#include "experiment/report/tables/tables.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;

Comparison two_behaviours() {
  Comparison comparison{.scenario = "a <b>.yaml", .seed = 1, .tests = 100};
  comparison.published.world = true;
  comparison.published.behaviours = {"proximity"};
  for (const char* behaviour : {"proximity", "mine"}) {
    for (const std::uint32_t agents : {1U, 3U}) {
      Summary summary{.behaviour = behaviour,
                      .agents = agents,
                      .tests = 100,
                      .successes = 48,
                      .score = {.count = 48, .mean = 88.5, .squares = 500},
                      .ticks_all = {.count = 100, .mean = 9.25, .squares = 10},
                      .cpu_us = {.count = 100, .mean = 3.25},
                      .code_lines = 12};
      comparison.summaries.push_back(summary);
    }
  }
  return comparison;
}

TEST(Table, SetsOurValuesBesideThePublishedOnes) {
  Comparison comparison = two_behaviours();
  comparison.summaries.pop_back();
  EXPECT_EQ(render_table(comparison),
            R"(proximity (12 lines of AgentSpeak)
agents  accuracy %     95 % interval  paper    score     95 % interval  paper  combined_normalised  paper   ticks  paper    CPU µs  paper
     1        48.0      38.5 to 57.7   46.9    88.50    87.55 to 89.45  86.99                0.997  0.962    9.25   8.92       3.2  660.0
     3        48.0      38.5 to 57.7   85.5    88.50    87.55 to 89.45  24.47                0.997  0.540    9.25   6.59       3.2 1110.0

mine (12 lines of AgentSpeak)
agents  accuracy %     95 % interval  paper    score     95 % interval  paper  combined_normalised  paper   ticks  paper    CPU µs  paper
     1        48.0      38.5 to 57.7      -    88.50    87.55 to 89.45      -                0.997      -    9.25      -       3.2      -

paper: the published values (Chance, Ghobrial, Lemaignan, Pipe and Eder 2020).
They come from a program with quirks that this run does not repeat, hence the differences:
- a test's AV begins with what the last test left of its tick: fewer ticks, higher scores;
- random behaviour walks against the AV's direction only: fewer tests succeed;
- a pedestrian alone counts the radius itself as near in elections: 50.0 % for 47.9 %.
Table I of the paper has four misprints. --preset as-published-program repeats the quirks.
4 of 6 published accuracies, scores and ticks differ from ours by more than chance explains (99.9 %).
)");
}

TEST(Table, LeavesOutThePapersValuesAndMeasureOfAnotherWorldAndSaysSo) {
  Comparison comparison = two_behaviours();
  comparison.summaries.resize(1);
  comparison.published = {.behaviours = {}, .left_out = "the world is another one"};
  EXPECT_EQ(render_table(comparison),
            R"(proximity (12 lines of AgentSpeak)
agents  accuracy %     95 % interval    score     95 % interval   ticks    CPU µs
     1        48.0      38.5 to 57.7    88.50    87.55 to 89.45    9.25       3.2

paper: published values are left out: the world is another one.
)");
}

TEST(Table, IsEmptyIfNothingIsFinished) { EXPECT_EQ(render_table({}), ""); }

TEST(Chart, DrawsACurveForEachBehaviourAndForEachPublishedOne) {
  const std::string svg = render_svg(two_behaviours());
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_THAT(svg, HasSubstr(">proximity</text>"));
  EXPECT_THAT(svg, HasSubstr(">mine</text>"));
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

/// The text of an attribute of the SVG element that begins at `begin`.
std::string attribute(const std::string& svg, std::size_t begin, const std::string& name) {
  const std::size_t at = svg.find(' ' + name + "=\"", begin);
  if (at > svg.find('>', begin)) return {};
  const std::size_t from = at + name.size() + 3;
  return svg.substr(from, svg.find('"', from) - from);
}

TEST(Chart, HasRoomForItsTextsInAWideFont) {
  const std::string svg = render_svg(two_behaviours());
  const double width = std::stod(attribute(svg, 0, "width"));
  std::size_t texts = 0;
  for (std::size_t at = svg.find("<text"); at != std::string::npos;
       at = svg.find("<text", at + 1)) {
    const std::size_t begin = svg.find('>', at) + 1;
    const std::string text = svg.substr(begin, svg.find('<', begin) - begin);
    // A letter of DejaVu Sans takes 0.61 of its size on average, a bold one 0.69.
    const double letter = attribute(svg, at, "class") == "title" ? 14 * 0.69 : 12 * 0.61;
    const double x = std::stod(attribute(svg, at, "x"));
    const std::string anchor = attribute(svg, at, "text-anchor");
    const double length = letter * static_cast<double>(text.size());
    const double left = x - (anchor == "middle" ? length / 2 : anchor == "end" ? length : 0);
    EXPECT_GE(left, 0) << text;
    EXPECT_LE(left + length, width) << text;
    ++texts;
  }
  EXPECT_GT(texts, 10U);
}

TEST(Chart, HasNoPublishedCurvesOfAnotherWorld) {
  Comparison comparison = two_behaviours();
  comparison.published = {};
  const std::string svg = render_svg(comparison);
  EXPECT_THAT(svg, Not(HasSubstr("stroke-dasharray")));
  EXPECT_THAT(svg, Not(HasSubstr("published")));
  EXPECT_THAT(svg, Not(HasSubstr("combined_normalised")));
  EXPECT_THAT(svg, HasSubstr(">score × accuracy / 1000</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("4.71"))) << "the paper's normalisation";
}

TEST(Chart, CanBeDrawnOfNothingAndOfASinglePoint) {
  Comparison comparison = two_behaviours();
  comparison.summaries.resize(1);
  for (const std::string& svg : {render_svg(comparison), render_svg({})}) {
    EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
  }
}

/// Two behaviours that met the precondition in every second test, the second ones in others.
reporting::ReportData report_data() {
  reporting::ReportData data{.comparison = two_behaviours()};
  data.description.scenario = data.comparison.scenario;
  data.description.behaviours = {{.name = "proximity"}, {.name = "mine"}};
  data.description.agents = {1, 3};
  for (std::size_t row = 0; row < data.comparison.summaries.size(); ++row) {
    reporting::CellFacts facts;
    for (std::size_t test = 0; test < 100; ++test) facts.succeeded.push_back(test % 2 == row / 2);
    facts.errored.assign(100, false);
    facts.ticks = {{5, 48}, {11, 52}};
    data.facts.push_back(facts);
  }
  return data;
}

TEST(Report, EscapesNamesAndNeedsNothingFromOutside) {
  const std::string html = reporting::render_report(report_data());
  EXPECT_THAT(html, HasSubstr("a &lt;b&gt;.yaml"));
  EXPECT_THAT(html, Not(HasSubstr("<b>.yaml")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("://")));
}

TEST(Report, HasTheSectionsThatHaveSomethingToSay) {
  const std::string html = reporting::render_report(report_data());
  for (const std::string_view name : {"overview", "figures", "significance", "reproduce"}) {
    EXPECT_THAT(html, HasSubstr(fmt::format("<section id=\"{}\">", name)));
  }
  for (const std::string_view name : {"places", "replays"}) {
    EXPECT_THAT(html, Not(HasSubstr(fmt::format("<section id=\"{}\">", name))));
  }
}

TEST(Report, DrawsEachOfThePapersFiguresAndSetsThePublishedValuesBesideOurs) {
  const std::string html = reporting::render_report(report_data());
  for (const std::string_view title : {"Accuracy, %", "Score", "combined_normalised",
                                       "CPU time, µs per test", "Time to test, ticks"}) {
    EXPECT_THAT(html, HasSubstr(fmt::format("aria-label=\"{}\"", title)));
  }
  EXPECT_THAT(html, HasSubstr("class=\"published\""));
  EXPECT_THAT(html, HasSubstr("<td>48.0</td><td>38.5 to 57.7</td><td>46.9</td>"));
  EXPECT_THAT(html, Not(testing::ContainsRegex("[^a-z](nan|inf)[^a-z]")));
}

/// As the marks of an axis of one metric whose values are these.
std::string picture_of(std::vector<double> values) {
  return reporting::box_plots("minutes",
                              {{.name = "mine", .boxes = {{"", distribution(std::move(values))}}}});
}

// Values that differ by rounding alone made an axis whose marks never advanced.
TEST(Plot, TakesValuesThatDifferByRoundingForOne) {
  for (const double value : {1e-300, 0.1, 1.0, -3.0, 4.25, 1e6, 1e17, -1e300}) {
    const double next = std::nextafter(value, 2 * value);
    EXPECT_LT(picture_of({value, next}).size(), 4000U) << value;
    const std::vector<reporting::PlotSeries> curve{
        {.name = "mine", .points = {{.x = 1, .y = value}, {.x = 2, .y = next}}}};
    EXPECT_LT(reporting::curves({}, curve).size(), 8000U) << value;
    EXPECT_LT(reporting::curves({.scale = reporting::Scale::logarithmic}, curve).size(), 8000U)
        << value;
  }
}

TEST(Plot, MarksAnAxisOfLargeValuesThatHardlyDiffer) {
  reporting::Axis axis{.least = 1e16, .most = 1e16 + 8, .begin = 0, .end = 100};
  EXPECT_LE(axis.marks(5).size(), 10U);
  axis = {.least = 0, .most = 1, .begin = 0, .end = 100};
  EXPECT_EQ(axis.marks(5).size(), 6U) << "both ends";
}

TEST(Plot, NamesBothAxes) {
  const std::string svg =
      reporting::curves({.x_title = "tests", .y_title = "bins covered"},
                        {{.name = "mine", .points = {{1, 2, {}, {}}, {5, 8, {}, {}}}}});
  EXPECT_THAT(svg, HasSubstr(">tests</text>"));
  EXPECT_THAT(svg, HasSubstr(">bins covered</text>"));
}

TEST(Report, SaysWhyThePublishedValuesDifferOrAreLeftOut) {
  EXPECT_THAT(reporting::render_report(report_data()), HasSubstr("--preset as-published-program"));
  reporting::ReportData data = report_data();
  data.comparison.published = {.behaviours = {}, .left_out = "the world is another one"};
  const std::string html = reporting::render_report(data);
  EXPECT_THAT(html, HasSubstr("published values are left out: the world is another one."));
  EXPECT_THAT(html, Not(HasSubstr("class=\"published\"")));
  EXPECT_THAT(html, Not(HasSubstr(">published</th>")));
  EXPECT_THAT(html, Not(HasSubstr("combined_normalised")));
}

TEST(Report, HasNoHeadingOfThePaper) {
  EXPECT_THAT(reporting::render_report(report_data()), Not(HasSubstr("paper's figures")));
}

TEST(Report, ComparesBehavioursTestByTest) {
  const std::string html = reporting::render_report(report_data());
  // 50 tests each in which only the one succeeded: no difference, though no test came out alike.
  EXPECT_THAT(html, HasSubstr("<td><small>0.0</small></td>"));
  EXPECT_THAT(html, HasSubstr("<td>50</td><td>50</td><td>1.000</td><td>0.500</td>"));
}

TEST(Report, CanBeMadeOfNothing) {
  const std::string html = reporting::render_report({});
  EXPECT_THAT(html, HasSubstr("No row is finished yet."));
  EXPECT_THAT(html, testing::EndsWith("</html>\n"));
}

}  // namespace
}  // namespace jaywalk
