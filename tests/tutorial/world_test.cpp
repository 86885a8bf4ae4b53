// SPDX-License-Identifier: Apache-2.0
// The world that docs/internals/add_world.md adds is there as the page says, and comparisons run in
// it.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "env/environments.h"
#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;

const std::string kScenario = JAYWALK_TUTORIAL_DIR "/scenarios/corridor.yaml";

class WorldTutorial : public FolderTest {
 protected:
  /// `compare` of 30 tests with each number of people; its JSON.
  nlohmann::json compare(const std::vector<std::string>& more) {
    const std::string json = path("results.json");
    std::vector<std::string> words{"compare", kScenario, "--tests", "30",
                                   "--quiet", "--json",  json};
    words.insert(words.end(), more.begin(), more.end());
    const CommandRun outcome = run_command(words);
    EXPECT_EQ(outcome.code, ExitCode::success) << outcome.errors;
    return nlohmann::json::parse(text("results.json"));
  }
};

TEST_F(WorldTutorial, HasAWorldThatIsListed) {
  EXPECT_EQ(environments().back().name, "corridor");
  EXPECT_THAT(run_command({"list", "environments"}).output, HasSubstr("before a delivery robot"));
}

TEST_F(WorldTutorial, HasAScenarioInWhichNothingIsWrong) {
  const CommandRun outcome = run_command({"check", kScenario});
  EXPECT_EQ(outcome.code, ExitCode::success) << outcome.errors;
  const CommandRun wrong = run_command({"compare", kScenario, "--set", "world.lenght=20"});
  EXPECT_EQ(wrong.code, ExitCode::usage);
  EXPECT_THAT(wrong.errors, HasSubstr("did you mean 'length'"));
}

TEST_F(WorldTutorial, HasPeopleWhoStepOutBeforeTheRobot) {
  const nlohmann::json rank = compare({"--avs", "constant,braking"})["avs"]["rank"];
  ASSERT_EQ(rank.size(), 2U);
  EXPECT_EQ(rank[0]["av"], "braking");
  EXPECT_EQ(rank[0]["collisions"], 0);
  EXPECT_EQ(rank[1]["av"], "constant");
  EXPECT_EQ(rank[1]["collisions"], 60);
  EXPECT_EQ(rank[1]["mean_impact_mps"], 2);
  for (const nlohmann::json& each : rank) EXPECT_EQ(each["successes"], 60);
}

TEST_F(WorldTutorial, HasTestsThatStoresKeep) {
  const std::string store = path("tests.gpkg");
  (void)compare({"--store", store, "--store-level", "all"});
  EXPECT_THAT(run_command({"replay", store, "--test", "1"}).output, HasSubstr("precondition met"));
  EXPECT_THAT(run_command({"explain", store, "--test", "1", "--agent", "p1"}).output,
              HasSubstr("step_out.asl"));
}

TEST_F(WorldTutorial, HasTheSameResultsOnAnyThreads) {
  std::vector<std::string> tables;
  for (const std::string threads : {"1", "2", "8"}) {
    (void)compare({"--threads", threads, "--per-test", path(threads + ".csv"), "--metrics"});
    tables.push_back(text(threads + ".csv"));
  }
  EXPECT_NE(tables[0].find("step_out,3,29,"), std::string::npos) << tables[0];
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_EQ(tables[0], tables[2]);
}

}  // namespace
}  // namespace jaywalk
