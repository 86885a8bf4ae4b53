// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/openscenario/courses.h"

#include <gtest/gtest.h>

#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

/// The AV at 10 m/s along x = 0, a tick of one second, and a pedestrian's places.
Recording with(std::vector<Place> places) {
  const std::size_t ticks = places.size();
  return drive(1, {steps({0, 0}, {0, 10}, ticks), std::move(places)});
}

/// Whether a player sees the AV touch that actor.
bool touches(const Recording& recording, const Courses& courses, std::size_t actor,
             double start_s = 0) {
  const Moving av{recording.actors()[0], courses.courses[0].points};
  const Moving other{recording.actors()[actor], courses.courses[actor].points, start_s};
  return first_touch(av, other, courses.stop_s, 0.001).has_value();
}

TEST(TimedCourses, PassThroughEachRecordedPlaceAtItsTick) {
  const Recording recording = with({{20, 5}, {21, 5}, {21, 6}, {21, 6}});
  const Courses courses = timed_courses(recording);
  ASSERT_EQ(courses.courses.size(), 2U);
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    for (std::size_t actor = 0; actor < 2; ++actor) {
      const Moving moving{recording.actors()[actor], courses.courses[actor].points};
      const ActorState at = state_at(moving, static_cast<double>(tick));
      EXPECT_DOUBLE_EQ(at.x_m, recording.scene(tick)[actor].x_m) << tick << ' ' << actor;
      EXPECT_DOUBLE_EQ(at.y_m, recording.scene(tick)[actor].y_m) << tick << ' ' << actor;
    }
  }
}

TEST(TimedCourses, BeginAtOnceAndEndWithTheTest) {
  const Courses courses = timed_courses(with({{20, 5}, {21, 5}, {22, 5}}));
  EXPECT_DOUBLE_EQ(courses.stop_s, 2);
  for (const Course& course : courses.courses) {
    EXPECT_EQ(course.start, CourseStart::at_once);
    EXPECT_DOUBLE_EQ(course.points.front().time_s, 0);
    EXPECT_DOUBLE_EQ(course.points.back().time_s, 2);
    EXPECT_TRUE(course.keeps_outcome);
  }
}

TEST(TimedCourses, LookTheWayOfTheStepThatBegins) {
  // Recordings have the heading of the step that led there.
  Recording recording(1, {{"av", ActorKind::vehicle, 4, 2}, {"p", ActorKind::pedestrian, 1, 1}});
  recording.add(Scene{{0, 0, 0, 1.5}, {20, 5, 0, 0}});
  recording.add(Scene{{0, 0, 0, 1.5}, {20, 6, 1, 1.5}});
  recording.add(Scene{{0, 0, 0, 1.5}, {19, 6, 1, 3}});
  recording.add(Scene{{0, 0, 0, 1.5}, {19, 6, 0, 3}});
  std::vector<double> headings;
  const Courses courses = timed_courses(recording);
  for (const Waypoint& point : courses.courses[1].points) {
    headings.push_back(point.heading_rad);
  }
  EXPECT_EQ(headings, (std::vector<double>{1.5, 3, 3, 3}));
}

// The pedestrian steps out of the AV's way in the tick in which it passes: in the test the step is
// made at once, before the AV comes; a player that takes a second for it lets the AV hit them.
TEST(TimedCourses, HurryWhoWasOutOfTheWayWhenTheAvCame) {
  const Recording recording = with({{0, 13}, {3, 13}, {3, 13}, {3, 13}});
  const Courses courses = timed_courses(recording);
  EXPECT_TRUE(courses.courses[1].keeps_outcome);
  EXPECT_FALSE(touches(recording, courses, 1));
  EXPECT_DOUBLE_EQ(courses.courses[1].points.back().x_m, 3);
}

TEST(TimedCourses, LeaveStepsThatDecideNothingTheirWholeTick) {
  const Courses courses = timed_courses(with({{20, 5}, {21, 5}, {22, 5}}));
  EXPECT_EQ(courses.courses[1].points.size(), 3U) << "one waypoint for each scene";
}

