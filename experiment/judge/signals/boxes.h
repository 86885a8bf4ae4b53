// SPDX-License-Identifier: Apache-2.0
#pragma once

// Boxes in motion: when two convex polygons touch, and how close they come. Motion is translation
// along a straight line at constant speed; everything is exact, nothing is sampled.

#include <optional>
#include <span>
#include <vector>

#include "env/scene.h"

namespace jaywalk {

struct Vector {
  double x = 0;
  double y = 0;
};

[[nodiscard]] inline Vector operator-(Point a, Point b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
[[nodiscard]] inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

/// The way an actor faces, of length 1, and its velocity in m/s.
[[nodiscard]] Vector heading(const ActorState& state);
[[nodiscard]] Vector velocity(const ActorState& state);
/// From one state to a later one, in metres.
[[nodiscard]] Vector displacement(const ActorState& from, const ActorState& to);

struct Span1D {
  double from = 0;
  double to = 0;
};

/// The times of `within` at which `moving`, which starts where it is and has that velocity, touches
/// or overlaps `fixed`; none if it never does. REQUIRES: convex polygons (a point will do).
[[nodiscard]] std::optional<Span1D> contact(std::span<const Point> fixed,
                                            std::span<const Point> moving, Vector velocity,
                                            Span1D within);

/// The smallest distance of two boxes while both move evenly from one state to the next, turned all
/// the while as they are in the later one; 0 if they touch.
struct Movement {
  ActorState from;
  ActorState to;
};
[[nodiscard]] double closest_m(const Actor& fixed, const Movement& its_step, const Actor& moving,
                               const Movement& step);

/// Whether they touch in that step: closest_m is 0. Quick where they are far apart.
[[nodiscard]] bool touch(const Actor& fixed, const Movement& its_step, const Actor& moving,
                         const Movement& step);

/// The smallest convex polygon around the points, counter-clockwise.
[[nodiscard]] std::vector<Point> convex_hull(std::vector<Point> points);

/// The area that a polygon covers as it is moved along `way`.
[[nodiscard]] std::vector<Point> swept(std::span<const Point> polygon, Vector way);

}  // namespace jaywalk
