// SPDX-License-Identifier: Apache-2.0
// The drive of the careful and competent driver in the AV's place.

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/vehicle/careful_driver.h"
#include "experiment/judge/signals/signals.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

/// A road on which the AV cruises, with a crosswalk that begins 80 m from its start.
Ground road_with_crosswalk(bool zebra) {
  Ground ground = road();
  ground.cruise_mps = 10;
  ground.crosswalks = {
      {.zebra = zebra, .parts = {{-3, 9, 80, 84}}, .begins_m = 80, .signals = {"light"}}};
  return ground;
}

/// The AV drives on whatever happens; a pedestrian stands somewhere, and there is a signal.
Recording drive_on_with_light(Place pedestrian, std::size_t ticks = 10) {
  Recording recording(1, {{"av", ActorKind::vehicle, 4, 2},
                          {"p1", ActorKind::pedestrian, 0.5, 0.5},
                          {"light", ActorKind::signal, 0.1, 0.1}});
  for (std::size_t i = 0; i < ticks; ++i) {
    recording.add(Scene{{0, 10.0 * static_cast<double>(i), 10, std::numbers::pi / 2},
                        {pedestrian.x, pedestrian.y, 0, 0},
                        {-4, 80, 0, 0}});
  }
  return recording;
}

void change_light(Recording& recording, std::uint32_t tick, const std::string& colour) {
  recording.add(RecordedEvent{.tick = tick, .actor = 2, .kind = "signal", .text = colour});
}

double slowest_mps(const std::vector<ActorState>& states) {
  return std::ranges::min(states, {}, &ActorState::speed_mps).speed_mps;
}

TEST(CarefulDrive, IsTheAvsOwnWhereNobodyIsARisk) {
  const Ground ground = road();
  const Recording recording = drive(1, {steps({0, 0}, {0, 9}, 5), steps({-8, 20}, {0, 0}, 5)});
  const TestView view(recording, ground);
  const auto states = careful_drive(view);
  ASSERT_EQ(states.size(), 5U);
  for (std::size_t tick = 0; tick < 5; ++tick)
    EXPECT_EQ(states[tick], view.state(kAv, tick)) << tick;
}

TEST(CarefulDrive, FollowsTheAvsWayAtItsOwnSpeed) {
  // The AV drives 5 m/s where a free road is driven at 10 m/s, and moves over to the right.
  Ground ground = road();
  ground.cruise_mps = 10;
  const Recording recording = drive(1, {{{0, 0}, {0, 5}, {1, 5}, {1, 10}, {1, 15}}});
  const TestView view(recording, ground);
  const auto states = careful_drive(view);
  // From 5 to 7 m/s in the first second: 5 m ahead, then the metre to the right.
  EXPECT_NEAR(states[1].x_m, 1, 1e-9);
  EXPECT_NEAR(states[1].y_m, 5, 1e-9);
  EXPECT_NEAR(states[2].y_m, 13, 1e-9) << "8 m more";
  EXPECT_GT(states[2].speed_mps, 8.9);
}

TEST(CarefulDrive, GoesStraightOnAfterTheRecordsEnd) {
  Ground ground = road();
  ground.cruise_mps = 10;
  const Recording recording = drive(1, {steps({0, 0}, {0, 10}, 3), steps({0, 40}, {0, 0}, 3)});
  const auto states = careful_drive(TestView(recording, ground));
  EXPECT_GT(states.size(), 3U);
  EXPECT_EQ(states.back().speed_mps, 0);
  EXPECT_NEAR(states.back().x_m, 0, 1e-9);
  // 1.15 s at 10 m/s and the braking of 9.47 m.
  EXPECT_NEAR(states.back().y_m, 20.97, 0.05);
}

TEST(CarefulDrive, BrakesForARedSignal) {
  const Ground ground = road_with_crosswalk(false);
  Recording recording = drive_on_with_light({-8, 0});
  change_light(recording, 0, "red");
  EXPECT_LT(slowest_mps(careful_drive(TestView(recording, ground))), 2);
}

TEST(CarefulDrive, DrivesOnAtAGreenSignal) {
  const Ground ground = road_with_crosswalk(false);
  Recording recording = drive_on_with_light({-8, 0});
  change_light(recording, 0, "green");
  const TestView view(recording, ground);
  EXPECT_DOUBLE_EQ(careful_drive(view).back().speed_mps, 10);
}

TEST(CarefulDrive, DrivesOnWhereASignalHasSaidNothing) {
  const Ground ground = road_with_crosswalk(false);
  const Recording recording = drive_on_with_light({-8, 0});
  const TestView view(recording, ground);
  EXPECT_DOUBLE_EQ(careful_drive(view).back().speed_mps, 10);
}

TEST(CarefulDrive, ObeysTheSignalAsItIsThen) {
  const Ground ground = road_with_crosswalk(false);
  Recording recording = drive_on_with_light({-8, 0});
  change_light(recording, 0, "red");
  change_light(recording, 2, "green");
  const TestView view(recording, ground);
  EXPECT_DOUBLE_EQ(careful_drive(view).back().speed_mps, 10) << "long before it has to brake";
}

TEST(CarefulDrive, DoesNotMindOtherSignals) {
  Ground ground = road_with_crosswalk(false);
  ground.crosswalks[0].signals = {"another"};
  Recording recording = drive_on_with_light({-8, 0});
  change_light(recording, 0, "red");
  const TestView view(recording, ground);
  EXPECT_DOUBLE_EQ(careful_drive(view).back().speed_mps, 10);
}