TEST(TimedCourses, KeepACollision) {
  Recording recording = with({{5, 15}, {0, 15}, {0, 15}});
  recording.add(RecordedEvent{.tick = 2, .actor = 1, .kind = "collision"});
  const Courses courses = timed_courses(recording);
  EXPECT_TRUE(courses.courses[1].keeps_outcome);
  EXPECT_TRUE(touches(recording, courses, 1));
}

TEST(TimedCourses, SayWhereNoPlayerFindsTheTestsOutcome) {
  // They stand in the way from beginning to end, yet no collision was recorded.
  const Courses courses = timed_courses(with({{0, 15}, {0, 15}, {0, 15}}));
  EXPECT_FALSE(courses.courses[1].keeps_outcome);
  EXPECT_TRUE(courses.courses[0].keeps_outcome);
}

TEST(ReactiveCourses, SetOutWhenTheAvIsAsNearAsItWas) {
  // Along the pavement for a second, then across, far ahead of the AV.
  const Recording recording = with({{6, 60}, {6, 61}, {5, 61}, {4, 61}});
  const Course walk = reactive_courses(recording).courses[1];
  EXPECT_EQ(walk.start, CourseStart::time_to_collision);
  // From (6, 61) the near corner is 4.75 m aside and 60.75 - 12 = 48.75 m ahead after one second.
  EXPECT_NEAR(walk.value_s, std::hypot(4.75, 48.75) / 10, 1e-9);
  EXPECT_DOUBLE_EQ(walk.points.front().y_m, 61) << "it waits where it stepped out";
  EXPECT_DOUBLE_EQ(walk.points.front().time_s, 0);
}

TEST(ReactiveCourses, SetOutByTheClockWhereTheAvHasPassed) {
  const Recording recording = with({{6, -20}, {6, -20}, {5, -20}, {4, -20}});
  const Course walk = reactive_courses(recording).courses[1];
  EXPECT_EQ(walk.start, CourseStart::at_time);
  EXPECT_DOUBLE_EQ(walk.value_s, 1);
}

TEST(ReactiveCourses, LeaveWhoNeverMovesOnATimetable) {
  const Course stands = reactive_courses(with({{6, 30}, {6, 30}, {6, 30}})).courses[1];
  EXPECT_EQ(stands.start, CourseStart::at_once);
  EXPECT_GE(stands.points.size(), 2U);
}

TEST(ReactiveCourses, LeaveOtherTrafficOnATimetable) {
  Recording recording(1, {{"av", ActorKind::vehicle, 4, 2}, {"c", ActorKind::cyclist, 2, 0.5}});
  for (int tick = 0; tick < 4; ++tick) {
    recording.add(Scene{{0, 10.0 * tick, 10, std::acos(0.0)}, {8 - 1.0 * tick, 60, 1, 0}});
  }
  const Course course = reactive_courses(recording).courses[1];
  EXPECT_EQ(course.start, CourseStart::at_once);
  EXPECT_DOUBLE_EQ(course.points.front().x_m, 8);
}

TEST(ReactiveCourses, LeaveOutWaypointsBetweenTheirNeighbours) {
  const Courses courses = reactive_courses(with({{20, 5}, {19, 5}, {18, 5}, {17, 5}, {16, 5}}));
  EXPECT_EQ(courses.courses[0].points.size(), 2U) << "the AV drives evenly";
  EXPECT_EQ(courses.courses[1].points.size(), 2U) << "and they walk evenly";
}

TEST(ReactiveCourses, LetTheAvDriveOnForATick) {
  const Courses courses = reactive_courses(with({{20, 5}, {19, 5}, {18, 5}}));
  EXPECT_DOUBLE_EQ(courses.stop_s, 2);
  EXPECT_DOUBLE_EQ(courses.courses[0].points.back().time_s, 3);
  EXPECT_DOUBLE_EQ(courses.courses[0].points.back().y_m, 30);
}

TEST(ReactiveCourses, GoOnForATickAfterACollision) {
  Recording recording = with({{5, 15}, {0, 15}, {0, 15}});
  recording.add(RecordedEvent{.tick = 2, .actor = 1, .kind = "collision"});
  EXPECT_DOUBLE_EQ(reactive_courses(recording).stop_s, 3);
  EXPECT_DOUBLE_EQ(timed_courses(recording).stop_s, 2);
}

}  // namespace
}  // namespace jaywalk
