// SPDX-License-Identifier: Apache-2.0
// Commands about scenarios and the stores of their tests: compare, merge, coverage, explain,
// export, judge, replay, report.

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kScenario = JAYWALK_SOURCE_DIR "/scenarios/paper.yaml";
constexpr const char* kAssertions = JAYWALK_SOURCE_DIR "/scenarios/assertions/crossing.yaml";

/// Two behaviours, 1 and 3 agents, 4 tests each.
class StoreCommands : public FolderTest {
 protected:
  [[nodiscard]] CommandRun compare(std::vector<std::string> more) const {
    std::vector<std::string> words{"compare",  kScenario, "--tests",      "4",
                                   "--agents", "1,3",     "--behaviours", "proximity,random_action",
                                   "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return run_command(words);
  }
  /// A store with what agents did in every test.
  [[nodiscard]] std::string store() const {
    EXPECT_EQ(compare({"--store", path("a.gpkg"), "--store-level", "all"}).code, ExitCode::success);
    return path("a.gpkg");
  }
  /// A CSV without its columns of measured times.
  [[nodiscard]] std::string without_times(const std::string& name) const {
    std::string kept;
    std::istringstream lines(text(name));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      std::string cell;
      for (int column = 0; std::getline(cells, cell, ','); ++column) {
        if (column != 19 && column != 20) kept += cell + ',';
      }
      kept += '\n';
    }
    return kept;
  }
};

TEST_F(StoreCommands, CompareGivesTheSameOnAnyNumberOfThreads) {
  EXPECT_EQ(compare({"--csv", path("1.csv"), "--threads", "1"}).code, ExitCode::success);
  EXPECT_EQ(compare({"--csv", path("3.csv"), "--threads", "3"}).code, ExitCode::success);
  EXPECT_EQ(compare({"--csv", path("s.csv"), "--seed", "77"}).code, ExitCode::success);
  EXPECT_THAT(without_times("1.csv"), HasSubstr("\nproximity,3,4,"));
  EXPECT_EQ(without_times("1.csv"), without_times("3.csv"));
  EXPECT_NE(without_times("1.csv"), without_times("s.csv"));
}

TEST_F(StoreCommands, CompareSaysNothingWhereItIsToBeQuiet) {
  const CommandRun run = compare({"--json", path("a.json")});
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(run.errors, "");
  EXPECT_THAT(text("a.json"), StartsWith("{"));
}

TEST_F(StoreCommands, CompareFailsWhereAMeasureIsAsked) {
  EXPECT_EQ(compare({"--fail-on", "accuracy<101"}).code, ExitCode::failed);
  EXPECT_EQ(compare({"--fail-on", "accuracy<0"}).code, ExitCode::success);
  const CommandRun wrong = compare({"--fail-on", "acuracy<1"});
  EXPECT_EQ(wrong.code, ExitCode::usage);
  EXPECT_THAT(wrong.errors, HasSubstr("did you mean 'accuracy'?"));
}

TEST_F(StoreCommands, CompareWritesNoStoreOverAnother) {
  const std::string first = store();
  const std::string before = text("a.gpkg");
  const CommandRun again = compare({"--store", first});
  EXPECT_EQ(again.code, ExitCode::usage);
  EXPECT_THAT(again.errors, HasSubstr("the file exists"));
  EXPECT_EQ(text("a.gpkg"), before);
}

TEST_F(StoreCommands, CompareGoesOnWithAStoreThatIsComplete) {
  const std::string first = store();
  EXPECT_EQ(
      compare({"--store", first, "--store-level", "all", "--resume", "--csv", path("r.csv")}).code,
      ExitCode::success);
  EXPECT_EQ(compare({"--csv", path("f.csv")}).code, ExitCode::success);
  EXPECT_EQ(without_times("r.csv"), without_times("f.csv"));
}

