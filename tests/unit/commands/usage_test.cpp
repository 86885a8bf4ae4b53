// SPDX-License-Identifier: Apache-2.0
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
using testing::Not;

constexpr const char* kPaper = JAYWALK_SOURCE_DIR "/scenarios/paper.yaml";

class Usage : public FolderTest {
 protected:
  /// The error about the words; it fails the test if they are not refused.
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
  EXPECT_THAT(said, HasSubstr("--tests: error: expected a whole number from 1 to 10000000, "
                              "found 'many'"));
  EXPECT_THAT(said, HasSubstr("--agents: error: "));
  EXPECT_THAT(said, HasSubstr("--shard: error: expected I/N with I from 1 to N and N up to "
                              "4294967295, found '3/2'"));
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
  for (const char* tests : {"99999999999999", "99999999999999999999"}) {
    EXPECT_THAT(of_compare({"--tests", tests}),
                HasSubstr("--tests: error: expected a whole number from 1 to 10000000, found"));
  }
  EXPECT_THAT(of_compare({"--agents", "100000000"}),
              HasSubstr("--agents: error: expected a number from 1 to 10000 or a range, found"));
}

TEST_F(Usage, NamesFoldersOfIncludesThatAreNotThere) {
  const std::string missing = path("missing");
  EXPECT_EQ(problem({"run", file("a.asl", "b."), "--include", missing}),
            "--include: error: there is no folder '" + missing + "'\n");
}

TEST_F(Usage, OfCompareShowsABrokenPolicyAndNothingThatFollowsFromIt) {
  const std::string policy = file("p.json", "{");
  const std::string said = of_compare({"--policy", policy});
  EXPECT_THAT(said, HasSubstr(policy + ":1:"));
  EXPECT_THAT(said, Not(HasSubstr("has no policy")));
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
              HasSubstr("--agents: error: expected a whole number from 1 to 10000, found "));
  EXPECT_FALSE(exists("p.json"));
}

TEST_F(Usage, OfSearchWantsOneExperiment) {
  EXPECT_THAT(problem({"search"}), HasSubstr("expected one experiment, found 0"));
  const std::string roads = JAYWALK_SOURCE_DIR "/scenarios/search/none.yaml";
  EXPECT_THAT(problem({"search", roads}), HasSubstr("none.yaml"));
  EXPECT_THAT(problem({"search", roads, "--resume"}),
              HasSubstr("there is no --store to go on with"));
  EXPECT_THAT(problem({"search", roads, "--repetitions", "100001"}),
              HasSubstr("expected a whole number from 1 to 100000, found '100001'"));
}

TEST_F(Usage, TakesNoOptionTwiceThatCannotBeRepeated) {
  const std::string said = of_compare({"--csv", path("a"), "--csv", path("b"), "--seed", "1",
                                       "--seed=2", "--json", path("c"), "--quiet", "--quiet"});
  EXPECT_THAT(said, HasSubstr("--csv: error: given 2 times, with the values '" + path("a") +
                              "', '" + path("b") + "'"));
  EXPECT_THAT(said, HasSubstr("--seed: error: given 2 times, with the values '1', '2'"));
  EXPECT_THAT(said, Not(HasSubstr("--json")));
  EXPECT_THAT(said, Not(HasSubstr("--quiet"))) << "says the same twice";
}

/// In every command, exactly the options whose values are all used may be repeated.
TEST_F(Usage, NamesInTheHelpWhichOptionsMayBeRepeated) {
  for (const Command& command : commands()) {
    std::vector<OptionSpec> options = command.help().options;
    options.insert(options.end(), common_options().begin(), common_options().end());
    for (const OptionSpec& option : options) {
      const std::string name = option.name.dashed();
      const std::vector<std::string> twice{name, "x", name, "y"};
      if (option.value.empty()) continue;
      EXPECT_EQ(parse_arguments(twice, options).ok(), option.is_repeatable())
          << command.name << " " << name;
    }
  }
}

TEST_F(Usage, GivesNoKeyTwice) {
  const std::string said = of_compare({"--set", "world.length=80", "--set", "world.length=70"});
  EXPECT_THAT(said,
              HasSubstr("--set world.length=70: error: the key 'world.length' is given twice"));
  EXPECT_THAT(of_compare({"--set", "experiment.defects=latency", "--defects", "all"}),
              HasSubstr("the key 'experiment.defects' is given twice"));
}

