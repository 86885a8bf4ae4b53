// SPDX-License-Identifier: Apache-2.0
// The crossing's side of a simulator: the messages to it, and the effect of its answers.

#include "env/simulator/simulator.h"

#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/crossing/crossing.h"
#include "env/crossing/simulated_drive.h"

namespace jaywalk {
namespace {

using ::testing::HasSubstr;

TEST(ABody, GoesEvenlyFromOnePlaceToTheNext) {
  const SimulatedBody body{.actor = 0, .before = {1, 2, 1.5, 0}, .after = {2.5, 2, 1.5, 0}};
  EXPECT_EQ(body_at(body, 0).x_m, 1);
  EXPECT_EQ(body_at(body, 0.5).x_m, 1.75);
  EXPECT_EQ(body_at(body, 1).x_m, 2.5);
  EXPECT_EQ(body_at(body, 0.5).speed_mps, 1.5);
}

TEST(ATick, HasStepsOfAboutTheWantedLength) {
  EXPECT_EQ(steps_of(1, 0.1), 10);
  EXPECT_EQ(steps_of(0.25, 0.1), 3);  // of 0.083 s
  EXPECT_EQ(steps_of(0.1, 0.1), 1);
  EXPECT_EQ(steps_of(0.1, 5), 1);
  EXPECT_EQ(steps_of(1, 0), 1);
}

TEST(EverySimulator, HasKeysOfItsOwn) {
  EXPECT_EQ(find_simulator("no such"), nullptr);
  for (const SimulatorKind& kind : simulator_kinds()) {
    EXPECT_EQ(find_simulator(kind.name), &kind);
    EXPECT_FALSE(kind.summary.empty());
    for (const SettingKey& key : kind.keys) {
      EXPECT_FALSE(key.name == "name" || key.name == "step") << kind.name;
      EXPECT_FALSE(key.meaning.empty()) << kind.name << "." << key.name;
      EXPECT_TRUE(key.kind != SettingKind::number || key.least < key.most) << key.name;
    }
  }
}

TEST(ASimulator, IsKeptForTheSameParameters) {
  SimulatorParameters one{.name = "process"};
  one.settings["command"].command = {"true"};
  SimulatorParameters other = one;
  other.step_s = 0.5;
  Simulators simulators;
  const Simulator* const first = &simulators.of(one);
  EXPECT_EQ(&simulators.of(one), first);
  // Its successor may lie where it was, so that the addresses of the two say nothing.
  const Simulator* const second = &simulators.of(other);
  EXPECT_EQ(&simulators.of(other), second);
}

/// A shell that answers with these lines, one for each question.
SimulatorParameters answering(const std::vector<std::string>& answers) {
  std::string script;
  for (const std::string& answer : answers) script += "read q; echo '" + answer + "'; ";
  SimulatorParameters parameters{.name = "process", .step_s = 10};
  parameters.settings["command"].command = {"sh", "-c", script + "read q"};
  parameters.settings["timeout"].number = 5;
  return parameters;
}

constexpr const char* kHello = R"({"step":0,"protocol":1,"name":"shell","version":"2"})";

/// The AV drives in the rows 3 and 4, x from 4.5 to 7.5 m, and begins with its front at y = 1.5 m.
class SimulatedCrossing : public ::testing::Test {
 protected:
  /// One pedestrian in the middle of row 3, `cell` cells ahead; it stays there.
  void begin(const std::vector<std::string>& answers, int cell = 20) {
    std::vector<std::string> all{kHello};
    all.insert(all.end(), answers.begin(), answers.end());
    parameters_.simulator = answering(all);
    parameters_.end = TestEnd::road;
    vocabulary_ = std::make_unique<CrossingVocabulary>(symbols_);
    crossing_ =
        std::make_unique<Crossing>(parameters_, *vocabulary_, std::vector<Position>{{3, cell}});
    crossing_->begin({.test = 4, .agents = 1, .simulators = &simulators_});
  }

  static std::string scene(int step, double time_s, double y_m, const std::string& more = {}) {
    return R"({"step":)" + std::to_string(step) + R"(,"test":4,"time":)" + std::to_string(time_s) +
           R"(,"av":{"x":6,"y":)" + std::to_string(y_m) +
           R"(,"heading":1.5707963267948966,"speed":9})" + more + "}";
  }