TEST_F(StoreCommands, MergeMakesOneStoreOfTheShardsOfAnExperiment) {
  ASSERT_EQ(compare({"--store", path("1.gpkg"), "--shard", "1/2"}).code, ExitCode::success);
  ASSERT_EQ(compare({"--store", path("2.gpkg"), "--shard", "2/2"}).code, ExitCode::success);
  const CommandRun merged = run_command({"merge", path("m.gpkg"), path("1.gpkg"), path("2.gpkg")});
  EXPECT_EQ(merged.code, ExitCode::success);
  EXPECT_THAT(merged.output, HasSubstr("proximity"));
  EXPECT_EQ(merged.errors, "");
  EXPECT_EQ(compare({"--store", path("m.gpkg"), "--resume", "--csv", path("m.csv")}).code,
            ExitCode::success);
  EXPECT_EQ(compare({"--csv", path("whole.csv")}).code, ExitCode::success);
  EXPECT_EQ(without_times("m.csv"), without_times("whole.csv"));
}

TEST_F(StoreCommands, MergeSaysWhatIsMissing) {
  ASSERT_EQ(compare({"--store", path("1.gpkg"), "--shard", "1/2"}).code, ExitCode::success);
  const CommandRun merged = run_command({"merge", path("m.gpkg"), path("1.gpkg"), path("1.gpkg")});
  EXPECT_EQ(merged.code, ExitCode::success);
  EXPECT_THAT(merged.errors, HasSubstr("8 of 16 tests are missing; compare --store"));
  const CommandRun again = run_command({"merge", path("m.gpkg"), path("1.gpkg"), path("1.gpkg")});
  EXPECT_EQ(again.code, ExitCode::usage);
  EXPECT_THAT(again.errors, HasSubstr("the file exists"));
}

TEST_F(StoreCommands, MergeRefusesStoresOfOtherExperiments) {
  const std::string first = store();
  ASSERT_EQ(compare({"--store", path("b.gpkg"), "--store-level", "all", "--seed", "77"}).code,
            ExitCode::success);
  const CommandRun run = run_command({"merge", path("m.gpkg"), first, path("b.gpkg")});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("not of the same experiment"));
  EXPECT_FALSE(exists("m.gpkg"));
}

TEST_F(StoreCommands, CoverageCountsTheSituationsOfEachBehaviour) {
  const std::string runs = store();
  const CommandRun run = run_command({"coverage", runs, "--csv", path("c.csv")});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_THAT(run.output, HasSubstr("proximity          3        4 "));
  EXPECT_GT(text("c.csv").size(), 100U);
  const CommandRun one = run_command({"coverage", runs, "--behaviour", "random_action"});
  EXPECT_THAT(one.output, testing::Not(HasSubstr("proximity")));
}

TEST_F(StoreCommands, CoverageRefusesTestsThatTheStoreDoesNotHave) {
  const std::string runs = store();
  const CommandRun behaviour = run_command({"coverage", runs, "--behaviour", "proxmity"});
  EXPECT_EQ(behaviour.code, ExitCode::usage);
  EXPECT_THAT(behaviour.errors,
              HasSubstr("no behaviour 'proxmity'\n  hint: did you mean 'proximity'?"));
  const CommandRun agents = run_command({"coverage", runs, "--agents", "7"});
  EXPECT_EQ(agents.code, ExitCode::usage);
  EXPECT_THAT(agents.errors, HasSubstr("no tests with 7 agents"));
  EXPECT_THAT(run_command({"coverage", runs, "--coverage", path("c.pdf")}).errors,
              HasSubstr("expected a file .txt, .html or .info"));
}

TEST_F(StoreCommands, ReportIsAPageBesideTheStore) {
  const CommandRun run = run_command({"report", store()});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(text("a.html"), HasSubstr("proximity"));
  EXPECT_EQ(run_command({"report"}).code, ExitCode::usage);
}