TEST_F(Usage, NamesTheCommandThatTakesAFile) {
  const std::string program = file("m1.asl", "!go. +!go <- .print(hi).");
  const std::string project = file("p.mas2j", "MAS p { agents: m1; }");
  const std::string search = JAYWALK_SOURCE_DIR "/scenarios/search/lane-keeping.yaml";
  const std::string rules = JAYWALK_SOURCE_DIR "/scenarios/assertions/crossing.yaml";
  const std::string store = file("runs.gpkg", std::string("SQLite format 3\0", 16));
  EXPECT_EQ(problem({"compare", program}),
            program + ": error: expected a scenario (.yaml), found a program of agents (.asl)\n" +
                "  hint: `jaywalk run " + program + "` runs it; `jaywalk compare SCENARIO.yaml " +
                "--behaviours " + program + "` compares it with others\n");
  EXPECT_THAT(problem({"learn", project, "--policy", path("p.json")}),
              HasSubstr("found a project of agents (.mas2j)\n  hint: `jaywalk run"));
  EXPECT_THAT(problem({"compare", search}), HasSubstr("`jaywalk search " + search + "` runs it"));
  EXPECT_THAT(problem({"run", search}), HasSubstr("`jaywalk search " + search + "` runs it"));
  EXPECT_THAT(problem({"reach", search}), HasSubstr("`jaywalk search " + search + "` runs it"));
  EXPECT_THAT(problem({"search", kPaper}), HasSubstr("found a scenario (.yaml)"));
  EXPECT_THAT(problem({"compare", rules}), HasSubstr("--assertions " + rules));
  EXPECT_THAT(of_compare({"--assertions", kPaper}),
              HasSubstr("expected a list of assertions (.yaml), found a scenario (.yaml)"));
  EXPECT_THAT(problem({"compare", store}), HasSubstr("`jaywalk report " + store + "` shows"));
  for (const char* command : {"judge", "report", "replay", "explain", "coverage", "export"}) {
    EXPECT_THAT(problem({command, kPaper}),
                HasSubstr("expected a store (.gpkg), found a scenario (.yaml)"))
        << command;
  }
  EXPECT_THAT(problem({"merge", path("out.gpkg"), kPaper}), HasSubstr("expected a store (.gpkg)"));
  for (const char* command : {"fmt", "test", "repl"}) {
    EXPECT_THAT(problem({command, kPaper}), HasSubstr("expected a program of agents (.asl)"))
        << command;
  }
}

TEST_F(Usage, SuggestsTheFileThatIsMeant) {
  (void)file("scenarios/paper.yaml", "");
  (void)file("m2.asl", "!go.");
  EXPECT_EQ(problem({"compare", path("scenario/paper.yaml")}),
            path("scenario/paper.yaml") + ": error: no such file\n  hint: did you mean '" +
                path("scenarios/paper.yaml") + "'?\n");
  EXPECT_THAT(problem({"run", path("m2")}), HasSubstr("did you mean '" + path("m2.asl") + "'?"));
  EXPECT_THAT(of_compare({"--behaviours", path("m2")}),
              HasSubstr("did you mean '" + path("m2.asl") + "'?"));
}

TEST_F(Usage, OfNumbersIsCheckedByEveryCommandThatTakesThem) {
  EXPECT_THAT(problem({"run", file("a.asl", "b."), "--timeout", "0"}),
              HasSubstr("--timeout: error: expected a number greater than 0, at most 1000000000, "
                        "found '0'"));
  EXPECT_THAT(problem({"run", path("a.asl"), "--max-cycles", "-1"}), HasSubstr("--max-cycles"));
  EXPECT_THAT(problem({"test", path("a.asl"), "--threads", "0"}),
              HasSubstr("--threads: error: expected a whole number from 1 to 1024, found '0'"));
  EXPECT_THAT(problem({"check", path("a.asl"), "--map", "nothing"}),
              HasSubstr("--map: error: expected PREFIX=FOLDER, found 'nothing'"));
}

}  // namespace
}  // namespace jaywalk
