// SPDX-License-Identifier: Apache-2.0
// What `jaywalk compare` prints and writes, in which form; and that a store in between changes
// nothing of it.

#include <algorithm>
#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

/// Runs `compare` of a scenario with options and their values, but for those that `more` has.
CommandRun compare(const std::string& scenario,
                   const std::vector<std::pair<std::string, std::string>>& usual,
                   const std::vector<std::string>& more) {
  std::vector<std::string> words{"compare", JAYWALK_SOURCE_DIR "/scenarios/" + scenario};
  for (const auto& [option, value] : usual) {
    if (std::ranges::find(more, option) == more.end()) words.insert(words.end(), {option, value});
  }
  words.insert(words.end(), more.begin(), more.end());
  return run_command(words);
}

class CompareOutputs : public FolderTest {
 protected:
  /// Two behaviours, 1 and 3 agents, 4 tests each.
  [[nodiscard]] CommandRun paper(const std::vector<std::string>& more) const {
    return compare(
        "paper.yaml",
        {{"--tests", "4"}, {"--agents", "1,3"}, {"--behaviours", "proximity,random_action"}}, more);
  }
  /// One behaviour with one agent, judged by the scenario's assertions.
  [[nodiscard]] CommandRun rules(const std::vector<std::string>& more) const {
    return compare("rules_of_the_road.yaml",
                   {{"--tests", "3"},
                    {"--agents", "1"},
                    {"--behaviours", JAYWALK_SOURCE_DIR "/agents/crossing/proximity.asl"}},
                   more);
  }
  /// A behaviour whose plan fails.
  [[nodiscard]] CommandRun failing(const std::vector<std::string>& more) const {
    return compare("paper.yaml",
                   {{"--tests", "3"},
                    {"--agents", "1"},
                    {"--behaviours", file("bad.asl", "!g. +!g <- .fail.\n")}},
                   more);
  }
};

TEST_F(CompareOutputs, AreTheSameInEveryFormat) {
  const std::vector<std::string> csv = lines_of(paper({"--format", "csv"}).output);
  ASSERT_EQ(csv.size(), 5U);
  EXPECT_THAT(csv[0], StartsWith("behaviour,agents,tests,successes,errored,accuracy_pct,"));
  EXPECT_THAT(csv[1], StartsWith("proximity,1,4,2,0,50,"));
  EXPECT_THAT(csv[4], StartsWith("random_action,3,4,3,0,75,"));
  const auto json = nlohmann::json::parse(paper({"--format", "json"}).output);
  const std::string text = json.dump();
  EXPECT_THAT(text, HasSubstr("\"behaviour\":\"proximity\""));
  const std::vector<std::string> markdown = lines_of(paper({"--format", "markdown"}).output);
  ASSERT_GE(markdown.size(), 6U);
  EXPECT_THAT(markdown[1], StartsWith("|---|--:|"));
  EXPECT_THAT(markdown[2], StartsWith("| proximity | 1 | 4 | 2 |"));
  const std::string table = paper({}).output;
  EXPECT_THAT(table, HasSubstr("proximity (35 lines of AgentSpeak)"));
  EXPECT_THAT(table, HasSubstr("     3       100.0     51.0 to 100.0 "));
}

TEST_F(CompareOutputs, AreWrittenAsTheyArePrinted) {
  const std::vector<std::string> printed =
      lines_of(paper({"--format", "csv", "--csv", path("a.csv"), "--json", path("a.json")}).output);
  EXPECT_EQ(lines_of(text("a.csv")), printed);
  EXPECT_TRUE(nlohmann::json::accept(text("a.json")));
}

TEST_F(CompareOutputs, OfSingleTestsAreALineForEach) {
  ASSERT_EQ(paper({"--quiet", "--per-test", path("p.csv")}).code, ExitCode::success);
  const std::vector<std::string> lines = lines_of(text("p.csv"));
  ASSERT_EQ(lines.size(), 17U);
  EXPECT_EQ(lines[0],
            "behaviour,agents,test,ended_by,ticks,precondition_ticks,collision,impact_mps");
  EXPECT_EQ(lines[1], "proximity,1,0,road_end,11,,0,");
  EXPECT_EQ(lines[2], "proximity,1,1,precondition,3,3,1,9");
  EXPECT_THAT(lines[16], StartsWith("random_action,3,3,"));
  // Half of the first four met the precondition, as the table says.
  EXPECT_EQ(std::count_if(
                lines.begin() + 1, lines.begin() + 5,
                [](const std::string& line) { return line.find(",precondition,") != line.npos; }),
            2);
}

TEST_F(CompareOutputs, OfSingleTestsAreTheSameFromAStore) {
  ASSERT_EQ(rules({"--quiet", "--per-test", path("p.csv")}).code, ExitCode::success);
  ASSERT_EQ(rules({"--quiet", "--per-test", path("s.csv"), "--store", path("s.gpkg")}).code,
            ExitCode::success);
  EXPECT_EQ(text("s.csv"), text("p.csv"));
  EXPECT_THAT(lines_of(text("p.csv"))[0], HasSubstr("collision_avoidance"));
}