TEST_F(StoreCommands, ReplayShowsATestAsItWas) {
  const std::string runs = store();
  const CommandRun run =
      run_command({"replay", runs, "--behaviour", "proximity", "--agents", "3", "--test", "1"});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_EQ(run.output, run_command({"replay", runs, "--behaviour", "proximity", "--agents", "3",
                                     "--test", "1"})
                            .output);
  EXPECT_THAT(
      run.output,
      HasSubstr("tick 3: AV at 18, 9.0 m/s, collision with 1, precondition met in 13 to 18\n"));
}

TEST_F(StoreCommands, ReplaySaysWhichTestsThereAre) {
  const std::string runs = store();
  EXPECT_THAT(run_command({"replay", runs, "--test", "99"}).errors,
              HasSubstr("the store has no such test"));
  EXPECT_THAT(run_command({"replay", runs, "--tick", "3"}).errors,
              HasSubstr("--tick: error: has no meaning without --png"));
  EXPECT_THAT(run_command({"replay", runs, runs}).errors, HasSubstr("expected one store, found 2"));
}

TEST_F(StoreCommands, ExplainKnowsTheAgentsOfATest) {
  const std::string runs = store();
  const CommandRun run = run_command({"explain", runs, "--agent", "zz"});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("the test has no agent 'zz'"));
}

TEST_F(StoreCommands, ExportWritesTheTestsAsFiles) {
  const std::string runs = store();
  for (const char* format : {"openscenario", "csv", "trace", "json"}) {
    const std::string folder = path(format);
    const CommandRun run =
        run_command({"export", runs, "--format", format, "--all", "--out", folder});
    EXPECT_EQ(run.code, ExitCode::success) << format << run.errors;
    const auto files = std::count(run.output.begin(), run.output.end(), '\n');
    EXPECT_GE(files, 1) << format;
    std::istringstream names(run.output);
    for (std::string name; std::getline(names, name);) {
      EXPECT_TRUE(std::filesystem::file_size(name) > 0) << name;
    }
  }
}

TEST_F(StoreCommands, ExportSuggestsFormatsAndRefusesTestsThatAreNotThere) {
  const std::string runs = store();
  const CommandRun format = run_command({"export", runs, "--format", "openscenari"});
  EXPECT_EQ(format.code, ExitCode::usage);
  EXPECT_THAT(format.errors, HasSubstr("unknown format 'openscenari'"));
  EXPECT_THAT(format.errors, HasSubstr("did you mean 'openscenario'?"));
  const CommandRun test = run_command({"export", runs, "--test", "99", "--out", path("out")});
  EXPECT_EQ(test.code, ExitCode::usage);
  EXPECT_THAT(test.errors, HasSubstr("the store has no test 99"));
}

TEST_F(StoreCommands, JudgeCountsTheViolationsOfEachAssertion) {
  const std::string runs = store();
  const CommandRun run =
      run_command({"judge", runs, "--assertions", kAssertions, "--csv", path("j.csv")});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_THAT(run.output, HasSubstr("lane_keeping"));
  EXPECT_THAT(text("j.csv"), HasSubstr("lane_keeping"));
  const CommandRun nothing = run_command({"judge", runs});
  EXPECT_EQ(nothing.code, ExitCode::usage);
  EXPECT_THAT(nothing.errors, HasSubstr("there is nothing to judge"));
}

TEST_F(StoreCommands, StoresAreFilesThatJaywalkWrote) {
  const std::string other = file("other.gpkg", "not a store");
  for (const char* command : {"coverage", "explain", "export", "judge", "replay", "report"}) {
    std::vector<std::string> words{command, other};
    if (words[0] == "judge") words.insert(words.end(), {"--assertions", kAssertions});
    const CommandRun run = run_command(words);
    EXPECT_EQ(run.code, ExitCode::usage) << command;
    EXPECT_THAT(run.errors, HasSubstr("it is no SQLite file")) << command;
    EXPECT_EQ(run.output, "") << command;
  }
}

}  // namespace
}  // namespace jaywalk
