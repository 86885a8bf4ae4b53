// SPDX-License-Identifier: Apache-2.0
// The paper's figures stand beside what they are of: the published world and parameters, and the
// programs of agents/crossing.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/compare/published/published.h"
#include "tests/scenario/scenarios.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_scenario::paper;
using testing_scenario::project_file;
using testing_scenario::scenario;

PublishedRows with(std::vector<std::string> sets, std::optional<std::string> preset = {}) {
  ScenarioOptions options;
  options.preset = std::move(preset);
  options.sets = std::move(sets);
  return published_rows(*paper(options));
}

const auto kAllFour = ElementsAre("random_action", "random_behaviour", "proximity", "election");

TEST(PublishedRows, AreThoseOfThePublishedPresets) {
  for (const char* preset : {"paper", "published", "as-published-program"}) {
    const PublishedRows rows = with({}, preset);
    EXPECT_THAT(rows.behaviours, kAllFour) << preset;
    EXPECT_EQ(rows.left_out, "") << preset;
  }
  for (const char* preset : {"draft", "published-literal"}) {
    const PublishedRows rows = with({}, preset);
    EXPECT_THAT(rows.behaviours, IsEmpty()) << preset;
    EXPECT_THAT(rows.left_out, HasSubstr("the world is not a published one")) << preset;
  }
}

// Somebody's own behaviours, too, are measured as the paper's are, but in the paper's world alone.
TEST(PublishedRows, KnowThePapersWorldWhateverTheBehaviours) {
  EXPECT_TRUE(with({}).world);
  EXPECT_TRUE(with({"behaviours.proximity.parameters.radius=40"}).world);
  EXPECT_FALSE(with({"world.av.speed=3"}).world);
  const PublishedRows others =
      published_rows(*paper({.behaviours = {project_file("agents/crossing/repeat.asl")}}));
  EXPECT_TRUE(others.world);
  EXPECT_THAT(others.behaviours, IsEmpty());
}

TEST(PublishedRows, KnowWhetherTheProgramsQuirksAreRepeated) {
  EXPECT_EQ(with({}).quirks, PublishedQuirks::left_out);
  EXPECT_EQ(with({}, "as-published-program").quirks, PublishedQuirks::repeated);
}

TEST(PublishedRows, AreLeftOutOfOtherWorlds) {
  for (const char* set :
       {"world.av.speed=3", "world.spawn.choose=cell", "world.scoring.reward=20",
        "world.zone.rows=av", "world.pedestrians.speed=2", "world.av.carry_over=true",
        "world.av.model=braking", "world.length=70", "experiment.feedback=100"}) {
    const PublishedRows rows = with({set});
    EXPECT_THAT(rows.left_out, testing::Not(IsEmpty())) << set;
    EXPECT_NE(rows.behaviours.size(), 4U) << set;
  }
  EXPECT_THAT(with({"world.av.speed=6", "world.scoring.reward=100"}).behaviours, kAllFour)
      << "what is said again is the same";
  EXPECT_THAT(with({"experiment.tests=10", "experiment.seed=7"}).behaviours, kAllFour);
}

TEST(PublishedRows, AreLeftOutOfOtherParameters) {
  PublishedRows rows = with({"behaviours.proximity.parameters.radius=40"});
  EXPECT_THAT(rows.behaviours, ElementsAre("random_action", "random_behaviour", "election"));
  EXPECT_EQ(rows.left_out, "proximity has other parameters");
  EXPECT_THAT(with({"behaviours.proximity.parameters.radius=15"}).behaviours, kAllFour);
  EXPECT_THAT(with({"behaviours.random_behaviour.parameters.crossing_probability=1/11"}).behaviours,
              kAllFour);
  rows = with({"behaviours.random_behaviour.parameters.first_way=back",
               "behaviours.election.agents={1: {radius: 20}}"});
  EXPECT_THAT(rows.behaviours, ElementsAre("random_action", "proximity"));
  EXPECT_EQ(rows.left_out, "random_behaviour has other parameters, election has other parameters");
  rows = with({"behaviours.random_behaviour.parameters.first_way=either"}, "as-published-program");
  EXPECT_EQ(rows.left_out, "random_behaviour has other parameters");
}

// Names are the user's: what the program says counts.
TEST(PublishedRows, AreLeftOutOfOtherPrograms) {
  const std::string program = project_file("agents/crossing/intersect.asl");
  const PublishedRows rows = with({"behaviours.proximity.program=" + program});
  EXPECT_THAT(rows.behaviours, ElementsAre("random_action", "random_behaviour", "election"));
  EXPECT_EQ(rows.left_out, "proximity runs another program");
  const PublishedRows team =
      with({"behaviours.proximity.team={2: " + project_file("agents/crossing/election.asl") + "}"});
  EXPECT_EQ(team.left_out, "proximity runs another program");
}

TEST(PublishedRows, AreLeftOutWhenSharedProgramsWereChanged) {
  namespace fs = std::filesystem;
  const fs::path copy = fs::path(testing::TempDir()) / "published_rows";
  fs::remove_all(copy);
  fs::create_directories(copy / "scenarios");
  fs::copy(project_file("agents"), copy / "agents", fs::copy_options::recursive);
  fs::copy(project_file("scenarios/paper.yaml"), copy / "scenarios");
  const auto rows = [&] {
    auto read = read_scenario((copy / "scenarios/paper.yaml").string());
    Diagnostics warnings;
    return published_rows(*PreparedScenario::prepare(std::move(read).value(), warnings).value());
  };
  EXPECT_THAT(rows().behaviours, kAllFour) << "a copy is the same";
  std::ofstream(copy / "agents/crossing/shared/nearness.asl", std::ios::app) << "\nfar(99).\n";
  EXPECT_THAT(rows().behaviours, ElementsAre("random_action", "random_behaviour"));
  EXPECT_EQ(rows().left_out, "proximity runs another program, election runs another program");
  fs::remove_all(copy);
}

// The scenarios beyond the paper have worlds of their own.
TEST(PublishedRows, AreLeftOutOfScenariosBeyondThePaper) {
  for (const char* name : {"braking", "traffic", "zebra"}) {
    EXPECT_THAT(published_rows(*scenario(name)).behaviours, IsEmpty()) << name;
  }
}

TEST(PublishedRows, AreExplained) {
  const auto text = [](const PublishedRows& rows) {
    std::string all;
    for (const std::string& note : published_notes(rows)) all += note + '\n';
    return all;
  };
  for (const char* reason :
       {"begins with what the last test left", "against the AV's direction",
        "counts the radius itself", "four misprints", "--preset as-published-program"}) {
    EXPECT_THAT(text(with({})), HasSubstr(reason));
  }
  EXPECT_THAT(text(with({}, "as-published-program")), HasSubstr("repeats the quirks"));
  EXPECT_EQ(
      text(with({}, "draft")),
      "paper: published values are left out: the world is not a published one (presets paper, "
      "published, as-published-program).\n");
  EXPECT_EQ(text(published_rows(*paper({.behaviours = {"intersect"}}))), "")
      << "of which nothing was published";
}

}  // namespace
}  // namespace jaywalk