TEST_F(CompareOutputs, OfStartCellsAreReadByAScenario) {
  ASSERT_EQ(paper({"--quiet", "--starts", path("s.csv"), "--per-test", path("p.csv")}).code,
            ExitCode::success);
  const std::vector<std::string> lines = lines_of(text("s.csv"));
  ASSERT_EQ(lines.size(), 1U + 4 * 3) << "of the largest number of agents";
  EXPECT_EQ(lines[0], "test,agent,row,cell");
  EXPECT_EQ(lines[1], "0,1,10,39");
  const std::string set = "world.spawn.cells=" + path("s.csv");
  ASSERT_EQ(paper({"--quiet", "--agents", "3", "--per-test", path("again.csv"), "--set", set}).code,
            ExitCode::success);
  const std::vector<std::string> again = lines_of(text("again.csv"));
  EXPECT_EQ(again.size(), 9U) << "two behaviours";
  for (const std::string& line : again) EXPECT_THAT(text("p.csv"), HasSubstr(line + '\n'));
}

TEST_F(CompareOutputs, OfSituationsAreTheSameFromAStoreThatIsGoneOnWith) {
  const CommandRun whole = paper({"--situations"});
  EXPECT_THAT(whole.output, HasSubstr("hole"));
  ASSERT_EQ(
      paper({"--tests", "2", "--quiet", "--store", path("s.gpkg"), "--store-level", "all"}).code,
      ExitCode::success);
  const CommandRun rest =
      paper({"--situations", "--store", path("s.gpkg"), "--store-level", "all", "--resume"});
  EXPECT_EQ(rest.code, ExitCode::success) << rest.errors;
  const auto situations = [](const std::string& output) {
    return output.substr(std::min(output.find("bins covered"), output.size()));
  };
  EXPECT_EQ(situations(rest.output), situations(whole.output));
  EXPECT_GT(situations(whole.output).size(), 500U);
}

TEST_F(CompareOutputs, OfAReportAreAPictureOrAPage) {
  ASSERT_EQ(paper({"--quiet", "--report", path("r.svg")}).code, ExitCode::success);
  EXPECT_THAT(text("r.svg"), StartsWith("<svg "));
  EXPECT_THAT(text("r.svg"), HasSubstr("proximity"));
  ASSERT_EQ(paper({"--quiet", "--report", path("r.html")}).code, ExitCode::success);
  EXPECT_THAT(text("r.html"), StartsWith("<!doctype html>"));
  EXPECT_THAT(text("r.html"), HasSubstr("jaywalk compare "));
  EXPECT_THAT(text("r.html"), Not(HasSubstr("jaywalk replay"))) << "no store has the tests";
}

TEST_F(CompareOutputs, SayWhatHappenedToAgentsBesideTheTable) {
  const CommandRun table = failing({});
  EXPECT_EQ(table.code, ExitCode::success) << "it is no failure unless --strict says so";
  EXPECT_THAT(table.output, HasSubstr("bad (1 line of AgentSpeak)"));
  EXPECT_THAT(table.output, HasSubstr("bad: 3 of 3 agents dropped an intention"));
  EXPECT_THAT(table.output, HasSubstr("    3 agents: ia_failed, bad.asl:1:12, .fail\n"));
  const CommandRun csv = failing({"--format", "csv"});
  EXPECT_EQ(lines_of(csv.output).size(), 2U) << "what is for programs has only their format";
  EXPECT_THAT(csv.errors, HasSubstr("bad: 3 of 3 agents dropped an intention"));
  const CommandRun quiet = failing({"--quiet"});
  EXPECT_EQ(quiet.output, "");
  EXPECT_THAT(quiet.errors, HasSubstr("bad: its agents never acted"));
}

TEST_F(CompareOutputs, FailStrictlyWhereAgentsDidNothing) {
  const CommandRun strict = failing({"--strict"});
  EXPECT_EQ(strict.code, ExitCode::failed);
  EXPECT_THAT(strict.errors, HasSubstr("error: --strict: agents dropped intentions"));
  EXPECT_EQ(paper({"--strict", "--quiet"}).code, ExitCode::success);
}

TEST_F(CompareOutputs, NameTheRowsThatMeetAConditionOfFailure) {
  const CommandRun run = paper({"--quiet", "--fail-on", "accuracy<80", "--fail-on", "agents>9"});
  EXPECT_EQ(run.code, ExitCode::usage) << "agents are no measure";
  const CommandRun failed = paper({"--quiet", "--fail-on", "accuracy<80"});
  EXPECT_EQ(failed.code, ExitCode::failed);
  EXPECT_THAT(failed.errors,
              HasSubstr("failed: proximity with 1 agent: accuracy is 50 (accuracy<80)\n"));
  EXPECT_THAT(failed.errors, Not(HasSubstr("proximity with 3 agents")));
  EXPECT_THAT(failed.errors, HasSubstr("random_action with 3 agents: accuracy is 75"));
}

