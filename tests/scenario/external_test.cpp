// SPDX-License-Identifier: Apache-2.0
// External controllers: their views, the effect of their answers, how long they live.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/scenario/scenarios.h"

namespace jaywalk {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Answers every line but `end`, after writing it down.
constexpr const char* kScribe = R"(while read line; do
  echo "$line" >>"$0"
  case $line in *\"end\"*) ;; *) echo "{\"acceleration\": 0}";; esac
done)";

class ExternalController : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("jaywalk-external-" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    std::filesystem::permissions(file(name), std::filesystem::perms::owner_all);
  }

  /// The lines that a scribe has written down.
  [[nodiscard]] std::vector<json> lines(const std::string& name) const {
    std::vector<json> lines;
    std::ifstream in(file(name));
    for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
    return lines;
  }

  [[nodiscard]] std::shared_ptr<const PreparedScenario> driven_by(
      const std::vector<std::string>& command, const std::string& process) const {
    return testing_scenario::scenario(
        "external", {"world.av.process=" + process, "world.av.command=" + json(command).dump(),
                     "world.time_limit=5"});
  }

  std::filesystem::path folder_;
};

TEST_F(ExternalController, ThatIsKeptDrivesInManyTestsWithOneProcess) {
  const std::string script = "echo $$ >>" + file("pids") + "\n" + kScribe;
  const auto prepared = driven_by({"sh", "-c", script, file("said")}, "kept");
  TestRunner runner(*prepared);
  for (std::uint64_t test = 0; test < 4; ++test) {
    ASSERT_EQ(runner.run({.agents = 1, .seed = 5, .test = test}).message, "");
  }
  std::ifstream pids(file("pids"));
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(pids), {}, '\n'), 1);
}

TEST_F(ExternalController, ThatIsKeptIsToldWhenTestsBeginAndEnd) {
  const auto prepared = driven_by({"sh", "-c", kScribe, file("said")}, "kept");
  {
    TestRunner runner(*prepared);
    for (const std::uint64_t test : {7U, 8U}) {
      ASSERT_EQ(runner.run({.agents = 1, .seed = 5, .test = test}).message, "");
    }
  }  // the process has read everything when it is gone
  std::vector<json> begins;
  std::vector<json> ends;
  for (const json& line : lines("said")) {
    if (line.contains("reset")) begins.push_back(line);
    if (line.contains("end")) ends.push_back(line);
  }
  ASSERT_EQ(begins.size(), 2U);
  EXPECT_EQ(begins[0]["step"], 0);
  EXPECT_EQ(begins[1]["reset"]["test"], 8);
  EXPECT_EQ(begins[1]["reset"]["seed"], 5);
  EXPECT_EQ(begins[1]["reset"]["behaviour"], "proximity");
  EXPECT_EQ(begins[1]["reset"]["agents"], 1);
  EXPECT_EQ(begins[1]["reset"]["road"], 99);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0]["end"]["why"], "time_limit");
}

TEST_F(ExternalController, DrivesAlikeKeptAndStartedAnew) {
  const auto drive = [](const std::string& process) {
    const auto prepared = testing_scenario::scenario("external", {"world.av.process=" + process});
    TestRunner runner(*prepared);
    std::vector<Recording> recordings(4);
    for (std::uint64_t test = 0; test < recordings.size(); ++test) {
      (void)runner.run({.agents = 3, .test = test}, {.record = &recordings[test]});
    }
    return recordings;
  };
  EXPECT_TRUE(drive("kept") == drive("test"));
}

TEST_F(ExternalController, ThatIsKeptGetsOnlyTheFieldsThatItReads) {
  const std::string reads = R"(while read line; do
    echo "$line" >>"$0"
    case $line in
      *\"end\"*) ;;
      *reset*) echo "{\"reads\": [\"speed\", \"actors.gap\"]}";;
      *) echo "{\"acceleration\": 0}";;
    esac
  done)";
  const auto prepared = driven_by({"sh", "-c", reads, file("said")}, "kept");
  {
    TestRunner runner(*prepared);
    ASSERT_EQ(runner.run({.agents = 1}).message, "");
  }
  const json view = lines("said").at(3);
  EXPECT_EQ(view.size(), 3U) << view;
  EXPECT_EQ(view["step"], 3);
  EXPECT_EQ(view["speed"], 9);
  EXPECT_EQ(view.at("actors").at(0).size(), 1U);
}

