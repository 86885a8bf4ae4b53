// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/html.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk::reporting {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(Decimal, HasSoManyDigitsAfterThePoint) {
  EXPECT_EQ(decimal(1.25, 1), "1.2");
  EXPECT_EQ(decimal(1.26, 1), "1.3");
  EXPECT_EQ(decimal(-0.5, 2), "-0.50");
  EXPECT_EQ(decimal(12, 0), "12");
}

TEST(Decimal, HasSignsForWhatIsNoNumber) {
  EXPECT_EQ(decimal(std::nullopt, 2), "–");
  EXPECT_EQ(decimal(std::numeric_limits<double>::quiet_NaN(), 2), "–");
  EXPECT_EQ(decimal(kEndless, 2), "∞");
  EXPECT_EQ(decimal(-kEndless, 2), "−∞");
}

TEST(Compact, HasAboutFourDigits) {
  EXPECT_EQ(compact(0), "0");
  EXPECT_EQ(compact(0.25), "0.25");
  EXPECT_EQ(compact(12.5), "12.5");
  EXPECT_EQ(compact(1.0 / 3), "0.3333");
  EXPECT_EQ(compact(-7.25), "-7.25");
  EXPECT_EQ(compact(1200), "1200");
}

TEST(Compact, GroupsTheDigitsOfLargeNumbers) {
  EXPECT_EQ(compact(12000), "12,000");
  EXPECT_EQ(compact(123456.7), "123,457");
  EXPECT_EQ(compact(-12000), "−12,000");
}

TEST(Compact, DoesNotFallIntoPowersJustBelowTenThousand) {
  EXPECT_EQ(compact(9999), "9999");
  EXPECT_EQ(compact(9999.4), "9999");
  EXPECT_EQ(compact(9999.6), "10,000");
  EXPECT_EQ(compact(-9999.6), "−10,000");
}

TEST(Compact, HasPowersBeyondMillionsAndBelowTenthsOfThousandths) {
  EXPECT_EQ(compact(2.5e6), "2.5e+06");
  EXPECT_EQ(compact(0.00001234), "1.23e-05");
  EXPECT_EQ(compact(0.0002), "0.0002");
  EXPECT_EQ(compact(kEndless), "∞");
  EXPECT_EQ(compact(-kEndless), "−∞");
}

TEST(Grouped, HasACommaBeforeEachThirdDigit) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(123456), "123,456");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(grouped(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

TEST(PValue, IsNeverZero) {
  EXPECT_EQ(p_value(0), "&lt; 0.001");
  EXPECT_EQ(p_value(0.0009999), "&lt; 0.001");
  EXPECT_EQ(p_value(0.001), "0.001");
  EXPECT_EQ(p_value(1), "1.000");
}

TEST(Plural, IsOfAllNumbersButOne) {
  EXPECT_EQ(plural(0, "test"), "0 tests");
  EXPECT_EQ(plural(1, "test"), "1 test");
  EXPECT_EQ(plural(1200, "test"), "1,200 tests");
}

TEST(Markers, AreOutOfStepWithColours) {
  // Eight colours and seven shapes: 56 series before both repeat.
  EXPECT_EQ(series_attributes(9), "class=\"c1\" data-series=\"9\"");
  EXPECT_EQ(marker(7, 10, 20), marker(0, 10, 20));
  EXPECT_NE(marker(8, 10, 20), marker(0, 10, 20));
}

TEST(Markers, StandAroundTheirPoint) {
  EXPECT_THAT(marker(0, 10, 20), HasSubstr("cx=\"10.0\" cy=\"20.0\""));
  EXPECT_THAT(marker(1, 10, 20), HasSubstr("x=\"7.3\" y=\"17.3\" width=\"5.4\""));
  EXPECT_THAT(marker(2, 10, 20), HasSubstr("M10.0 16.2"));
  EXPECT_THAT(marker(4, 10, 20), HasSubstr("M7.0 17.0l6 6"));
  EXPECT_THAT(marker(5, 10, 20), HasSubstr("class=\"hollow\""));
  EXPECT_THAT(marker(6, 10, 20), HasSubstr("M6.5 20.0h7"));
}

TEST(HtmlTable, AlignsItsColumnsAndScrolls) {
  Table table;
  table.column("name", Align::left);
  table.column("tests");
  table.row({"a", "1"});
  EXPECT_EQ(table.html(),
            "<div class=\"scroll\" tabindex=\"0\"><table><thead><tr><th class=\"l\" "
            "scope=\"col\">name</th><th scope=\"col\">tests</th></tr></thead>\n"
            "<tbody><tr><td class=\"l\">a</td><td>1</td></tr>\n</tbody></table></div>\n");
}

TEST(HtmlTable, IsEmptyWithoutRows) {
  Table table;
  table.column("name");
  EXPECT_TRUE(table.empty());
  table.heading("all");
  EXPECT_FALSE(table.empty());
}

TEST(HtmlTable, HasHeadingsOverAllColumns) {
  Table table;
  table.column("a");
  table.column("b");
  table.heading("x < y");
  EXPECT_THAT(table.html(), HasSubstr("<th colspan=\"2\" class=\"l group\" "
                                      "scope=\"rowgroup\">x &lt; y</th>"));
}

TEST(HtmlTable, TakesRowsWiderThanItsColumns) {
  Table table;
  table.column("a", Align::left);
  table.row({"1", "2"});
  EXPECT_THAT(table.html(), HasSubstr("<td class=\"l\">1</td><td>2</td>"));
}

TEST(HtmlParts, EscapeSummariesAndTakeContentAsItIs) {
  EXPECT_EQ(details("a & b", "<b>x</b>"),
            "<details><summary>a &amp; b</summary>\n<b>x</b></details>\n");
  EXPECT_EQ(paragraph("<i>x</i>"), "<p><i>x</i></p>\n");
  EXPECT_EQ(term("name", "<i>x</i>"), "<dt>name</dt><dd><i>x</i></dd>\n");
  EXPECT_EQ(terms(term("a", "b")), "<dl>\n<dt>a</dt><dd>b</dd>\n</dl>\n");
  EXPECT_EQ(figure("caption", "<svg/>"),
            "<figure><figcaption>caption</figcaption>\n<svg/></figure>\n");
}

TEST(HtmlParts, HaveGalleriesOfThreeSizes) {
  EXPECT_EQ(gallery("x"), "<div class=\"gallery\">\nx</div>\n");
  EXPECT_EQ(gallery("x", PictureSize::small), "<div class=\"gallery small\">\nx</div>\n");
  EXPECT_EQ(gallery("x", PictureSize::wide), "<div class=\"gallery wide\">\nx</div>\n");
}

TEST(Legend, NamesEachSeriesBesideItsMark) {
  const std::string html = legend({"one", "<two>"});
  EXPECT_THAT(html, HasSubstr("data-switch=\"0\"><svg class=\"mark c0\""));
  EXPECT_THAT(html, HasSubstr("data-switch=\"1\"><svg class=\"mark c1\""));
  EXPECT_THAT(html, HasSubstr("</svg>&lt;two&gt;</label>"));
  EXPECT_THAT(html, Not(HasSubstr("<two>")));
  EXPECT_THAT(html, HasSubstr(marker(1, 12, 6)));
}

}  // namespace
}  // namespace jaywalk::reporting