TEST_F(CompareOutputs, FailByTheVerdictsOfAssertions) {
  EXPECT_EQ(rules({"--quiet", "--fail-on", "stopping_distance.fail>1"}).code, ExitCode::failed);
  EXPECT_EQ(rules({"--quiet", "--fail-on", "stopping_distance.fail>2"}).code, ExitCode::success);
  EXPECT_EQ(rules({"--quiet", "--fail-on", "speed_limit.pass<3"}).code, ExitCode::success);
  EXPECT_EQ(rules({"--quiet", "--fail-on", "avoidability.exercised_pct>=100"}).code,
            ExitCode::failed);
}

TEST_F(CompareOutputs, HaveAVerdictForEachAssertionAndItsJUnit) {
  const CommandRun run = rules({"--junit", path("j.xml")});
  EXPECT_THAT(run.output,
              HasSubstr("  stopping_distance          1        100.0        1        2"));
  EXPECT_THAT(text("j.xml"), HasSubstr("<testsuite name=\"stopping_distance\" tests=\"1\" "
                                       "failures=\"1\""));
  EXPECT_THAT(text("j.xml"), HasSubstr("2 of 3 tests violate it"));
}

TEST_F(CompareOutputs, OfDefectsSayWhoKillsThem) {
  const CommandRun run = rules({"--defects", "latency,short-range=12", "--kills", path("k.csv")});
  EXPECT_EQ(run.code, ExitCode::success);
  const std::vector<std::string> lines = lines_of(text("k.csv"));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[1], StartsWith("near,1,latency,0.3,3,0,"));
  EXPECT_THAT(lines[2], StartsWith("near,1,short-range,12,3,0,"));
  EXPECT_THAT(run.output, HasSubstr("short-range=12  nobody"));
}

TEST_F(CompareOutputs, OfDefectsHaveTheKillsOfOtherFilesBeside) {
  const std::string header =
      "behaviour,agents,defect,severity,tests,kills,kill_pct,low,high,first_kill_median\n";
  const std::string other = file("o.csv", header +
                                              "hunter,1,latency,0.3,9,9,100,70,100,1\n"
                                              "hunter,1,short-range,12,9,9,100,70,100,1\n");
  const CommandRun run = rules({"--defects", "latency", "--with-kills", other});
  EXPECT_EQ(run.code, ExitCode::success) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("hunter"));
  EXPECT_THAT(run.errors, HasSubstr("left out are defects that are not looked for here"));
}

TEST_F(CompareOutputs, OfModelsRankThem) {
  const std::string output = rules({"--avs", "constant,idm"}).output;
  const std::size_t first = output.find("1. idm ");
  const std::size_t second = output.find("2. constant ");
  ASSERT_NE(first, output.npos);
  EXPECT_LT(first, second) << "the one that hits nobody comes first";
}

TEST_F(CompareOutputs, OfAChainedScenarioAreTheSameWhenItIsGoneOnWith) {
  const std::vector<std::string> chained{"--quiet", "--set", "world.av.carry_over=true"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), chained.begin(), chained.end());
    return paper(more);
  };
  ASSERT_EQ(with({"--per-test", path("whole.csv")}).code, ExitCode::success);
  ASSERT_EQ(with({"--tests", "2", "--store", path("s.gpkg")}).code, ExitCode::success);
  const CommandRun rest =
      with({"--store", path("s.gpkg"), "--resume", "--per-test", path("rest.csv")});
  ASSERT_EQ(rest.code, ExitCode::success) << rest.errors;
  EXPECT_EQ(text("rest.csv"), text("whole.csv"));
}

TEST_F(CompareOutputs, TraceTheTestsInTheirOrderOnAnyThreads) {
  ASSERT_EQ(paper({"--quiet", "--threads", "1", "--trace", path("1.txt")}).code, ExitCode::success);
  ASSERT_EQ(paper({"--quiet", "--threads", "4", "--trace", path("4.txt")}).code, ExitCode::success);
  EXPECT_EQ(text("1.txt"), text("4.txt"));
  std::vector<std::string> tests;
  for (const std::string& line : lines_of(text("1.txt"))) {
    const auto json = nlohmann::json::parse(line);
    if (json["kind"] == "test") tests.push_back(line);
  }
  ASSERT_EQ(tests.size(), 16U);
  EXPECT_THAT(tests[4], HasSubstr("\"behaviour\":\"proximity\",\"agents\":3,\"test\":0"));
}

}  // namespace
}  // namespace jaywalk
