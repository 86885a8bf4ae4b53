// Options of compare, learn and search that make no sense together, or not with the scenario.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;

constexpr const char* kPaper = JAYWALK_SOURCE_DIR "/scenarios/paper.yaml";

class Usage : public FolderTest {
 protected:
  /// What is wrong with the words; it fails the test if they are not refused.
  [[nodiscard]] std::string problem(const std::vector<std::string>& words) const {
    const CommandRun run = run_command(words);
    EXPECT_EQ(run.code, ExitCode::usage);
    EXPECT_EQ(run.output, "");
    return run.errors;
  }
  [[nodiscard]] std::string of_compare(std::vector<std::string> more) const {
    more.insert(more.begin(), {"compare", kPaper});
    return problem(more);
  }
};

TEST_F(Usage, OfCompareNamesAllThatIsWrongAtOnce) {
  const std::string said =
      of_compare({"--tests", "many", "--agents", "x", "--shard", "3/2", "--store-level", "much"});
  EXPECT_THAT(said, HasSubstr("--tests: error: expected a whole number from 1, found 'many'"));
  EXPECT_THAT(said, HasSubstr("--agents: error: "));
  EXPECT_THAT(said, HasSubstr("--shard: error: expected I/N with I from 1 to N, found '3/2'"));
  EXPECT_THAT(said,
              HasSubstr("--store-level: error: expected summary, found or all, found 'much'"));
}

TEST_F(Usage, LetsNoOutputTakeThePlaceOfAnotherFile) {
  const std::string out = path("out");
  EXPECT_EQ(of_compare({"--csv", out, "--json", path("./out")}),
            "--json: error: would write over '" + path("./out") + "', which --csv writes\n");
  const std::string store = this->file("a.gpkg", "");
  EXPECT_EQ(problem({"report", store, "--html", store}),
            "--html: error: would write over '" + store + "', which the command reads\n");
  const std::string rules = this->file("rules.yaml", "");
  EXPECT_EQ(of_compare({"--assertions", rules, "--junit", rules}),
            "--junit: error: would write over '" + rules + "', which --assertions reads\n");
}

TEST_F(Usage, OfCompareBoundsTestsAndAgents) {
  EXPECT_THAT(of_compare({"--tests", "99999999999999"}), HasSubstr("--tests: error: at most "));
  EXPECT_THAT(of_compare({"--agents", "100000000"}), HasSubstr("--agents: error: at most "));
}

TEST_F(Usage, OfCompareNeedsAStoreForOptionsAboutIt) {
  EXPECT_THAT(of_compare({"--resume"}),
              HasSubstr("--resume: error: has no meaning without --store"));
  EXPECT_THAT(of_compare({"--shard", "1/2"}),
              HasSubstr("--shard: error: has no meaning without --store"));
  EXPECT_THAT(of_compare({"--store", path("a.gpkg"), "--retry-errors"}),
              HasSubstr("--retry-errors: error: has no meaning without --resume"));
}

TEST_F(Usage, OfCompareNeedsAssertionsToBlameDefects) {
  EXPECT_THAT(of_compare({"--defects", "all"}),
              HasSubstr("--defects: error: without assertions nothing blames an AV"));
  EXPECT_THAT(of_compare({"--junit", path("j.xml")}),
              HasSubstr("--junit: error: there are no assertions to judge"));
}

TEST_F(Usage, OfCompareSuggestsKeysAndBehaviours) {
  EXPECT_THAT(of_compare({"--set", "world.av.sped=3"}), HasSubstr("did you mean"));
  EXPECT_THAT(of_compare({"--behaviours", "proxmity"}), HasSubstr("did you mean 'proximity'?"));
}

TEST_F(Usage, OfCompareWantsOneScenario) {
  EXPECT_THAT(problem({"compare"}), HasSubstr("expected one scenario, found 0"));
  EXPECT_THAT(of_compare({kPaper}), HasSubstr("expected one scenario, found 2"));
  EXPECT_THAT(problem({"compare", file("a.yaml", "world: [")}), HasSubstr("a.yaml:1:"));
}

TEST_F(Usage, OfLearnWantsAScenarioAndAFileForWhatIsLearned) {
  const std::string said = problem({"learn"});
  EXPECT_THAT(said, HasSubstr("expected one scenario, found 0"));
  EXPECT_THAT(said, HasSubstr("--policy: error: "));
  EXPECT_THAT(problem({"learn", kPaper, "--policy", path("p.json"), "--agents", "99999999"}),
              HasSubstr("--agents: error: at most "));
  EXPECT_FALSE(exists("p.json"));
}

TEST_F(Usage, OfSearchWantsOneExperiment) {
  EXPECT_THAT(problem({"search"}), HasSubstr("expected one experiment, found 0"));
  const std::string roads = JAYWALK_SOURCE_DIR "/scenarios/search/none.yaml";
  EXPECT_THAT(problem({"search", roads}), HasSubstr("none.yaml"));
  EXPECT_THAT(problem({"search", roads, "--resume"}),
              HasSubstr("there is no --store to go on with"));
  EXPECT_THAT(problem({"search", roads, "--repetitions", "100001"}),
              HasSubstr("--repetitions: error: at most 100000, found 100001"));
}

TEST_F(Usage, OfNumbersIsCheckedByEveryCommandThatTakesThem) {
  EXPECT_THAT(problem({"run", file("a.asl", "b."), "--timeout", "0"}),
              HasSubstr("--timeout: error: expected a number greater than 0, found '0'"));
  EXPECT_THAT(problem({"run", path("a.asl"), "--max-cycles", "-1"}), HasSubstr("--max-cycles"));
  EXPECT_THAT(problem({"test", path("a.asl"), "--threads", "0"}),
              HasSubstr("--threads: error: expected a whole number from 1, found '0'"));
  EXPECT_THAT(problem({"check", path("a.asl"), "--map", "nothing"}),
              HasSubstr("--map: error: expected PREFIX=FOLDER, found 'nothing'"));
}

}  // namespace
}  // namespace jaywalk
