// SPDX-License-Identifier: Apache-2.0
// Views of the motorway: by agents, by recordings (actors, scene, events), by the AV.

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/env_motorway/motorway.h"

namespace jaywalk::motorway {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr double kAhead = std::numbers::pi / 2;

class MotorwayViews : public MotorwayTest {};

TEST_F(MotorwayViews, TellDriversOfTheWorldTheyAreIn) {
  parameters_.lanes = 4;
  parameters_.length_m = 800;
  parameters_.tick_s = 0.25;
  parameters_.headway_s = 1.5;
  parameters_.drivers.greatest_speed_mps = 55;
  const Motorway motorway = with({vehicle(1, 0)});
  EXPECT_EQ(perceived(motorway, "lanes"), (Rows{{4}}));
  EXPECT_EQ(perceived(motorway, "road_length"), (Rows{{800}}));
  EXPECT_EQ(perceived(motorway, "tick_length"), (Rows{{0.25}}));
  EXPECT_EQ(perceived(motorway, "headway"), (Rows{{1.5}}));
  EXPECT_EQ(perceived(motorway, "greatest_speed"), (Rows{{55}}));
  EXPECT_EQ(perceived(motorway, "vehicle_length"), (Rows{{4.5}}));
}

TEST_F(MotorwayViews, HaveEveryPerceptOfTheTableInItsOrder) {
  Motorway motorway = with({vehicle(1, 250), vehicle(1, 252), vehicle(2, 120)});
  idle(motorway, 1);
  EXPECT_EQ(act(motorway, MotorwayAction::change_lane, {vocabulary_.left()}, 2), "");
  Percepts percepts;
  motorway.perceive(AgentId{2}, percepts);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < percepts.size(); ++i) {
    std::string name(symbols_.functor(percepts.predicate(i)));
    if (names.empty() || names.back() != name) names.push_back(std::move(name));
  }
  std::vector<std::string> expected;
  for (const EnvironmentWord& word : kMotorwayPercepts) {
    const std::string_view form = word.form;
    expected.emplace_back(form.substr(0, form.find('(')));
  }
  EXPECT_EQ(names, expected);
}

TEST_F(MotorwayViews, EndWhereTheDriversSightDoes) {
  parameters_.drivers.sight_m = 50;
  const Motorway motorway = with(
      {vehicle(1, 200), vehicle(1, 250), vehicle(1, 150), vehicle(3, 250.01), vehicle(3, 149.99)});
  EXPECT_EQ(perceived(motorway, "vehicle"), (Rows{{2, 1, 50, 30}, {3, 1, -50, 30}}));
  EXPECT_EQ(perceived(motorway, "av"), (Rows{{2, -100, 30}})) << "the AV is always known";
}

TEST_F(MotorwayViews, HideCrashesOutOfSightButTheOwn) {
  parameters_.drivers.sight_m = 50;
  Motorway motorway = with({vehicle(3, 300), vehicle(3, 302), vehicle(1, 100)});
  idle(motorway, 1);
  EXPECT_THAT(perceived(motorway, "crashed", 0), SizeIs(2));
  EXPECT_EQ(perceived(motorway, "crashed", 2), Rows{});
}

TEST_F(MotorwayViews, CountTheLaneOfAVehicleBetweenTwoByItsMiddle) {
  // A change takes four ticks of half a second: in the second the middle is on the line.
  Motorway motorway = with({vehicle(2, 400)});
  EXPECT_EQ(act(motorway, MotorwayAction::change_lane, {vocabulary_.left()}), "");
  EXPECT_EQ(perceived(motorway, "lane"), (Rows{{2}}));
  EXPECT_EQ(perceived(motorway, "changing"), (Rows{{1}}));
  idle(motorway, 2);
  EXPECT_EQ(perceived(motorway, "lane"), (Rows{{1}}));
}

