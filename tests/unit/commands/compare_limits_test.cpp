// SPDX-License-Identifier: Apache-2.0
// What `jaywalk compare` refuses once it knows the scenario: what cannot be run, or would say
// nothing. Nothing is run or written then.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;
using testing::Not;

std::string scenario(const std::string& name) {
  return JAYWALK_SOURCE_DIR "/scenarios/" + name + ".yaml";
}

class CompareLimits : public FolderTest {
 protected:
  /// The error about the options; it fails the test if they are accepted.
  [[nodiscard]] std::string refused(const std::string& name, std::vector<std::string> more) const {
    more.insert(more.begin(), {"compare", scenario(name), "--tests", "2", "--agents", "1",
                               "--store", path("s.gpkg")});
    const CommandRun run = run_command(more);
    EXPECT_EQ(run.code, ExitCode::usage);
    EXPECT_EQ(run.output, "");
    EXPECT_FALSE(exists("s.gpkg"));
    return run.errors;
  }
};

TEST_F(CompareLimits, KillsNeedDefects) {
  EXPECT_THAT(refused("paper", {"--kills", path("k.csv")}),
              HasSubstr("--kills: error: has no meaning without defects"));
  EXPECT_THAT(refused("paper", {"--with-kills", path("k.csv")}),
              HasSubstr("--with-kills: error: has no meaning without defects"));
  EXPECT_FALSE(exists("k.csv"));
}

TEST_F(CompareLimits, DefectsNeedAVehicleInWhichTheyShow) {
  const std::string said =
      refused("paper", {"--defects", "latency", "--assertions",
                        JAYWALK_SOURCE_DIR "/scenarios/assertions/crossing.yaml"});
  EXPECT_THAT(said, HasSubstr("--defects: error: the AV is of the model constant"));
  EXPECT_THAT(said, Not(HasSubstr("without assertions")));
}

TEST_F(CompareLimits, DefectsAreToldAllThatKeepsThemFromBeingLookedFor) {
  const std::string said =
      refused("paper", {"--defects", "latency", "--set", "experiment.feedback=2", "--set",
                        "world.av.carry_over=true"});
  EXPECT_THAT(said, HasSubstr("without assertions nothing blames an AV"));
  EXPECT_THAT(said, HasSubstr("the AV is of the model constant"));
  EXPECT_THAT(said, HasSubstr("what tests cover would reach those with other AVs"));
  EXPECT_THAT(said, HasSubstr("each test of this scenario needs the one before it"));
}

TEST_F(CompareLimits, ModelsOfTheAvAreComparedByThemselves) {
  EXPECT_THAT(refused("paper", {"--avs", "idm", "--defects", "latency"}),
              HasSubstr("--avs: error: models and defects cannot be compared at once"));
  EXPECT_THAT(refused("paper", {"--avs", "idm,aeb", "--set", "experiment.feedback=2"}),
              HasSubstr("--avs: error: what tests cover would reach those with other AVs"));
  EXPECT_THAT(refused("paper", {"--avs", "idm,aeb", "--set", "world.av.carry_over=true"}),
              HasSubstr("--avs: error: each test of this scenario needs the one before it"));
  EXPECT_THAT(refused("paper", {"--avs", "idn"}), HasSubstr("did you mean 'idm'?"));
}

TEST_F(CompareLimits, TestsThatNeedEachOtherAreNotSharedOut) {
  EXPECT_THAT(refused("paper", {"--shard", "1/2", "--set", "world.av.carry_over=true"}),
              HasSubstr("--shard: error: each test of this scenario needs the one before it"));
  EXPECT_THAT(refused("paper", {"--shard", "1/2", "--set", "experiment.feedback=2"}),
              HasSubstr("--shard: error: the tests of a part need what the other parts' tests"));
}

TEST_F(CompareLimits, StartCellsAreOfWorldsThatHaveCells) {
  EXPECT_THAT(refused("motorway", {"--starts", path("s.csv"), "--behaviours",
                                   JAYWALK_SOURCE_DIR "/agents/motorway/cut_in.asl"}),
              HasSubstr("--starts: error: agents of this world do not start in cells"));
  EXPECT_FALSE(exists("s.csv"));
}