  CrossingParameters parameters_;
  SymbolTable symbols_;
  std::unique_ptr<CrossingVocabulary> vocabulary_;
  Simulators simulators_;
  std::unique_ptr<Crossing> crossing_;
};

TEST_F(SimulatedCrossing, HasTheAvWhereTheSimulatorHasIt) {
  begin({scene(0, 0, -0.75), scene(1, 1, 5.25)});
  EXPECT_EQ(crossing_->failure(), "");
  EXPECT_EQ(crossing_->av_cell(), 0);
  crossing_->advance();
  EXPECT_EQ(crossing_->failure(), "");
  EXPECT_EQ(crossing_->av_cell(), 4);  // 6 m further: 4 cells of 1.5 m
  EXPECT_NEAR(crossing_->scene()[0].y_m, 5.25, 1e-9);
  EXPECT_NEAR(crossing_->scene()[0].heading_rad, std::numbers::pi / 2, 1e-9);
}

TEST_F(SimulatedCrossing, FindsCollisionsOverTheWholeWayOfAStep) {
  // The pedestrian's box is from y = 30.5 to 31; within one step the AV drives over it.
  begin({scene(0, 0, -0.75), scene(1, 1, 27.9), scene(2, 2, 60)});
  crossing_->advance();
  EXPECT_TRUE(crossing_->result().collisions.empty());
  crossing_->advance();
  ASSERT_EQ(crossing_->result().collisions.size(), 1U);
  EXPECT_EQ(crossing_->result().collisions[0].tick, 2);
  EXPECT_EQ(crossing_->result().collisions[0].impact_mps, 9);
}

TEST_F(SimulatedCrossing, TakesTheSimulatorsContactsInPlaceOfItsOwn) {
  begin({scene(0, 0, -0.75), scene(1, 1, 60, R"(,"contacts":[])"),
         scene(2, 2, 61, R"(,"contacts":[0])")});
  crossing_->advance();
  EXPECT_TRUE(crossing_->result().collisions.empty());
  crossing_->advance();
  EXPECT_EQ(crossing_->result().collisions.size(), 1U);
}

TEST_F(SimulatedCrossing, HasTheSimulatorsTrafficAsBodiesWithoutAgents) {
  const std::string size = R"("kind":"vehicle","length":4,"width":2,"name":"bus",)";
  const std::string place = R"("x":12,"y":80.25,"heading":-1.5707963267948966,"speed":3})";
  begin({scene(0, 0, -0.75, R"(,"traffic":[{)" + size + place + "]"),
         scene(1, 1, 5, R"(,"traffic":[{)" + place + "]"),
         scene(2, 2, 6, R"(,"traffic":[{"present":false}])")});
  ASSERT_EQ(crossing_->failure(), "");
  ASSERT_EQ(crossing_->actors().size(), 3U);
  EXPECT_EQ(crossing_->actors()[2].name, "bus");
  EXPECT_EQ(crossing_->actors()[2].length_m, 4);
  crossing_->advance();
  ASSERT_EQ(crossing_->bodies().size(), 2U);
  const RoadUser& bus = crossing_->bodies()[1];
  EXPECT_EQ(bus.facing, Direction::back);
  EXPECT_EQ(bus.place.y, 53);
  EXPECT_EQ(bus.step_in(1), 2);  // 3 m in a second
  crossing_->advance();
  EXPECT_TRUE(crossing_->bodies()[1].absent);
  // Out of sight.
  EXPECT_LT(crossing_->scene()[2].x_m, -100);
  EXPECT_EQ(crossing_->scene()[2].speed_mps, 0);
}

TEST_F(SimulatedCrossing, RefusesTrafficWithTheNameOfAnActor) {
  begin({scene(0, 0, -0.75,
               R"(,"traffic":[{"kind":"vehicle","length":4,"width":2,"name":"p1","x":0,"y":0,)"
               R"("heading":0,"speed":0}])")});
  EXPECT_THAT(crossing_->failure(), HasSubstr("a second actor 'p1'"));
}

TEST_F(SimulatedCrossing, RefusesTrafficWhoseNameIsAFormula) {
  begin({scene(0, 0, -0.75,
               R"(,"traffic":[{"kind":"vehicle","length":4,"width":2,"name":"=1+1","x":0,"y":0,)"
               R"("heading":0,"speed":0}])")});
  EXPECT_THAT(crossing_->failure(), HasSubstr("'=1+1' cannot be the name of an actor"));
}

TEST_F(SimulatedCrossing, ToleratesSinglePrecision) {
  begin({scene(0, 0, -0.75), scene(1, 1, 8.2499999)});
  crossing_->advance();
  EXPECT_EQ(crossing_->av_cell(), 6);
}

TEST_F(SimulatedCrossing, EndsAtItsTimeLimitThoughTheAvStands) {
  EXPECT_EQ(max_ticks(parameters_), 0);
  parameters_.simulator.name = "process";
  EXPECT_GT(max_ticks(parameters_), 0);
}

}  // namespace
}  // namespace jaywalk
