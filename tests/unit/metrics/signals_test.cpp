// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/signals/signals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The value at a tick, of the first road user.
double at(const Recording& recording, SignalId signal, std::size_t tick = 0) {
  const Ground ground = road();
  return TestView(recording, ground).values(signal, 1)[tick];
}

std::vector<double> all(const Recording& recording, SignalId signal) {
  const Ground ground = road();
  const TestView view(recording, ground);
  const auto values = view.values(signal, 1);
  return {values.begin(), values.end()};
}

TEST(Signals, OfSomebodyStandingAhead) {
  // The AV's front is at 2 m, the pedestrian's near side at 12 m.
  const Recording ahead = moment(10, {0, 12.25}, {0, 0});
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::distance), 10);
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::gap), 10);
  EXPECT_EQ(at(ahead, SignalId::in_path), 1);
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::ttc), 1);
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::time_gap), 1.025);
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::drac), 5) << "10^2 / (2 * 10)";
  EXPECT_NEAR(at(ahead, SignalId::btn), 5 / 7.5903471, 1e-9);
  EXPECT_NEAR(at(ahead, SignalId::ttb), 1 - 10 / (2 * 7.5903471), 1e-9);
  EXPECT_EQ(at(ahead, SignalId::pret), 0) << "it is still there when the AV comes";
  EXPECT_NEAR(at(moment(10, {0, 12.25}, {0, 20}), SignalId::pret), 1.225, 1e-12)
      << "the AV comes that long after it has been there";
}

TEST(Signals, OfSomebodyDrivingAheadDependOnTheDifferenceOfSpeeds) {
  const Recording ahead = moment(10, {0, 12.25}, {0, 4});
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::ttc), 10.0 / 6);
  EXPECT_DOUBLE_EQ(at(ahead, SignalId::drac), 36.0 / 20);
  EXPECT_EQ(at(moment(10, {0, 12.25}, {0, 12}), SignalId::ttc), kInf);
  EXPECT_EQ(at(moment(10, {0, 12.25}, {0, 12}), SignalId::drac), 0);
}

TEST(Signals, OfSomebodyWhoCrossesBehindTheAv) {
  // The AV is beside it from 0.975 s to 1.425 s, it is in the AV's way from 1.5 s on.
  const Recording crossing = moment(10, {-5, 12}, {2.5, 0});
  EXPECT_EQ(at(crossing, SignalId::ttc), kInf);
  EXPECT_EQ(at(crossing, SignalId::drac), 0);
  EXPECT_EQ(at(crossing, SignalId::ttb), kInf);
  EXPECT_EQ(at(crossing, SignalId::in_path), 0);
  EXPECT_DOUBLE_EQ(at(crossing, SignalId::pret), 2 - 1.2);
}

TEST(Signals, OfSomebodyOnACollisionCourse) {
  // In the AV's way from (5 - 1.25) / 3 = 1.25 s on; the AV is beside it from 0.975 s to 1.425 s.
  const Recording crossing = moment(10, {-5, 12}, {3, 0});
  EXPECT_DOUBLE_EQ(at(crossing, SignalId::ttc), 1.25);
  EXPECT_DOUBLE_EQ(at(crossing, SignalId::drac), 100 / (2 * 9.75));
}

TEST(Signals, OfSomebodyPassedAreWithoutDanger) {
  const Recording behind = moment(10, {0, -5}, {0, 0});
  EXPECT_EQ(at(behind, SignalId::gap), kInf);
  EXPECT_EQ(at(behind, SignalId::ttc), kInf);
  EXPECT_EQ(at(behind, SignalId::time_gap), kInf);
  EXPECT_EQ(at(behind, SignalId::in_path), 0);
  EXPECT_EQ(at(behind, SignalId::pret), kInf);
}

TEST(Signals, SeeWhatHappensBetweenTwoTicks) {
  // At both ticks the AV is 7.75 m away, between them it drives over the pedestrian.
  const Recording over = drive(1, {{{0, 0}, {0, 20}}, steps({0, 10}, {0, 0}, 2)});
  EXPECT_THAT(all(over, SignalId::distance), ElementsAre(7.75, 7.75));
  EXPECT_THAT(all(over, SignalId::closest), ElementsAre(7.75, 0));
  EXPECT_THAT(all(over, SignalId::collision), ElementsAre(0, 1));
  const Recording past = drive(1, {{{0, 0}, {0, 20}}, steps({3, 10}, {0, 0}, 2)});
  EXPECT_THAT(all(past, SignalId::closest),
              ElementsAre(DoubleNear(std::hypot(1.75, 7.75), 1e-12), DoubleNear(1.75, 1e-12)));
}