TEST_F(CompareLimits, GivenStartCellsHaveToBeEnough) {
  const std::string cells = file("cells.csv", "test,agent,row,cell\n0,1,10,39\n");
  EXPECT_THAT(refused("paper", {"--set", "world.spawn.cells=" + cells}), Not(testing::IsEmpty()));
}

TEST_F(CompareLimits, ConditionsAreAboutAssertionsThatAreJudged) {
  EXPECT_THAT(refused("paper", {"--fail-on", "no_such.fail>0"}),
              HasSubstr("--fail-on: error: no assertion 'no_such' is judged"));
  EXPECT_THAT(refused("rules_of_the_road", {"--fail-on", "speed_limt.fail>0"}),
              HasSubstr("did you mean 'speed_limit'?"));
  EXPECT_THAT(refused("rules_of_the_road", {"--fail-on", "speed_limit.fial>0"}),
              HasSubstr("--fail-on: error: "));
}

TEST_F(CompareLimits, ConditionsAreAComparisonWithANumber) {
  for (const char* wrong : {"accuracy", "accuracy<", "<40", "accuracy<x", "accuracy=40", ""}) {
    EXPECT_THAT(refused("paper", {"--fail-on", wrong}), HasSubstr("--fail-on: error: ")) << wrong;
  }
}

TEST_F(CompareLimits, AssertionsOfAFileHaveToBeRight) {
  const std::string rules =
      file("rules.yaml", "assertions:\n  - id: slow\n    require: sped < 3\n");
  EXPECT_THAT(refused("paper", {"--assertions", rules}), HasSubstr("rules.yaml:"));
  EXPECT_THAT(refused("paper", {"--assertions", path("none.yaml")}), HasSubstr("none.yaml"));
}

TEST_F(CompareLimits, OtherKillsHaveTheFormOfKills) {
  const std::vector<std::string> defects{"--defects", "latency", "--with-kills"};
  const auto with = [&](const std::string& text) {
    std::vector<std::string> words = defects;
    words.push_back(file("k.csv", text));
    return refused("rules_of_the_road", words);
  };
  const std::string header =
      "behaviour,agents,defect,severity,tests,kills,kill_pct,low,high,first_kill_median\n";
  EXPECT_THAT(with("nonsense\n"), HasSubstr("k.csv:1:1: error: expected the header"));
  EXPECT_THAT(with(header + "walk,1,latency,0.3,3\n"), HasSubstr("k.csv:2:"));
  EXPECT_THAT(with(header + "walk,1,latency,0.3,3,4,133,0,1,\n"), HasSubstr("k.csv:2:"))
      << "more kills than tests";
  EXPECT_THAT(with(header + "walk,1,latency,x,3,1,33.3,0,1,2\n"), HasSubstr("k.csv:2:"));
}

TEST_F(CompareLimits, FormatsAndSeedsAreCheckedBesideTheScenario) {
  const std::string said = refused("none", {"--format", "xml", "--seed", "-3"});
  EXPECT_THAT(said, HasSubstr("--format: error: expected one of table, csv, json, markdown"));
  EXPECT_THAT(said, HasSubstr("--seed: error: "));
  EXPECT_THAT(said, HasSubstr("none.yaml: error: no such file"));
}

TEST_F(CompareLimits, StoresOfAnotherExperimentAreNotGoneOnWith) {
  const std::vector<std::string> words{
      "compare",      scenario("paper"), "--tests", "1",       "--agents",    "1",
      "--behaviours", "proximity",       "--quiet", "--store", path("o.gpkg")};
  ASSERT_EQ(run_command(words).code, ExitCode::success);
  const std::string before = text("o.gpkg");
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"--seed", "9"}, {"--set", "world.av.speed=3"}, {"--metrics"}}) {
    std::vector<std::string> again = words;
    again.push_back("--resume");
    again.insert(again.end(), other.begin(), other.end());
    const CommandRun run = run_command(again);
    EXPECT_EQ(run.code, ExitCode::usage) << other[0];
    EXPECT_THAT(run.errors, HasSubstr("o.gpkg")) << other[0];
    EXPECT_EQ(text("o.gpkg"), before);
  }
}

}  // namespace
}  // namespace jaywalk
