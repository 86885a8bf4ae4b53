// SPDX-License-Identifier: Apache-2.0
// A simulator's valid answers, and the errors about invalid ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/process/message_reader.h"
#include "env/simulator/process/simulator_messages.h"

namespace jaywalk {
namespace {

using nlohmann::json;
using testing::ElementsAre;

json text_json(const std::string& text) { return json::parse(text); }

/// A scene of the AV alone at a time.
json scene_at(double time_s) {
  return {{"time", time_s}, {"av", {{"x", 1}, {"y", 2}, {"speed", 9}, {"heading", 1.5}}}};
}

std::string scene_problem(const json& answer,
                          const SimulatedCast& cast = {.actors = 2, .traffic = {}}) {
  SimulatedScene scene;
  return read_scene(answer, cast, 0.5, scene);
}

TEST(Hello, NamesTheSimulator) {
  SimulatorIdentity identity;
  EXPECT_EQ(read_hello(text_json(R"({"protocol": 1, "name": "toy", "version": "2",
                                     "network": "town", "deterministic": true})"),
                       identity),
            "");
  EXPECT_EQ(identity.name, "toy");
  EXPECT_EQ(identity.version, "2");
  EXPECT_EQ(identity.network, "town");
  EXPECT_TRUE(identity.deterministic);
}

TEST(Hello, MayLeaveOutWhatItDoesNotKnow) {
  SimulatorIdentity identity;
  EXPECT_EQ(read_hello(text_json(R"({"protocol": 1, "name": "toy", "version": "2"})"), identity),
            "");
  EXPECT_EQ(identity.network, "");
  EXPECT_FALSE(identity.deterministic) << "nobody is taken for deterministic who does not say so";
}

TEST(Hello, IsRefusedInAnotherVersionOrWithoutAName) {
  SimulatorIdentity identity;
  EXPECT_EQ(read_hello(text_json(R"({"protocol": 2, "name": "toy"})"), identity),
            "it speaks version 2 of the protocol, this is version 1");
  EXPECT_EQ(read_hello(text_json(R"({"protocol": 1, "version": "2"})"), identity),
            "there is no 'name' in its hello");
  EXPECT_EQ(read_hello(text_json(R"({"protocol": "1"})"), identity),
            "'protocol' in its hello is not a number");
  EXPECT_EQ(read_hello(text_json("[]"), identity), "there is no 'protocol' in its hello");
}

TEST(Echo, IsOfTheTestThatWasAskedFor) {
  EXPECT_EQ(check_echo({{"step", 3}, {"test", 7}}, 7), "");
  EXPECT_EQ(check_echo({{"step", 3}, {"test", 8}}, 7), "it answers for test 8, expected 7");
  EXPECT_EQ(check_echo({{"step", 3}}, 7), "there is no 'test' in its answer");
}

TEST(Scene, HasTheAvWhereItIs) {
  SimulatedScene scene;
  EXPECT_EQ(read_scene(scene_at(0.5), {.actors = 2, .traffic = {}}, 0.5, scene), "");
  EXPECT_TRUE(scene.av.present);
  EXPECT_EQ(scene.av.state.x_m, 1);
  EXPECT_EQ(scene.av.state.y_m, 2);
  EXPECT_EQ(scene.av.state.speed_mps, 9);
  EXPECT_EQ(scene.av.state.heading_rad, 1.5);
  EXPECT_EQ(scene.av.acceleration_mps2, 0);
  EXPECT_FALSE(scene.contacts) << "the simulator says nothing of them";
}

TEST(Scene, MayHaveAnAvThatIsNotThere) {
  SimulatedScene scene;
  EXPECT_EQ(read_scene(text_json(R"({"time": 0.5, "av": {"present": false}})"), {}, 0.5, scene),
            "");
  EXPECT_FALSE(scene.av.present);
}

TEST(Scene, IsOfTheTimeThatWasAskedFor) {
  EXPECT_EQ(scene_problem(scene_at(0.5 + 1e-9)), "");
  EXPECT_EQ(scene_problem(scene_at(0.6)), "its time is 0.6 s, expected 0.5 s");
}

TEST(Scene, SaysWhatIsMissingOrOfAnotherKind) {
  json answer = scene_at(0.5);
  answer["av"]["speed"] = "fast";
  EXPECT_EQ(scene_problem(answer), "'speed' in its AV is not a number");
  answer["av"].erase("speed");
  EXPECT_EQ(scene_problem(answer), "there is no 'speed' in its AV");
  answer["av"] = 3;
  EXPECT_EQ(scene_problem(answer), "'av' in its scene is not an object");
  answer.erase("av");
  EXPECT_EQ(scene_problem(answer), "there is no 'av' in its scene");
  EXPECT_EQ(scene_problem(json(3)), "there is no 'time' in its scene");
}

TEST(Scene, HasContactsWithActorsByTheirNumbers) {
  json answer = scene_at(0.5);
  answer["contacts"] = text_json("[1, 0]");
  SimulatedScene scene;
  EXPECT_EQ(read_scene(answer, {.actors = 2, .traffic = {}}, 0.5, scene), "");
  EXPECT_THAT(*scene.contacts, ElementsAre(1, 0));
  for (const json& odd : {json(2), json(-1), json("p1"), json(0.5)}) {
    answer["contacts"] = json::array({odd});
    EXPECT_EQ(scene_problem(answer), "the contact " + odd.dump() + " is the index of no actor");
  }
  answer["contacts"] = 1;
  EXPECT_EQ(scene_problem(answer), "'contacts' in its scene is not a list");
}

TEST(Scene, HasAStateForEachVehicleOfItsTraffic) {
  const SimulatedCast cast{.actors = 1, .traffic = {"a", "b"}};
  json answer = scene_at(0.5);
  answer["traffic"] = text_json(R"([{"name": "a", "x": 1, "y": 1, "speed": 1, "heading": 0},
                                    {"present": false}])");
  SimulatedScene scene;
  EXPECT_EQ(read_scene(answer, cast, 0.5, scene), "");
  EXPECT_TRUE(scene.traffic[0].present);
  EXPECT_FALSE(scene.traffic[1].present);
  answer["contacts"] = text_json("[2]");
  EXPECT_EQ(scene_problem(answer, cast), "") << "traffic is counted after the actors";
  answer["traffic"].erase(1);
  EXPECT_EQ(scene_problem(answer, cast), "there are 1 states for the 2 vehicles of its traffic");
  answer.erase("traffic");
  EXPECT_EQ(scene_problem(answer, cast), "there is no 'traffic' in its scene");
}

