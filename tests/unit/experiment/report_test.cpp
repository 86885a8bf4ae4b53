#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/chart.h"
#include "experiment/report/table.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;

Comparison two_behaviours() {
  Comparison comparison{.scenario = "a <b>.yaml", .seed = 1, .tests = 100};
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
agents  accuracy %     95 % interval  paper    score     95 % interval  paper  combined  paper   ticks  paper    CPU µs  paper
     1        48.0      38.5 to 57.7   46.9    88.50    87.55 to 89.45  88.18     0.997  0.962    9.25   8.92       3.2  660.0
     3        48.0      38.5 to 57.7   85.5    88.50    87.55 to 89.45  24.24     0.997  0.540    9.25   6.59       3.2 1110.0

mine (12 lines of AgentSpeak)
agents  accuracy %     95 % interval  paper    score     95 % interval  paper  combined  paper   ticks  paper    CPU µs  paper
     1        48.0      38.5 to 57.7      -    88.50    87.55 to 89.45      -     0.997      -    9.25      -       3.2      -
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

TEST(Chart, CanBeDrawnOfNothingAndOfASinglePoint) {
  Comparison comparison = two_behaviours();
  comparison.summaries.resize(1);
  for (const std::string& svg : {render_svg(comparison), render_svg({})}) {
    EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
  }
}

TEST(Report, EscapesNamesAndNeedsNothingFromOutside) {
  const std::string html = render_html(two_behaviours());
  EXPECT_THAT(html, HasSubstr("a &lt;b&gt;.yaml"));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("href=")));
}

}  // namespace
}  // namespace jaywalk
