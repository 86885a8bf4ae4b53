// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/charts/plot.h"

#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk::reporting {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pointwise;

constexpr double kBoundless = std::numeric_limits<double>::infinity();

std::size_t occurrences(std::string_view text, std::string_view of) {
  std::size_t count = 0;
  for (std::size_t at = text.find(of); at != std::string_view::npos; at = text.find(of, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Axis, MapsValuesToPlacesEitherWay) {
  const Axis right{.least = 10, .most = 20, .begin = 0, .end = 100};
  EXPECT_DOUBLE_EQ(right.at(10), 0);
  EXPECT_DOUBLE_EQ(right.at(12.5), 25);
  EXPECT_DOUBLE_EQ(right.at(20), 100);
  const Axis up{.least = 0, .most = 4, .begin = 200, .end = 0};
  EXPECT_DOUBLE_EQ(up.at(1), 150);
}

TEST(Axis, PutsWhatIsOutsideAtTheNearestEnd) {
  const Axis axis{.least = 10, .most = 20, .begin = 0, .end = 100};
  EXPECT_DOUBLE_EQ(axis.at(-kBoundless), 0);
  EXPECT_DOUBLE_EQ(axis.at(9), 0);
  EXPECT_DOUBLE_EQ(axis.at(kBoundless), 100);
}

TEST(Axis, CanBeLogarithmic) {
  const Axis axis{.least = 1, .most = 10000, .begin = 0, .end = 80, .scale = Scale::logarithmic};
  EXPECT_NEAR(axis.at(10), 20, 1e-9);
  EXPECT_NEAR(axis.at(100), 40, 1e-9);
  EXPECT_DOUBLE_EQ(axis.at(0.5), 0);
}

struct Marks {
  double least;
  double most;
  int count;
  std::vector<double> wanted;

  friend std::ostream& operator<<(std::ostream& out, const Marks& marks) {
    return out << marks.least << " to " << marks.most;
  }
};

class LinearMarks : public testing::TestWithParam<Marks> {};

TEST_P(LinearMarks, AreRound) {
  const Marks& marks = GetParam();
  const Axis axis{.least = marks.least, .most = marks.most, .begin = 0, .end = 1};
  EXPECT_THAT(axis.marks(marks.count), Pointwise(DoubleNear(1e-9), marks.wanted));
}

INSTANTIATE_TEST_SUITE_P(Each, LinearMarks,
                         testing::Values(Marks{0, 1, 5, {0, 0.2, 0.4, 0.6, 0.8, 1}},
                                         Marks{0, 100, 6, {0, 20, 40, 60, 80, 100}},
                                         Marks{0, 10, 4, {0, 5, 10}},
                                         Marks{1, 7, 6, {1, 2, 3, 4, 5, 6, 7}},
                                         Marks{-3, 3, 3, {-2, 0, 2}},
                                         Marks{0.12, 0.19, 5, {0.12, 0.14, 0.16, 0.18}},
                                         Marks{1234, 5678, 5, {2000, 3000, 4000, 5000}}));

TEST(LinearMarksOfZero, AreNoMinusZero) {
  const Axis axis{.least = -1, .most = 1, .begin = 0, .end = 1};
  for (const double mark : axis.marks(5)) EXPECT_FALSE(mark == 0 && std::signbit(mark));
}

TEST(LogarithmicMarks, ArePowersOfTen) {
  const Axis axis{.least = 1, .most = 1e4, .begin = 0, .end = 1, .scale = Scale::logarithmic};
  EXPECT_THAT(axis.marks(6), Pointwise(DoubleNear(1e-6), std::vector{1.0, 10.0, 1e2, 1e3, 1e4}));
}

TEST(LogarithmicMarks, HaveDoublesAndFivefoldsWhereTheseAreFew) {
  const Axis axis{.least = 1.5, .most = 60, .begin = 0, .end = 1, .scale = Scale::logarithmic};
  EXPECT_THAT(axis.marks(6), Pointwise(DoubleNear(1e-6), std::vector{2.0, 5.0, 10.0, 20.0, 50.0}));
}

TEST(LogarithmicMarks, SkipPowersWhereTheseAreMany) {
  const Axis axis{.least = 1e-10, .most = 1e10, .begin = 0, .end = 1, .scale = Scale::logarithmic};
  const auto marks = axis.marks(5);
  EXPECT_LE(marks.size(), 10U);
  EXPECT_GE(marks.size(), 3U);
  for (std::size_t i = 1; i < marks.size(); ++i) EXPECT_GT(marks[i], 5 * marks[i - 1]);
}

TEST(WidenIfNarrow, LeavesASpreadAlone) {
  double least = 1;
  double most = 1.001;
  widen_if_narrow(least, most);
  EXPECT_EQ(least, 1);
  EXPECT_EQ(most, 1.001);
}

TEST(WidenIfNarrow, MakesRoomAroundOneValue) {
  double least = 3;
  double most = 3;
  widen_if_narrow(least, most);
  EXPECT_DOUBLE_EQ(least, 2.5);
  EXPECT_DOUBLE_EQ(most, 3.5);
  least = most = 1e6;
  widen_if_narrow(least, most);
  EXPECT_DOUBLE_EQ(least, 1e6 - 1000);
}

TEST(SvgParts, AreWrittenWithATenthOfAPoint) {
  EXPECT_EQ(svg_line(0, 1.25, 2, 3), "<path d=\"M0.0 1.2L2.0 3.0\"/>");
  EXPECT_EQ(svg_line(0, 1, 2, 3, "class=\"grid\""),
            "<path d=\"M0.0 1.0L2.0 3.0\" class=\"grid\"/>");
  EXPECT_EQ(svg_text(1, 2, "end", "a<b"),
            "<text x=\"1.0\" y=\"2.0\" text-anchor=\"end\">a&lt;b</text>");
  EXPECT_EQ(svg(360, 20, "a \"b\"", "x"),
            "<svg viewBox=\"0 0 360 20\" role=\"img\" aria-label=\"a &quot;b&quot;\">\nx</svg>\n");
}

PlotSeries series(std::vector<PlotPoint> points) {
  return {.name = "mine", .number = 1, .points = std::move(points)};
}

TEST(Curves, SayTheirValuesWithTheirIntervals) {
  const std::string picture =
      curves({}, {series({{.x = 1, .y = 2, .low = 1.5, .high = 2.5}, {.x = 3, .y = 4}})});
  EXPECT_THAT(picture, HasSubstr("<title>mine, 1: 2 (1.5 to 2.5)</title>"));
  EXPECT_THAT(picture, HasSubstr("<title>mine, 3: 4</title>"));
}

TEST(Curves, LeaveOutWhatIsNotFinite) {
  const std::string picture = curves(
      {}, {series({{.x = 1, .y = 2}, {.x = 2, .y = kBoundless}, {.x = 3, .y = std::nan("")}})});
  EXPECT_EQ(occurrences(picture, "<title>"), 1U);
  EXPECT_THAT(picture, Not(HasSubstr("nan")));
}

TEST(Curves, OnALogarithmicScaleLeaveOutWhatIsNotPositive) {
  const std::vector<PlotSeries> values{
      series({{.x = 1, .y = 0}, {.x = 2, .y = -3}, {.x = 3, .y = 5}})};
  EXPECT_EQ(occurrences(curves({.scale = Scale::logarithmic}, values), "<title>"), 1U);
  EXPECT_EQ(occurrences(curves({}, values), "<title>"), 3U);
}

TEST(Curves, OfNothingAreAFrame) {
  const std::string picture = curves({.y_title = "score"}, {});
  EXPECT_THAT(picture, HasSubstr("aria-label=\"score\""));
  EXPECT_THAT(picture, Not(HasSubstr("<title>")));
  EXPECT_THAT(curves({}, {series({})}), Not(HasSubstr("data-series")));
}

TEST(Curves, DrawPublishedOnesBehindWithoutIntervals) {
  PlotSeries published = series({{.x = 1, .y = 2, .low = 1, .high = 3}, {.x = 2, .y = 2}});
  published.published = true;
  const std::string picture = curves({}, {series({{.x = 1, .y = 1}, {.x = 2, .y = 1}}), published});
  EXPECT_THAT(picture, HasSubstr("<title>mine (published), 1: 2</title>"));
  EXPECT_LT(picture.find("class=\"published\""), picture.find("class=\"curve\""));
}

TEST(Curves, ShowIntervalsWhole) {
  // From 0 to 100 would end at the value; with 3 % of room above the interval it ends at 144.2.
  const std::string picture = curves(
      {.least = 0}, {series({{.x = 1, .y = 100, .low = 60, .high = 140}, {.x = 2, .y = 50}})});
  EXPECT_THAT(picture, HasSubstr(fmt::format("L56.0 {:.1f}\"", 26 + 198 * 4.2 / 144.2)));
  EXPECT_THAT(picture, Not(HasSubstr("L56.0 26.0\""))) << "cut off at the upper end";
  EXPECT_THAT(curves({}, {series({{.x = 1, .y = 1, .low = -9, .high = 3}})}),
              HasSubstr(">-5</text>"));
}

TEST(Curves, LeaveIntervalsOfPublishedValuesOutOfTheirRange) {
  PlotSeries published = series({{.x = 1, .y = 2, .low = -900, .high = 900}});
  published.published = true;
  EXPECT_THAT(curves({}, {published}), Not(HasSubstr("500")));
}

TEST(Curves, GoAsHighAsTheyAreAskedTo) {
  // With an axis from 0 to 100 the value 50 lies in the middle between 224 and 26.
  const PlotAxes axes{.least = 0, .most = 100};
  EXPECT_THAT(curves(axes, {series({{.x = 1, .y = 50}})}), HasSubstr("M56.0 125.0"));
}

TEST(Curves, MarkWholeNumbersOfTheHorizontalAxisAlone) {
  const std::string picture =
      curves({}, {series({{.x = 1, .y = 1}, {.x = 2, .y = 2}, {.x = 3, .y = 3}})});
  for (const char* mark : {">1</text>", ">2</text>", ">3</text>"}) {
    EXPECT_THAT(picture, HasSubstr(mark));
  }
  EXPECT_THAT(picture, HasSubstr("y=\"242.0\" text-anchor=\"middle\">2</text>"));
  EXPECT_THAT(picture, Not(HasSubstr("y=\"242.0\" text-anchor=\"middle\">1.5</text>")));
}

BoxGroup group(std::vector<double> values) {
  return {.name = "mine", .number = 2, .boxes = {{"", distribution(std::move(values))}}};
}

TEST(BoxPlots, SayWhatTheyShow) {
  EXPECT_THAT(box_plots("m", {group({1, 2, 3, 4, 5})}),
              HasSubstr("<title>median 3, quartiles 2 and 4, from 1 to 5, 5 tests</title>"));
  EXPECT_THAT(box_plots("m", {group({7})}, "agent"), HasSubstr("from 7 to 7, 1 agent</title>"));
}

TEST(BoxPlots, NameTheirBoxes) {
  BoxGroup groups = group({1, 2});
  groups.boxes[0].label = "<10>";
  const std::string picture = box_plots("m", {groups});
  EXPECT_THAT(picture, HasSubstr("<title>&lt;10&gt;: median 1.5"));
  EXPECT_THAT(picture, HasSubstr(">&lt;10&gt;</text>"));
}

TEST(BoxPlots, BeginAtZeroWhereThatIsNear) {
  // From 28 on: 0; up to 346: 10.
  EXPECT_THAT(box_plots("m", {group({1, 10})}), HasSubstr(">0</text>"));
  EXPECT_THAT(box_plots("m", {group({9, 10})}), Not(HasSubstr(">0</text>")));
}

TEST(BoxPlots, HaveArrowsWhereTheyHaveNoEnd) {
  const std::string none = box_plots("m", {group({1, 2, 3})});
  const std::string one = box_plots("m", {group({1, 2, kBoundless})});
  const std::string both = box_plots("m", {group({-kBoundless, 2, kBoundless})});
  const std::string_view arrow = "3.5v-7z";
  EXPECT_EQ(occurrences(none, arrow), 0U);
  EXPECT_EQ(occurrences(one, arrow), 1U);
  EXPECT_EQ(occurrences(both, arrow), 2U);
  EXPECT_THAT(both, HasSubstr("from −∞ to ∞"));
}

TEST(BoxPlots, LeaveTheLineOfABoxWithoutValuesEmpty) {
  const std::string picture = box_plots("m", {group({})});
  EXPECT_THAT(picture, Not(HasSubstr("<title>")));
  EXPECT_THAT(picture, HasSubstr(">mine</text>"));
}

TEST(StackedBars, SayTheShareOfEachPart) {
  const std::string picture = stacked_bars({"pass", "fail"}, {{.name = "a & b", .parts = {3, 1}}});
  EXPECT_THAT(picture, HasSubstr("<title>a &amp; b: pass 75.0 %</title>"));
  EXPECT_THAT(picture, HasSubstr("<title>a &amp; b: fail 25.0 %</title>"));
  EXPECT_THAT(picture, HasSubstr("class=\"part-pass\""));
  EXPECT_THAT(picture, HasSubstr("class=\"on-fail\">25 %</text>"));
}

TEST(StackedBars, PutPartsSideBySide) {
  // 0 % is at 4 and 100 % at 352.
  const std::string picture = stacked_bars({"pass", "fail"}, {{.name = "a", .parts = {1, 1}}});
  EXPECT_THAT(picture, HasSubstr("<rect x=\"4.0\" y=\"17.0\" width=\"174.0\""));
  EXPECT_THAT(picture, HasSubstr("<rect x=\"178.0\" y=\"17.0\" width=\"174.0\""));
}

TEST(StackedBars, WriteNothingIntoNarrowParts) {
  const std::string picture = stacked_bars({"pass", "fail"}, {{.name = "a", .parts = {95, 5}}});
  EXPECT_THAT(picture, HasSubstr(">95 %</text>"));
  EXPECT_THAT(picture, Not(HasSubstr(">5 %</text>")));
}

TEST(StackedBars, OfNothingHaveNoParts) {
  const std::string picture = stacked_bars({"pass"}, {{.name = "a", .parts = {0}}});
  EXPECT_THAT(picture, Not(HasSubstr("<rect")));
  EXPECT_THAT(picture, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace jaywalk::reporting