TEST_F(ExternalController, IsToldOfAFieldThatThereIsNot) {
  const auto fails = [&](const std::string& reads) {
    const auto prepared =
        driven_by({"sh", "-c", "while read line; do echo '" + reads + "'; done"}, "kept");
    TestRunner runner(*prepared);
    return runner.run({.agents = 1}).message;
  };
  EXPECT_EQ(
      fails(R"({"reads": ["actors", "spede"]})"),
      "the controller 'sh': line 1 of its output, '{\"reads\": [\"actors\", \"spede\"]}': a view "
      "has no field 'spede'; did you mean 'speed'?");
  for (const char* odd : {R"({"reads": "actors"})", R"({"reads": []})", R"({"reads": [1]})"}) {
    EXPECT_THAT(fails(odd), HasSubstr("expected `reads` to be a list of fields of a view"));
  }
}

/// Test 2 with the healthy AV and with two defects: one that shows nothing, and one that does.
std::vector<TestRun> runs_with_defects(const PreparedScenario& prepared,
                                       std::vector<Recording>* recordings = nullptr) {
  TestRunner runner(prepared);
  std::vector<TestRun> runs;
  for (const std::size_t vehicle : {0U, 1U, 2U}) {
    Recording recording;
    runs.push_back(
        runner.run({.agents = 1, .test = 2, .vehicle = vehicle}, {.record = &recording}));
    if (recordings != nullptr) recordings->push_back(std::move(recording));
  }
  return runs;
}

constexpr const char* kTwoDefects = "experiment.defects=[fast-as-noise, latency=1]";

TEST_F(ExternalController, ThatIsKeptIsAskedAgainOnlyWhereADefectShows) {
  const auto prepared = testing_scenario::scenario(
      "external", {"world.time_limit=5", kTwoDefects,
                   "world.av.command=" + json{"sh", "-c", kScribe, file("said")}.dump()});
  for (const TestRun& run : runs_with_defects(*prepared)) EXPECT_EQ(run.message, "");
  std::vector<std::size_t> resets;
  const std::vector<json> said = lines("said");
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (said[i].contains("reset")) resets.push_back(i);
  }
  ASSERT_EQ(resets.size(), 2U) << "not for fast-as-noise, as nobody is fast";
  EXPECT_EQ(said[1], said[resets[1] + 1]) << "the other drive begins as the first did";
  EXPECT_EQ(said[resets[1] + 1]["step"], 1);
  EXPECT_TRUE(said[resets[1] - 1].contains("end"));
  EXPECT_TRUE(said.back().contains("end"));
}

TEST_F(ExternalController, DrivesAlikeWithDefectsKeptAndStartedAnew) {
  const auto drive = [](const std::string& process) {
    const auto prepared =
        testing_scenario::scenario("external", {"world.av.process=" + process, kTwoDefects});
    std::vector<Recording> recordings;
    for (const TestRun& run : runs_with_defects(*prepared, &recordings)) {
      EXPECT_EQ(run.message, "");
    }
    return recordings;
  };
  const std::vector<Recording> kept = drive("kept");
  EXPECT_TRUE(kept == drive("test"));
  EXPECT_TRUE(kept[0] == kept[1]);
  EXPECT_FALSE(kept[0] == kept[2]) << "or latency=1 was not seen to change anything";
}

TEST_F(ExternalController, ThatIsKeptHasToAnswerTheSameViewsAlike) {
  // The second drive begins with another answer than the first.
  const std::string moody = R"(while read line; do
    case $line in
      *\"end\"*) ;;
      *reset*) drives=$((drives + 1)); echo "{}";;
      *) echo "{\"acceleration\": $drives}";;
    esac
  done)";
  const auto prepared = testing_scenario::scenario(
      "external",
      {"world.time_limit=5", kTwoDefects, "world.av.command=" + json{"sh", "-c", moody}.dump()});
  const std::vector<TestRun> runs = runs_with_defects(*prepared);
  EXPECT_EQ(runs[0].message, "");
  EXPECT_EQ(runs[1].message, "");
  EXPECT_THAT(
      runs[2].message,
      HasSubstr("to view 1 since `reset` it answered 2, but 1 in a drive before with the same "
                "views; a process that is kept has to begin anew"));
}

