// SPDX-License-Identifier: Apache-2.0
// Messages to a custom simulator, and files in memory for simulators that read files.

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "env/process/numbered_process.h"
#include "env/simulator/process/simulator_messages.h"
#include "env/simulator/sumo/sumo_process.h"
#include "tests/unit/env/sumo_street.h"

namespace jaywalk {
namespace {

using nlohmann::json;

json of(const char* text) { return json::parse(text); }

/// A test on a street with an AV, a pedestrian beside it and a light.
class Messages : public testing::Test {
 protected:
  [[nodiscard]] json reset(int steps = 10) const {
    const SimulatedTest test{.test = 3,
                             .seed = 42,
                             .behaviour = "proximity",
                             .agents = 1,
                             .tick_s = 0.5,
                             .road = road_,
                             .av = {"av", ActorKind::vehicle, 4.5, 1.8},
                             .av_start = {6, -2.25, 9, 1.5707963267948966},
                             .cruise_mps = 9,
                             .vehicle = vehicle_,
                             .actors = actors_,
                             .starts = starts_};
    return reset_message(test, parameters_, steps);
  }

  SimulatedRoad road_ = street();
  VehicleParameters vehicle_;
  SimulatorParameters parameters_;
  std::vector<Actor> actors_{{"p1", ActorKind::pedestrian, 0.5, 0.5},
                             {"light", ActorKind::signal, 0, 0}};
  std::vector<ActorState> starts_{{1.5, 30, 0, 0}, {}};
};

TEST_F(Messages, BeginATestWithWhatItIs) {
  const json message = reset();
  EXPECT_EQ(message["type"], "reset");
  EXPECT_EQ(message["seed"], 42);
  EXPECT_EQ(message["behaviour"], "proximity");
  EXPECT_EQ(message["agents"], 1);
  EXPECT_EQ(message["tick"], 0.5);
  EXPECT_EQ(message["dt"], 0.05);
}

TEST_F(Messages, DivideTheTickIntoSteps) {
  EXPECT_EQ(reset(1)["dt"], 0.5);
  EXPECT_EQ(reset(3)["dt"], 0.166666667) << "without the noise of arithmetic";
}

TEST_F(Messages, DescribeTheAv) {
  const json av = reset()["av"];
  EXPECT_EQ(av["name"], "av");
  EXPECT_EQ(av["kind"], "vehicle");
  EXPECT_EQ(av["length"], 4.5);
  EXPECT_EQ(av["width"], 1.8);
  EXPECT_EQ(av["x"], 6.0);
  EXPECT_EQ(av["y"], -2.25);
  EXPECT_EQ(av["speed"], 9.0);
  EXPECT_EQ(av["cruise"], 9.0);
}

TEST_F(Messages, SayOnlyTheLimitsThatAreGiven) {
  EXPECT_FALSE(reset()["av"].contains("deceleration"));
  EXPECT_FALSE(reset()["av"].contains("reaction"));
  vehicle_.deceleration_mps2 = 7;
  vehicle_.reaction_s = 0.4;
  vehicle_.range_m = 80;
  EXPECT_EQ(reset()["av"]["deceleration"], 7.0);
  EXPECT_EQ(reset()["av"]["reaction"], 0.4);
  EXPECT_EQ(reset()["av"]["range"], 80.0);
}

TEST_F(Messages, DescribeActorsWhereTheyStand) {
  const json actors = reset()["actors"];
  ASSERT_EQ(actors.size(), 2U);
  EXPECT_EQ(actors[0], of(R"({"name": "p1", "kind": "pedestrian", "length": 0.5, "width": 0.5,
                              "x": 1.5, "y": 30.0, "heading": 0.0, "speed": 0.0})"));
  EXPECT_EQ(actors[1]["kind"], "signal");
}

TEST_F(Messages, DescribeTheRoadsBands) {
  const json road = reset()["road"];
  EXPECT_EQ(road["length"], 99.0);
  ASSERT_EQ(road["bands"].size(), 4U);
  EXPECT_EQ(road["bands"][0],
            of(R"({"kind": "pavement", "across": [0.0, 3.0], "oncoming": false})"));
  EXPECT_EQ(road["bands"][2], of(R"({"kind": "lane", "across": [9.0, 15.0], "oncoming": true})"));
}

TEST_F(Messages, DescribeWhatIsOnTheRoad) {
  road_.ground.areas = {{AreaKind::lane, {{3, 0}, {9, 0}, {9, 99}, {3, 99}}, true}};
  road_.ground.obstacles = {{1, 2, 40, 45}};
  road_.ground.crosswalks = {{false, {{3, 15, 30, 34.5}}, 30, {"light"}}};
  const json road = reset()["road"];
  EXPECT_EQ(road["areas"][0], of(R"({"kind": "lane", "av_lane": true,
                              "corners": [[3.0, 0.0], [9.0, 0.0], [9.0, 99.0], [3.0, 99.0]]})"));
  EXPECT_EQ(road["obstacles"][0], of(R"({"across": [1.0, 2.0], "along": [40.0, 45.0]})"));
  EXPECT_EQ(road["crosswalks"][0], of(R"({"kind": "signalled", "begins": 30.0, "signals": ["light"],
                   "parts": [{"across": [3.0, 15.0], "along": [30.0, 34.5]}]})"));
  road_.ground.crosswalks[0].zebra = true;
  EXPECT_EQ(reset()["road"]["crosswalks"][0]["kind"], "zebra");
}

TEST_F(Messages, HandOnTheScenariosOptions) {
  EXPECT_EQ(reset()["options"], json::object());
  parameters_.settings["options"].maps = {{{"tau", "1.5"}, {"style", "calm"}}};
  EXPECT_EQ(reset()["options"], of(R"({"tau": "1.5", "style": "calm"})"));
}

TEST_F(Messages, OfAStepHaveBodiesWhereTheyAreByThen) {
  const std::vector<SimulatedBody> bodies{
      {.actor = 0, .before = {1, 30, 1, 0}, .after = {2, 30, 1, 0}}};
  const std::vector<ShownSignal> signals{{.crosswalk = 0, .colour = "amber"}};
  const json message = step_message({.bodies = bodies, .signals = signals}, 0.25, 0.1);
  EXPECT_EQ(message["type"], "step");
  EXPECT_EQ(message["dt"], 0.1);
  EXPECT_EQ(message["actors"], of(R"([{"x": 1.25, "y": 30.0, "heading": 0.0, "speed": 1.0}])"));
  EXPECT_EQ(message["signals"], of(R"([{"crosswalk": 0, "colour": "amber"}])"));
}

TEST(Tidy, RoundsToNineDigits) {
  EXPECT_EQ(tidy(0.1 + 0.2), 0.3);
  EXPECT_EQ(tidy(1.0 / 3), 0.333333333);
  EXPECT_EQ(tidy(-2.5), -2.5);
}

TEST(Tidy, HasNoMinusZero) {
  EXPECT_FALSE(std::signbit(tidy(-0.0)));
  EXPECT_FALSE(std::signbit(tidy(-1e-12)));
}

TEST(Tidy, ChangesNothingASecondTime) {
  for (double value = -3; value < 3; value += 0.01234567) EXPECT_EQ(tidy(tidy(value)), tidy(value));
}

TEST(MemoryFile, HoldsWhatWasWrittenLast) {
  MemoryFile file;
  ASSERT_TRUE(file.is_open());
  EXPECT_EQ(file.read(100), "");
  EXPECT_TRUE(file.write("a long text"));
  EXPECT_TRUE(file.write("short"));
  EXPECT_EQ(file.read(100), "short");
}

TEST(MemoryFile, GivesItsLastBytes) {
  MemoryFile file;
  EXPECT_TRUE(file.write("0123456789"));
  EXPECT_EQ(file.read(4), "6789");
  EXPECT_EQ(file.read(0), "");
}

TEST(MemoryFile, IsOpenedByItsPath) {
  MemoryFile file;
  EXPECT_TRUE(file.write("seen by others"));
  std::ostringstream text;
  text << std::ifstream(file.path()).rdbuf();
  EXPECT_EQ(text.str(), "seen by others");
  MemoryFile other;
  EXPECT_NE(other.path(), file.path());
}

}  // namespace
}  // namespace jaywalk