TEST(CarefulDrive, BrakesForAZebraWithSomebodyOnIt) {
  const Ground ground = road_with_crosswalk(true);
  // In the other lane: on the zebra, and not in the AV's way.
  const Recording on_it = drive_on_with_light({6, 82});
  EXPECT_LT(slowest_mps(careful_drive(TestView(on_it, ground))), 2);
  const Recording beside = drive_on_with_light({6, 79});
  EXPECT_EQ(slowest_mps(careful_drive(TestView(beside, ground))), 10);
}

TEST(CarefulDrive, DoesNotSeeWhoIsBehindAnObstacle) {
  // Somebody in the lane 40 m ahead, a wall right before them.
  Ground ground = road();
  ground.cruise_mps = 10;
  const Recording recording = drive(1, {steps({0, 0}, {0, 10}, 3), steps({0, 40}, {0, 0}, 3)});
  EXPECT_LT(careful_drive(TestView(recording, ground)).at(2).speed_mps, 10);
  ground.obstacles = {{-1, 1, 38, 39}};
  EXPECT_DOUBLE_EQ(careful_drive(TestView(recording, ground)).at(2).speed_mps, 10);
}

TEST(CarefulDrive, BeginsWithTheFirstRiskWhereTheCruisingSpeedIsNotKnown) {
  // The AV accelerates; a pedestrian steps into its lane at tick 3.
  const Ground ground = road();
  Recording recording(1,
                      {{"av", ActorKind::vehicle, 4, 2}, {"p1", ActorKind::pedestrian, 0.5, 0.5}});
  const double north = std::numbers::pi / 2;
  const std::vector<double> y{0, 4, 10, 18, 28, 38};
  const std::vector<double> speeds{4, 5, 7, 9, 10, 10};
  for (std::size_t i = 0; i < y.size(); ++i) {
    recording.add(Scene{{0, y[i], speeds[i], north}, {i < 3 ? -5.0 : 0.0, 60, 0, 0}});
  }
  const TestView view(recording, ground);
  const auto states = careful_drive(view);
  EXPECT_EQ(states[2], view.state(kAv, 2));
  EXPECT_NE(states[4], view.state(kAv, 4));
  EXPECT_LE(states[3].speed_mps, 7) << "it cruises at the speed that it had then";
}

TEST(StateBeyond, MovesOthersAsTheyDidLast) {
  const Ground ground = road();
  const Recording recording = drive(0.5, {steps({0, 0}, {0, 5}, 3), steps({-4, 20}, {1, 0}, 3)});
  const TestView view(recording, ground);
  EXPECT_EQ(state_beyond(view, 1, 2), view.state(1, 2));
  EXPECT_DOUBLE_EQ(state_beyond(view, 1, 4).x_m, 0) << "two ticks of 1 m after -2 m";
  EXPECT_DOUBLE_EQ(state_beyond(view, 1, 4).y_m, 20);
}

TEST(RiskStrip, IsTheAvsLaneOrElseItsBody) {
  const Recording recording = drive(1, {steps({1, 0}, {0, 5}, 2)});
  const Ground with_lanes = road();
  EXPECT_EQ(risk_strip(TestView(recording, with_lanes)).left_m, -3);
  EXPECT_EQ(risk_strip(TestView(recording, with_lanes)).right_m, 3);
  const Ground without;
  EXPECT_NEAR(risk_strip(TestView(recording, without)).left_m, 0, 1e-12);
  EXPECT_NEAR(risk_strip(TestView(recording, without)).right_m, 2, 1e-12);
}

TEST(GroundSignals, OfAWorldWithoutLanesAreZero) {
  const Ground without;
  const Recording recording = drive(1, {steps({1, 0}, {0, 5}, 2), steps({1, 20}, {0, 0}, 2)});
  const TestView view(recording, without);
  EXPECT_THAT(view.values(SignalId::av_lateral_offset), testing::Each(0));
  EXPECT_THAT(view.values(SignalId::av_in_lane), testing::Each(0));
  EXPECT_THAT(view.values(SignalId::in_lane, 1), testing::Each(0));
  EXPECT_THAT(view.values(SignalId::in_road, 1), testing::Each(0));
  EXPECT_THAT(view.values(SignalId::over_lane, 1), testing::Each(1)) << "over the AV's body";
}

TEST(PredictiveEncroachment, OnOneLineTakesTheTimeBetweenThem) {
  const Ground ground = road();
  const auto pret = [&](double av_speed, Place place, Place velocity) {
    const Recording recording = moment(av_speed, place, velocity);
    return TestView(recording, ground).values(SignalId::pret, 1)[0];
  };
  EXPECT_EQ(pret(10, {0, 20}, {0, 5}), 0) << "the AV catches up";
  EXPECT_DOUBLE_EQ(pret(10, {0, 20}, {0, 10}), 2) << "as fast, two seconds ahead";
  EXPECT_DOUBLE_EQ(pret(5, {0, -20}, {0, 5}), 4) << "as fast, behind it";
  EXPECT_EQ(pret(5, {0, -20}, {0, 10}), 0) << "it catches up with the AV";
  EXPECT_EQ(pret(5, {2, 20}, {0, 5}), std::numeric_limits<double>::infinity()) << "beside it";
  EXPECT_EQ(pret(5, {5, -5}, {1, 0}), std::numeric_limits<double>::infinity())
      << "both have left where their ways cross";
}

}  // namespace
}  // namespace jaywalk
