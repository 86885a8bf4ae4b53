// SPDX-License-Identifier: Apache-2.0
// The file of situations that can be met, and of the walks that meet them.

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/judge/situations/situations.h"
#include "experiment/report/stored_coverage.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto kHeader = "item,bin,name,reachable,start_row,start_cell,moves\n";

Result<ReachFile> parse(const std::string& text) {
  return parse_reach_file(std::make_shared<const Source>("reach.csv", text));
}

std::string errors(const std::string& text) {
  Result<ReachFile> file = parse(text);
  return file.ok() ? std::string() : file.diagnostics().render();
}

/// A line for each bin that `met` does not begin a line for: no test can meet it.
std::string with_the_rest(const std::string& met) {
  std::string text = kHeader + met;
  for (const SituationItem& item : situation_items()) {
    for (std::size_t bin = 1; bin <= item.bins.size(); ++bin) {
      const std::string begin = fmt::format("{},{},", item.name, bin);
      if (met.find(begin) == std::string::npos) text += begin + "\"\",0,,,\n";
    }
  }
  return text;
}

TEST(ReachFile, HasBinsAndTheirWalksEachOnce) {
  const Result<ReachFile> file =
      parse(with_the_rest("start_side,1,\"left\",1,1,20,rrr\n"
                          "side_and_ttc,1,\"left, 0-0.2 s\",1,1,20,rrr\r\n"));
  ASSERT_TRUE(file.ok()) << file.diagnostics().render();
  EXPECT_THAT(file.value().walks, ElementsAre(ScriptedWalk{{1, 20}, "rrr"}));
  ASSERT_EQ(file.value().reachable.size(), situation_items().size());
  EXPECT_THAT(file.value().reachable.front(), ElementsAre(true, false));
}

TEST(ReachFile, MayHaveWalksAlone) {
  const Result<ReachFile> file = parse("start_row,start_cell,moves\n1,20,sfblr\n10,40,l\n");
  ASSERT_TRUE(file.ok()) << file.diagnostics().render();
  EXPECT_TRUE(file.value().reachable.empty());
  EXPECT_EQ(file.value().walks.size(), 2U);
}

TEST(ReachFile, HasALineForEachBin) {
  std::string text = with_the_rest("");
  text.erase(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_THAT(errors(text), HasSubstr("reach.csv: error: has no line for bin"));
  EXPECT_THAT(errors(std::string(kHeader)), HasSubstr("has no line for bin 1 of start_side"));
  EXPECT_THAT(errors(with_the_rest("") + "start_side,1,\"left\",1,1,20,rrr\n"),
              HasSubstr("error: a second line for bin 1 of start_side"));
}

TEST(ReachFile, SaysWhereAMistakeIs) {
  EXPECT_THAT(errors(""), HasSubstr("expected the header 'item,bin,name"));
  EXPECT_THAT(errors("row,cell\n1,2\n"), HasSubstr("reach.csv:1:1: error: expected the header"));
  EXPECT_THAT(errors(std::string(kHeader) + "colour,1,\"red\",0,,,\n"),
              HasSubstr("reach.csv:2:1: error: no situation is called 'colour'"));
  EXPECT_THAT(errors(std::string(kHeader) + "start_side,3,\"up\",0,,,\n"),
              HasSubstr("expected a whole number from 1 to 2, found '3'"));
  EXPECT_THAT(errors(std::string(kHeader) + "start_side,1\n"),
              HasSubstr("expected 7 fields, found 2"));
  EXPECT_THAT(errors("start_row,start_cell,moves\n1,20,up\n"), HasSubstr("letters of 'fblrs'"));
  EXPECT_THAT(errors("start_row,start_cell,moves\n1,-1,f\n"),
              HasSubstr("expected a whole number from 0 to 1000000, found '-1'"));
}

SituationRow row_of(std::uint32_t side) {
  SituationRow row{.behaviour = "walker", .agents = 1, .coverage = {}, .reachable = {}};
  SituationBins bins(situation_items().size());
  bins.front() = side;
  row.coverage.add(bins);
  for (const SituationItem& item : situation_items()) row.reachable.emplace_back(item.bins.size());
  return row;
}

TEST(SituationText, CountsWhatCanBeCoveredAndCallsTheRestNoHole) {
  SituationRow row = row_of(0);
  row.reachable[0] = {true, false};
  row.reachable[1][5] = true;
  const std::string text = situation_text({row});
  EXPECT_THAT(text, HasSubstr("1 of   2   50.0 %"));
  EXPECT_THAT(text, testing::ContainsRegex("right +never"));
  EXPECT_THAT(text, testing::ContainsRegex("6th +hole"));
  EXPECT_THAT(situation_json({row}), HasSubstr("\"bins\": 2"));
}

TEST(SituationText, SaysThatTheFileIsOfAnotherWorld) {
  SituationRow row = row_of(1);
  row.reachable[0] = {true, false};
  EXPECT_EQ(row.bins(), 2U) << "what is covered can be";
  EXPECT_THAT(situation_text({row}), HasSubstr("another world: 1 bins that it leaves out"));
}

TEST(SituationText, KnowsWhatCanBeCoveredOfTestsWithOneAgent) {
  const ReachableBins reachable{{true}};
  EXPECT_EQ(reachable_with(reachable, 1), reachable);
  EXPECT_TRUE(reachable_with(reachable, 2).empty());
}

}  // namespace
}  // namespace jaywalk