TEST_F(MotorwayViews, NameTheAvAndTheVehiclesOfAgentsInTheirOrder) {
  parameters_.av.length_m = 12;
  parameters_.av.width_m = 2.5;
  const Motorway motorway = with({vehicle(1, 0), vehicle(3, 0)});
  EXPECT_THAT(motorway.actors(), ElementsAre(Actor{"av", ActorKind::vehicle, 12, 2.5},
                                             Actor{"v1", ActorKind::vehicle, 4.5, 1.8},
                                             Actor{"v2", ActorKind::vehicle, 4.5, 1.8}));
}

TEST_F(MotorwayViews, ShowTheMiddleOfEachBoxNotItsFront) {
  parameters_.av.length_m = 12;
  const Motorway motorway = with({vehicle(1, 80, 25)});
  EXPECT_THAT(motorway.scene(),
              ElementsAre(ActorState{5.25, 94, 30, kAhead}, ActorState{1.75, 77.75, 25, kAhead}));
}

TEST_F(MotorwayViews, ShowWhoChangesLanesTurnedThatWay) {
  // 3.5 m in 2 s beside 30 m/s.
  const double turn = std::atan2(1.75, 30);
  Motorway right = with({vehicle(1, 300)});
  act(right, MotorwayAction::change_lane, {vocabulary_.right()});
  EXPECT_NEAR(right.scene()[1].heading_rad, kAhead - turn, 1e-9) << "x grows to the right";
  Motorway left = with({vehicle(3, 300)});
  act(left, MotorwayAction::change_lane, {vocabulary_.left()});
  EXPECT_NEAR(left.scene()[1].heading_rad, kAhead + turn, 1e-9);
  idle(left, 4);
  EXPECT_DOUBLE_EQ(left.scene()[1].heading_rad, kAhead) << "once it is there";
}

TEST_F(MotorwayViews, ShowNoTurnOfWhoStandsWithinAChange) {
  Motorway motorway = with({vehicle(1, 400, 0)});
  EXPECT_EQ(act(motorway, MotorwayAction::change_lane, {vocabulary_.right()}), "");
  EXPECT_TRUE(motorway.vehicles()[0].changing);
  EXPECT_DOUBLE_EQ(motorway.scene()[1].heading_rad, kAhead);
  idle(motorway, 10);
  EXPECT_DOUBLE_EQ(motorway.vehicles()[0].x_m, 1.75) << "who stands gets nowhere";
}

TEST_F(MotorwayViews, TellEventsInTheOrderOfTime) {
  Motorway motorway = with({vehicle(1, 300), vehicle(3, 300), vehicle(3, 290, 45)});
  idle(motorway, 3);
  act(motorway, MotorwayAction::change_lane, {vocabulary_.right()});
  int last = 0;
  for (const WorldEvent& event : motorway.events()) {
    EXPECT_GE(event.tick, last);
    last = event.tick;
  }
  ASSERT_THAT(motorway.events(), SizeIs(3)) << "two crash, one changes lanes";
  EXPECT_EQ(motorway.events().back().kind, "lane_change");
  EXPECT_EQ(motorway.events().back().tick, 4) << "that in which it begins";
}

TEST_F(MotorwayViews, HideFromTheAvWhatIsBeyondItsRange) {
  // Somebody stands in the AV's lane: who sees 200 m brakes in the first tick, who sees 40 m not.
  parameters_.av.vehicle.model = "idm";
  const auto speed_after = [this](double range_m) {
    parameters_.av.vehicle.range_m = range_m;
    Motorway motorway = with({vehicle(2, 200, 0)});
    motorway.begin({});
    idle(motorway, 1);
    return motorway.av_speed_mps();
  };
  EXPECT_LT(speed_after(200), 29.5);
  EXPECT_DOUBLE_EQ(speed_after(40), 30);
}

TEST_F(MotorwayViews, LetTheAvIgnoreWhoKeepsToOtherLanes) {
  parameters_.av.vehicle.model = "idm";
  Motorway motorway = with({vehicle(1, 130, 0), vehicle(3, 130, 0)});
  motorway.begin({});
  idle(motorway, 4);
  EXPECT_DOUBLE_EQ(motorway.av_speed_mps(), 30);
}

}  // namespace
}  // namespace jaywalk::motorway
