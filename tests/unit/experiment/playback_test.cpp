// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "experiment/export/openscenario/courses.h"

namespace jaywalk {
namespace {

constexpr double kNorth = std::numbers::pi / 2;

const Actor kCar{"av", ActorKind::vehicle, 4, 2};
const Actor kPerson{"p", ActorKind::pedestrian, 0.5, 0.5};

/// From (0, 0) to (0, 10) in one second, then to (0, 30) in two.
const std::vector<Waypoint> kDrive{{0, 0, 0, kNorth}, {1, 0, 10, kNorth}, {3, 0, 30, kNorth}};
const std::vector<Waypoint> kStanding{{0, 0, 20, 0}, {9, 0, 20, 0}};

TEST(Playback, GoesEvenlyFromWaypointToWaypoint) {
  const Moving car{.actor = kCar, .points = kDrive};
  EXPECT_DOUBLE_EQ(state_at(car, 0.25).y_m, 2.5);
  EXPECT_DOUBLE_EQ(state_at(car, 2).y_m, 20);
  EXPECT_DOUBLE_EQ(state_at(car, 0.25).speed_mps, 10);
  EXPECT_DOUBLE_EQ(state_at(car, 1).speed_mps, 10) << "of the stretch that begins there";
  EXPECT_DOUBLE_EQ(state_at(car, 0).y_m, 0);
}

TEST(Playback, StandsAfterItsLastWaypoint) {
  const Moving car{.actor = kCar, .points = kDrive};
  EXPECT_DOUBLE_EQ(state_at(car, 3).y_m, 30);
  EXPECT_EQ(state_at(car, 3).speed_mps, 0);
  EXPECT_DOUBLE_EQ(state_at(car, 100).y_m, 30);
  EXPECT_DOUBLE_EQ(state_at(car, 100).heading_rad, kNorth);
}

TEST(Playback, WaitsUntilItIsSetInMotion) {
  const Moving late{.actor = kCar, .points = kDrive, .start_s = 5};
  EXPECT_DOUBLE_EQ(state_at(late, 4).y_m, 0);
  EXPECT_EQ(state_at(late, 4).speed_mps, 0);
  EXPECT_DOUBLE_EQ(state_at(late, 5.5).y_m, 5);
  EXPECT_DOUBLE_EQ(state_at(late, 5.5).speed_mps, 10);
}

TEST(Playback, FindsTheFirstTouch) {
  const Moving car{.actor = kCar, .points = kDrive};
  const Moving person{.actor = kPerson, .points = kStanding};
  // The front is at 19.75 m when the middle is at 17.75 m, after 1.775 s.
  const auto touch = first_touch(car, person, 3, 0.001);
  ASSERT_TRUE(touch);
  EXPECT_NEAR(*touch, 1.775, 0.001);
}

TEST(Playback, DoesNotTouchBeforeItsEnd) {
  const Moving car{.actor = kCar, .points = kDrive};
  const Moving person{.actor = kPerson, .points = kStanding};
  EXPECT_FALSE(first_touch(car, person, 1.7, 0.01));
  const std::vector<Waypoint> beside{{0, 3, 20, 0}, {9, 3, 20, 0}};
  EXPECT_FALSE(first_touch(car, {.actor = kPerson, .points = beside}, 3, 0.01));
}

TEST(Playback, LooksAtTheEndItself) {
  const Moving car{.actor = kCar, .points = kDrive};
  const Moving person{.actor = kPerson, .points = kStanding};
  EXPECT_EQ(first_touch(car, person, 1.8, 1), 1.8) << "steps of a second: 0, 1 and the end";
}

TEST(Playback, TouchesAtOnceWhereTwoStandTogether) {
  const Moving person{.actor = kPerson, .points = kStanding};
  EXPECT_EQ(first_touch(person, person, 1, 0.5), 0);
}

TEST(TimeToCollision, IsTheFreeWayByTheSpeed) {
  const Moving car{.actor = kCar, .points = kDrive};
  const Moving person{.actor = kPerson, .points = kStanding};
  EXPECT_DOUBLE_EQ(*time_to_collision(car, person, 0), 1.775);
  EXPECT_DOUBLE_EQ(*time_to_collision(car, person, 1), 0.775);
}

TEST(TimeToCollision, CountsTheDistanceAsideToo) {
  const std::vector<Waypoint> beside{{0, 4.25, 20, 0}, {9, 4.25, 20, 0}};
  const Moving car{.actor = kCar, .points = kDrive};
  EXPECT_NEAR(*time_to_collision(car, {.actor = kPerson, .points = beside}, 0),
              std::hypot(17.75, 3) / 10, 1e-12);
}

TEST(TimeToCollision, EndsWhenTheFrontHasCome) {
  const Moving car{.actor = kCar, .points = kDrive};
  const Moving person{.actor = kPerson, .points = kStanding};
  EXPECT_FALSE(time_to_collision(car, person, 1.8)) << "the front is at 20 m";
  EXPECT_FALSE(time_to_collision(car, person, 4)) << "the AV stands";
}

TEST(TimeToCollision, IsFirstBelowAValueAtSomeStep) {
  const Moving car{.actor = kCar, .points = kDrive};
  const Moving person{.actor = kPerson, .points = kStanding};
  // It falls from 1.775 s by a second in each second: below 1 s after 0.775 s.
  EXPECT_NEAR(*first_below(car, person, 1, 3, 0.1), 0.8, 1e-12);
  EXPECT_EQ(first_below(car, person, 5, 3, 0.1), 0);
  EXPECT_FALSE(first_below(car, person, 1, 0.7, 0.1));
}

}  // namespace
}  // namespace jaywalk
