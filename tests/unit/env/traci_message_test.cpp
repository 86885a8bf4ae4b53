// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/traci_message.h"

#include <array>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

// The bytes are written down from the public documentation, sumo.dlr.de/docs/TraCI.

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int each : values) text.push_back(static_cast<char>(each));
  return text;
}

/// 9.5 and 1.5, big-endian.
const std::string kNineAndAHalf = bytes({0x40, 0x23, 0, 0, 0, 0, 0, 0});
const std::string kOneAndAHalf = bytes({0x3f, 0xf8, 0, 0, 0, 0, 0, 0});

std::string ok(int command) { return bytes({7, command, 0, 0, 0, 0, 0}); }

TEST(TraciMessage, IsItsLengthAndItsCommands) {
  TraciMessage message;
  message.version();
  message.step();
  EXPECT_EQ(message.bytes(), bytes({0, 0, 0, 16, 2, 0x00, 10, 0x02, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(message.commands(),
            (std::vector<TraciCommand>{TraciCommand::version, TraciCommand::step}));
}

TEST(TraciMessage, SetsAValueOfAType) {
  TraciMessage message;
  message.set(TraciCommand::vehicle_set, TraciVariable::speed_mode, "av", traci_integer(-2));
  EXPECT_EQ(message.bytes(), bytes({0, 0, 0, 18, 14, 0xc4, 0xb3, 0, 0, 0, 2}) + "av" +
                                 bytes({0x09, 0xff, 0xff, 0xff, 0xfe}));
}

TEST(TraciMessage, MovesAPersonByACompound) {
  TraciMessage message;
  message.set(TraciCommand::person_set, TraciVariable::move_to_xy, "p",
              traci_compound({traci_text(""), traci_real(9.5), traci_real(1.5), traci_byte(6)}));
  EXPECT_EQ(message.bytes(), bytes({0, 0, 0, 42, 38, 0xce, 0xb4, 0, 0, 0, 1}) + "p" +
                                 bytes({0x0f, 0, 0, 0, 4, 0x0c, 0, 0, 0, 0, 0x0b}) + kNineAndAHalf +
                                 bytes({0x0b}) + kOneAndAHalf + bytes({0x08, 6}));
}

TEST(TraciMessage, CountsTheBytesOfALongCommandByFourMore) {
  TraciMessage message;
  const std::vector<std::string> options{std::string(300, 'x')};
  message.load(options);
  EXPECT_EQ(message.bytes().substr(0, 19),
            bytes({0, 0, 1, 0x3f, 0, 0, 0, 1, 0x3b, 0x01, 0x0e, 0, 0, 0, 1, 0, 0, 1, 0x2c}));
  EXPECT_EQ(message.bytes().size(), 0x13fU);
}

TEST(TraciMessage, SubscribesFromNowOnAndForEver) {
  TraciMessage message;
  message.subscribe(TraciCommand::vehicle_subscribe, "av", std::array{TraciVariable::speed});
  EXPECT_EQ(message.bytes(), bytes({0, 0,    0,    30, 26, 0xd4, 0xc1, 0xd0, 0, 0, 0, 0, 0,
                                    0, 0x41, 0xd0, 0,  0,  0,    0,    0,    0, 0, 0, 0, 2}) +
                                 "av" + bytes({1, 0x40}));
}

/// What SUMO answers to a step in which a vehicle has two subscribed variables.
std::string step_answer() {
  return ok(0xce) + ok(0x02) + bytes({0, 0, 0, 1}) + bytes({0, 0, 0, 0, 0x2b, 0xe4, 0, 0, 0, 2}) +
         "av" + bytes({2, 0x42, 0, 0x01}) + kNineAndAHalf + kOneAndAHalf + bytes({0x40, 0, 0x0b}) +
         kNineAndAHalf;
}
const std::vector<TraciCommand> kStep{TraciCommand::person_set, TraciCommand::step};

TEST(TraciAnswer, HasTheVariablesThatWereSubscribedTo) {
  const TraciAnswer answer = read_traci_answer(kStep, step_answer());
  ASSERT_EQ(answer.error, "");
  ASSERT_EQ(answer.objects.size(), 1U);
  const TraciObject& av = answer.objects.front();
  EXPECT_EQ(av.id, "av");
  const TraciValue* const place = av.find(TraciVariable::position, TraciType::position_2d);
  ASSERT_NE(place, nullptr);
  EXPECT_EQ(place->points.front(), (TraciPoint{9.5, 1.5}));
  EXPECT_EQ(av.find(TraciVariable::speed, TraciType::real)->number, 9.5);
  EXPECT_EQ(av.find(TraciVariable::speed, TraciType::integer), nullptr);
  EXPECT_EQ(av.find(TraciVariable::angle, TraciType::real), nullptr);
}

TEST(TraciAnswer, HasAllVehiclesAroundOne) {
  const std::string text = ok(0x84) + bytes({0, 0, 0, 0, 0x34, 0x94, 0, 0, 0, 2}) + "av" +
                           bytes({0xa4, 1, 0, 0, 0, 2}) + bytes({0, 0, 0, 2}) + "t1" +
                           bytes({0x40, 0, 0x0b}) + kNineAndAHalf + bytes({0, 0, 0, 2}) + "t2" +
                           bytes({0x40, 0, 0x0b}) + kOneAndAHalf;
  const TraciAnswer answer = read_traci_answer(std::array{TraciCommand::vehicle_context}, text);
  ASSERT_EQ(answer.error, "");
  ASSERT_EQ(answer.objects.size(), 2U);
  EXPECT_EQ(answer.objects[1].id, "t2");
  EXPECT_EQ(answer.objects[1].find(TraciVariable::speed, TraciType::real)->number, 1.5);
}

TEST(TraciAnswer, HasTheVersionAndWhatIsAskedFor) {
  const std::string text =
      ok(0x00) + bytes({14, 0x00, 0, 0, 0, 20, 0, 0, 0, 4}) + "SUMO" + ok(0xa5) +
      bytes({19, 0xb5, 0x00, 0, 0, 0, 0, 0x0e, 0, 0, 0, 1, 0, 0, 0, 3}) + "car";
  const TraciAnswer answer =
      read_traci_answer(std::array{TraciCommand::version, TraciCommand::vehicle_type_get}, text);
  ASSERT_EQ(answer.error, "");
  EXPECT_EQ(answer.version, "SUMO");
  EXPECT_EQ(answer.api, 20);
  EXPECT_EQ(answer.objects.front().find(TraciVariable::ids, TraciType::texts)->texts,
            std::vector<std::string>{"car"});
}

TEST(TraciAnswer, SaysWhichCommandWasRefusedInSumosWords) {
  const std::string text = bytes({15, 0xce, 0xff, 0, 0, 0, 8}) + "no such!" + ok(0x02);
  EXPECT_EQ(read_traci_answer(kStep, text).error, "it refused command 0xce: no such!");
}

TEST(TraciAnswer, MayHoldAnythingWithoutHarm) {
  const std::string right = step_answer();
  for (std::size_t size = 0; size < right.size(); ++size) {
    EXPECT_NE(read_traci_answer(kStep, right.substr(0, size)).error, "") << size;
  }
  EXPECT_EQ(read_traci_answer(kStep, right + "x").error,
            "its answer has 1 bytes more than commands");
  EXPECT_EQ(read_traci_answer(kStep, ok(0x7f) + right).error,
            "its answer to command 1 of a message is no TraCI");
}

TEST(TraciAnswer, IsReadOrRefusedWhateverItsBytes) {
  std::mt19937 random(17);
  const std::vector<std::vector<TraciCommand>> all{
      kStep,
      {TraciCommand::version, TraciCommand::lane_get},
      {TraciCommand::vehicle_subscribe, TraciCommand::vehicle_context, TraciCommand::step}};
  int refused = 0;
  constexpr int kAnswers = 20'000;
  for (int i = 0; i < kAnswers; ++i) {
    std::string text = step_answer();
    for (int changes = 1 + static_cast<int>(random() % 4); changes > 0; --changes) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    const TraciAnswer answer = read_traci_answer(all[random() % all.size()], text);
    if (!answer.error.empty()) ++refused;
  }
  EXPECT_GT(refused, kAnswers / 2);
  EXPECT_LT(refused, kAnswers);
}

TEST(TraciAnswer, HasALengthThatIsPossible) {
  EXPECT_EQ(traci_rest(bytes({0, 0, 0, 16})), 12);
  EXPECT_EQ(traci_rest(bytes({0, 0, 0, 3})), -1);
  EXPECT_EQ(traci_rest(bytes({0xff, 0xff, 0xff, 0xff})), -1);
}

}  // namespace
}  // namespace jaywalk
