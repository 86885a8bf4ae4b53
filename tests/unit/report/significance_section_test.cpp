// SPDX-License-Identifier: Apache-2.0
// Differences between behaviours as the report shows them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/report.h"

namespace jaywalk::reporting {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Behaviours b0, b1, … with one agent; of each the tests in which it succeeded, as `y` and `n`,
/// `e` where one ended errored.
ReportData data_of(const std::vector<std::string>& outcomes) {
  ReportData data;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    Summary of{.behaviour = fmt::format("b{}", i), .agents = 1, .tests = outcomes[i].size()};
    CellFacts facts;
    for (const char outcome : outcomes[i]) {
      facts.succeeded.push_back(outcome == 'y');
      facts.errored.push_back(outcome == 'e');
      if (outcome != 'e') ++facts.ticks[outcome == 'y' ? 4 : 11];
    }
    data.comparison.summaries.push_back(of);
    data.facts.push_back(facts);
  }
  return data;
}

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(SignificanceSection, NeedsTwoBehavioursAndTheirTests) {
  EXPECT_EQ(section::significance(data_of({"yyn"})), "");
  ReportData data = data_of({"yyn", "nnn"});
  data.facts.clear();
  EXPECT_EQ(section::significance(data), "");
}

TEST(SignificanceSection, MarksADifferenceThatIsMoreThanChance) {
  const std::string better = section::significance(data_of({repeated("y", 20), repeated("n", 20)}));
  EXPECT_THAT(better, HasSubstr("<td class=\"l\">b0 − b1</td><td><mark class=\"better\">+100.0"));
  const std::string worse = section::significance(data_of({repeated("n", 20), repeated("y", 20)}));
  EXPECT_THAT(worse, HasSubstr("<mark class=\"worse\">-100.0</mark>"));
}

TEST(SignificanceSection, DoesNotMarkWhatMayBeChance) {
  const std::string html = section::significance(data_of({"yyyn", "ynnn"}));
  EXPECT_THAT(html, HasSubstr("<small>+50.0</small>"));
  EXPECT_THAT(html, Not(HasSubstr("<td><mark")));
}

TEST(SignificanceSection, ComparesTestsOfTheSameNumber) {
  const std::string html = section::significance(data_of({"yynn", "nynn"}));
  // In one test only the first succeeded, in none only the second.
  EXPECT_THAT(html, HasSubstr("<td>1</td><td>0</td><td>1.000</td>"));
}

TEST(SignificanceSection, LeavesOutTestsThatEndedErroredForEither) {
  const std::string html = section::significance(data_of({"yyen", "yeyn"}));
  EXPECT_THAT(html, HasSubstr("<td>0</td><td>0</td><td>1.000</td>"));
  EXPECT_THAT(html, HasSubstr("<small>0.0</small>"));
}

TEST(SignificanceSection, CorrectsForTheNumberOfComparisons) {
  // In six tests only the one succeeds: 2 / 2^6 = 0.031 by itself, 3 times as much among three.
  const std::string one = repeated("y", 6);
  const std::string none = repeated("n", 6);
  EXPECT_THAT(section::significance(data_of({one, none})), HasSubstr("<td><mark"));
  EXPECT_THAT(section::significance(data_of({one, none, "yyynnn"})), Not(HasSubstr("<td><mark")));
}

TEST(SignificanceSection, ComparesEachPairOfAFewBehaviours) {
  const std::string html = section::significance(data_of({"yn", "yn", "yn"}));
  for (const char* pair : {"b0 − b1", "b0 − b2", "b1 − b2"}) EXPECT_THAT(html, HasSubstr(pair));
}

TEST(SignificanceSection, ComparesManyBehavioursWithTheFirstAlone) {
  const std::string html =
      section::significance(data_of(std::vector<std::string>(11, std::string("yn"))));
  EXPECT_THAT(html, HasSubstr("The first behaviour is compared with each of the others."));
  EXPECT_THAT(html, HasSubstr("b0 − b10"));
  EXPECT_THAT(html, Not(HasSubstr("b1 − b2")));
}

TEST(SignificanceSection, HasTheEffectOfTicks) {
  const std::string html = section::significance(data_of({"yyyy", "nnnn"}));
  EXPECT_THAT(html, HasSubstr("<td>0.000</td>")) << "no test of the first takes longer";
}

TEST(PlacesSection, IsLeftOutWithoutAWorld) {
  EXPECT_EQ(section::places(data_of({"yn", "ny"})), "");
}

TEST(SituationsSection, SaysThatItNeedsAStore) {
  EXPECT_THAT(section::situations(data_of({"yn"})),
              HasSubstr("Situations are counted from a store"));
}

}  // namespace
}  // namespace jaywalk::reporting