TEST_F(ExternalController, SeesTheRoadItsOwnPlaceAndEverybodysWholeBox) {
  const auto prepared = testing_scenario::scenario(
      "external", {"world.av.process=test", "world.time_limit=5",
                   "world.obstacles=[{rows: [2, 2], cells: [30, 33]}]",
                   "world.av.command=" + json{"sh", "-c", kScribe, file("said")}.dump()});
  ASSERT_EQ(run_test(*prepared, {.agents = 1, .test = 3}).message, "");
  const json view = lines("said").at(4);
  EXPECT_EQ(view["step"], 4);
  EXPECT_EQ(view["test"], 3);
  EXPECT_EQ(view["length"], 4.5);
  EXPECT_EQ(view["range"], 100);
  EXPECT_NEAR(view["front"].get<double>(), 1.5 + 4 * 0.2 * 9, 1e-6);
  EXPECT_EQ(view["lanes"].size(), 2U);
  EXPECT_EQ(view["lanes"][1]["oncoming"], true);
  EXPECT_EQ(view["kerb"], (json{3, 15}));
  EXPECT_EQ(view["obstacles"].size(), 1U);
  const json actor = view["actors"].at(0);
  EXPECT_NEAR(actor["far"].get<double>() - actor["gap"].get<double>(), 0.5, 1e-6);
  for (const char* key : {"ahead", "right"}) {
    const double value = actor[key];
    EXPECT_TRUE(value == 0 || std::abs(value) > 1e-6) << key << " is " << value;
  }
}

TEST_F(ExternalController, CannotAskForMoreThanAVehicleCanDo) {
  const auto prepared = driven_by(
      {"sh", "-c", R"(while read line; do echo "{\"acceleration\": -1000}"; done)"}, "test");
  Recording recording;
  const TestRun result = run_test(*prepared, {.agents = 1}, {.record = &recording});
  const double lost_mps = recording.scene(0)[0].speed_mps - recording.scene(1)[0].speed_mps;
  EXPECT_NEAR(lost_mps, 9.80665 * 0.2, 1e-6);
  EXPECT_THAT(result.notes.front(), HasSubstr("asked for -1000 m/s2; a vehicle does -9.807 to 5"));
}

TEST_F(ExternalController, IsNamedByItsScriptWhenItFails) {
  write("driver.sh", "read line; exit 4\n");
  const auto prepared = driven_by({"sh", file("driver.sh")}, "test");
  EXPECT_THAT(run_test(*prepared, {.agents = 1}).message, HasSubstr("driver.sh'"));
}

TEST_F(ExternalController, IsFoundBesideItsScenarioFromEverywhere) {
  write("driver", "#!/bin/sh\nwhile read line; do echo '{\"acceleration\": 0}'; done\n");
  write("own.yaml",
        "world:\n  tick: 0.2\n  av: {model: external, command: [./driver], speed_mps: 9}\n"
        "  time_limit: 2\n  until: road_end\nbehaviours: [" +
            testing_scenario::project_file("agents/crossing/proximity.asl") + "]\n");
  Diagnostics warnings;
  for (const std::string& folder : {folder_.string(), std::string("/")}) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    const std::string path = folder == "/" ? file("own.yaml") : "own.yaml";
    const auto prepared = PreparedScenario::prepare(read_scenario(path).value(), warnings);
    EXPECT_EQ(run_test(*prepared.value(), {.agents = 1}).message, "") << folder;
    std::filesystem::current_path(before);
  }
}

TEST_F(ExternalController, HasNoUseForAModelsHabits) {
  const auto wrong = read_scenario(std::string(JAYWALK_SOURCE_DIR) + "/scenarios/external.yaml",
                                   {.sets = {"world.av.reaction=1", "world.av.deceleration=5"}});
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.diagnostics().render(), HasSubstr("'reaction' has no meaning"));
  EXPECT_THAT(wrong.diagnostics().render(), HasSubstr("'deceleration' has no meaning"));
}

}  // namespace
}  // namespace jaywalk
