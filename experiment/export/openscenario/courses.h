// SPDX-License-Identifier: Apache-2.0
#pragma once

// The courses of a recorded test's actors for a player of scenarios, which moves all actors at the
// same time and without jumps. In a test all agents step at once at the beginning of a tick and
// then the automated vehicle (AV) drives through it. Played back along the line through the
// recorded places, a pedestrian that had just left the AV's way would still be in it, and one test
// in four would have another outcome. So steps are as slow as the outcome allows: most take the
// whole tick, and those that decide about a collision a part of it. See env/scene.h for units and
// axes.

#include <optional>
#include <span>
#include <vector>

#include "experiment/judge/recording.h"

namespace jaywalk {

/// The event that sets a course in motion.
enum class CourseStart { at_once, time_to_collision, at_time };

struct Waypoint {
  /// Since the course was set in motion.
  double time_s = 0;
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
};

/// The way of one actor through a test. Until it is set in motion it stands at its first waypoint.
struct Course {
  CourseStart start = CourseStart::at_once;
  /// The AV's time to collision below which it begins, or the time since the test's beginning, in
  /// s.
  double value_s = 0;
  /// At least two, in the order of time.
  std::vector<Waypoint> points;
  /// A player finds a collision of the AV with this actor if and only if there was one in the test.
  bool keeps_outcome = true;
};

/// The courses of all actors, in their order.
struct Courses {
  std::vector<Course> courses;
  /// When the test is over, in s. One tick later than it was if there was a collision, so that no
  /// player misses it.
  double stop_s = 0;
};

/// Everybody on a timetable: at the end of each tick all are where they were recorded.
/// REQUIRES: at least two scenes, as for the next one.
[[nodiscard]] Courses timed_courses(const Recording& recording);

/// Each pedestrian waits where it stepped out, that is, made its first step across the road, until
/// the AV's time to collision with it has fallen to the value in the test, and then repeats its
/// way. If a time to collision cannot trigger it (the AV stood, or had passed), the time of the
/// step does. All other actors keep to a timetable.
[[nodiscard]] Courses reactive_courses(const Recording& recording);

/// An actor and its way, which is played as a player of scenarios does: linearly from waypoint to
/// waypoint (playback.cpp).
struct Moving {
  const Actor& actor;
  std::span<const Waypoint> points;
  /// When its first waypoint's time is, in s; before it stands there.
  double start_s = 0;
};

/// Where it is at a time; beyond its last waypoint it stands. The speed is that of the stretch that
/// begins or continues at that time.
[[nodiscard]] ActorState state_at(const Moving& moving, double time_s);

/// The first time at which the two touch, looking every `step_s`; empty if they do not before
/// `until_s`. REQUIRES: step_s > 0.
[[nodiscard]] std::optional<double> first_touch(const Moving& first, const Moving& second,
                                                double until_s, double step_s);

/// The AV's time to collision with a standing actor: the distance between the boxes divided by the
/// AV's speed, as OpenSCENARIO has it (free space, not along the route). Empty if the AV stands, or
/// if its front has come to the other's box.
[[nodiscard]] std::optional<double> time_to_collision(const Moving& av, const Moving& other,
                                                      double time_s);

/// The first time at which that is less than `value_s`, looking every `step_s`; empty if never.
[[nodiscard]] std::optional<double> first_below(const Moving& av, const Moving& other,
                                                double value_s, double until_s, double step_s);

}  // namespace jaywalk