TEST(Signals, ImpactSpeedIsThatOfTheFirstContact) {
  // The AV slows from 20 m/s to 10 m/s; its way counts as driven evenly: contact after 7.75 of 15
  // m.
  Recording braking(1, {{"av", ActorKind::vehicle, 4, 2}, {"p1", ActorKind::pedestrian, 0.5, 0.5}});
  const double north = std::numbers::pi / 2;
  braking.add(Scene{{0, 0, 20, north}, {0, 10, 0, 0}});
  braking.add(Scene{{0, 11, 10, north}, {0, 10, 0, 0}});
  braking.add(Scene{{0, 11, 0, north}, {0, 11, 0, 0}});
  EXPECT_THAT(all(braking, SignalId::impact_speed),
              ElementsAre(0, DoubleNear(20 - 10 * 7.75 / 11, 1e-9), 0))
      << "who is touched already is not hit again";
  const Ground ground = road();
  EXPECT_THAT(TestView(braking, ground).values(SignalId::av_acceleration),
              ElementsAre(0, -10, -10));
  EXPECT_THAT(TestView(braking, ground).values(SignalId::av_deceleration), ElementsAre(0, 10, 10));
}

TEST(Signals, KnowTheGround) {
  const Recording crossing = drive(1, {steps({0, 0}, {0, 9}, 6), steps({-4, 30}, {3, 0}, 6)});
  EXPECT_THAT(all(crossing, SignalId::in_lane), ElementsAre(0, 1, 1, 0, 0, 0));
  EXPECT_THAT(all(crossing, SignalId::in_road), ElementsAre(0, 1, 1, 1, 1, 0));
  // The front was at 2 m at tick 0, the middle is 28 m ahead of that at tick 1.
  EXPECT_DOUBLE_EQ(at(crossing, SignalId::time_gap, 1), 28.0 / 9);
  EXPECT_THAT(all(crossing, SignalId::in_zone), testing::Each(0));
  const Recording near = drive(1, {steps({0, 0}, {0, 9}, 3), steps({-4, 11}, {3, 0}, 3)});
  EXPECT_THAT(all(near, SignalId::in_zone), ElementsAre(0, 1, 0)) << "11 m - 2 m = 9 m/s * 1 s";
}

TEST(Signals, OfTheAvInItsLane) {
  const Ground ground = road();
  const Recording drifting = drive(1, {{{0, 0}, {2, 9}, {2.5, 18}}});
  const TestView view(drifting, ground);
  EXPECT_THAT(view.values(SignalId::av_lateral_offset), ElementsAre(0, 2, 2.5));
  EXPECT_THAT(view.values(SignalId::av_in_lane), ElementsAre(1, 1, 0));
  EXPECT_THAT(view.values(SignalId::time), ElementsAre(0, 1, 2));
  EXPECT_THAT(view.values(SignalId::remaining), ElementsAre(2, 1, 0));
}

/// A pedestrian gets into the lane at 1.25 s and stands in the AV's way; the AV's front is then so
/// far away from it.
Recording surprise(double gap_m) {
  const double y = 12.5 + 2 + gap_m + 0.25;
  return drive(1, {steps({0, 0}, {0, 10}, 5), {{-4, y}, {-4, y}, {0, y}, {0, y}, {0, y}}});
}

TEST(Signals, ACarefulAndCompetentDriverNeedsTimeToPerceiveAndRoomToBrake) {
  // In the record the pedestrian is a risk from 1 s on, when the tick of its step begins: 1.15 s at
  // 10 m/s, 0.6 s in which braking grows (5.54 m), then from 7.72 m/s at 7.59 m/s2 (3.93 m) make
  // 20.97 m; the surprise is reported for 1.25 s, 2.5 m later.
  EXPECT_EQ(at(surprise(18.6), SignalId::avoidable), 1);
  EXPECT_EQ(at(surprise(18.3), SignalId::avoidable), 0);
  EXPECT_EQ(at(surprise(60), SignalId::avoidable), 1);
  EXPECT_EQ(
      at(drive(1, {steps({0, 0}, {0, 10}, 3), steps({-4, 5}, {0, 0}, 3)}), SignalId::avoidable), 1)
      << "who stays on the pavement is no risk";
}

TEST(Signals, ThatDriverSeesOthersWhereTheyAreWithinATick) {
  // A steady walker is over the lane from 1.1875 s on, which is seen at 1.2 s: 0.05 s before
  // the 1.25 s for which the surprise is reported, and 0.5 m.
  Ground ground = road();
  const auto avoidable = [&](double gap_m) {
    const Recording recording = surprise(gap_m);
    return TestView(recording, ground).values(SignalId::avoidable, 1)[0];
  };
  EXPECT_EQ(avoidable(20.3), 1);
  ground.moves_evenly = true;
  EXPECT_EQ(avoidable(20.6), 1);
  EXPECT_EQ(avoidable(20.3), 0);
}

TEST(Signals, TheNearestMayChange) {
  const Ground ground = road();
  const Recording two =
      drive(1, {steps({0, 0}, {0, 10}, 3), steps({5, 4}, {0, 0}, 3), steps({5, 20}, {0, 0}, 3)});
  EXPECT_THAT(TestView(two, ground).nearest(), ElementsAre(1, 1, 2));
}

TEST(Signals, OfTrafficSignalsThereAreNone) {
  Recording recording(1, {{"av", ActorKind::vehicle, 4, 2}, {"s1", ActorKind::signal, 0.1, 0.1}});
  recording.add(Scene{{}, {0, 3, 0, 0}});
  const Ground ground = road();
  EXPECT_TRUE(TestView(recording, ground).road_users().empty());
}

}  // namespace
}  // namespace jaywalk