TEST(Scene, KeepsTheOrderOfItsTraffic) {
  const SimulatedCast cast{.actors = 1, .traffic = {"a", "b"}};
  json answer = scene_at(0.5);
  answer["traffic"] = text_json(R"([{"name": "b", "present": false},
                                    {"name": "a", "present": false}])");
  EXPECT_EQ(scene_problem(answer, cast), "the traffic's vehicle 0 is not 'a' any more");
}

TEST(Start, BringsTrafficWithItsSizes) {
  json answer = scene_at(0);
  answer["traffic"] = text_json(R"([{"name": "bike", "kind": "cyclist", "length": 1.8, "width": 0.6,
                                     "x": 1, "y": 2, "speed": 3, "heading": 0}])");
  SimulatedCast cast{.actors = 1, .traffic = {}};
  SimulatedStart start;
  EXPECT_EQ(read_start(answer, cast, start), "");
  EXPECT_THAT(cast.traffic, ElementsAre("bike"));
  EXPECT_EQ(start.traffic.at(0).kind, ActorKind::cyclist);
  EXPECT_EQ(start.traffic.at(0).length_m, 1.8);
  EXPECT_EQ(start.scene.traffic.at(0).state.speed_mps, 3);
}

TEST(Start, RefusesTrafficOfNoKind) {
  json answer = scene_at(0);
  answer["traffic"] = text_json(R"([{"name": "x", "kind": "tram", "length": 1, "width": 1}])");
  SimulatedCast cast;
  SimulatedStart start;
  EXPECT_EQ(read_start(answer, cast, start),
            "'tram' is no kind of traffic; vehicle, cyclist and pedestrian are");
}

TEST(MessageReader, KeepsTheFirstThatIsWrong) {
  MessageReader reader;
  const json message = text_json(R"({"a": 1, "b": "x", "c": true})");
  EXPECT_EQ(reader.number(message, "a", "it"), 1);
  EXPECT_EQ(reader.text(message, "b", "it"), "x");
  EXPECT_TRUE(reader.flag_or(message, "c", "it", false));
  EXPECT_EQ(reader.problem(), "");
  EXPECT_EQ(reader.number(message, "b", "it"), 0);
  EXPECT_EQ(reader.text(message, "z", "it"), "");
  EXPECT_EQ(reader.problem(), "'b' in it is not a number");
}

TEST(MessageReader, HasValuesForWhatIsNotThere) {
  MessageReader reader;
  const json message = text_json(R"({"flag": 1})");
  EXPECT_EQ(reader.number_or(message, "a", "it", 7), 7);
  EXPECT_TRUE(reader.flag_or(message, "a", "it", true));
  EXPECT_EQ(reader.list(message, "a", "it", false), nullptr);
  EXPECT_EQ(reader.problem(), "");
  EXPECT_FALSE(reader.flag_or(message, "flag", "it", false));
  EXPECT_EQ(reader.problem(), "'flag' in it is not true or false");
}

}  // namespace
}  // namespace jaywalk
