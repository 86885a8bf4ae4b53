#pragma once

// Plays courses as a player of scenarios does: linearly from waypoint to waypoint. Read courses.h
// first.

#include <optional>

#include "experiment/export/openscenario/courses.h"

namespace jaywalk {

/// An actor and its way.
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
