// SPDX-License-Identifier: Apache-2.0
#pragma once

// The state of a world at one moment, in metres and seconds: its actors (road users and whatever
// else is logged) with their boxes. All code that logs, measures, draws or exports a test reads
// scenes, so none of it knows the world's own units.
//
// The plane: y runs along the road, the way the automated vehicle (AV) drives, x to its right; the
// origin is the left corner of the world at its beginning. Headings are counted
// counter-clockwise from x: the AV's is pi / 2.

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <jaywalk/vehicle.h>

namespace jaywalk {

/// Standard gravity in m/s^2 (ISO 80000-3), for everything that drives, brakes and is measured.
inline constexpr double kGravityMps2 = 9.80665;

/// The side of the box that stands for a pedestrian, in metres.
inline constexpr double kPedestrianSizeM = 0.5;

/// The box of an actor of that kind, where nothing else is known of it.
struct BoxSize {
  double length_m = 0;
  double width_m = 0;
};
[[nodiscard]] BoxSize size_of(ActorKind kind);

/// A participant of a test; does not change during the test.
struct Actor {
  /// Unique in the test: `av`, or the agent's name.
  std::string name;
  ActorKind kind = ActorKind::pedestrian;
  /// The size of the box around it; the length is along its heading.
  double length_m = 0;
  double width_m = 0;

  friend bool operator==(const Actor&, const Actor&) = default;
};

/// One actor at one moment.
struct ActorState {
  /// The middle of its box.
  double x_m = 0;
  double y_m = 0;
  /// Along its heading, at least 0.
  double speed_mps = 0;
  double heading_rad = 0;

  friend bool operator==(const ActorState&, const ActorState&) = default;
};

/// The states of all actors, in the order of the world's actors. The first is the AV.
using Scene = std::vector<ActorState>;

/// The corners of an actor's box, counter-clockwise from the rear right one.
struct Point {
  double x_m = 0;
  double y_m = 0;
};
[[nodiscard]] std::vector<Point> box(const Actor& actor, const ActorState& state);

/// The smallest distance between two boxes in metres; 0 if they touch or overlap.
[[nodiscard]] double distance_m(std::span<const Point> first, std::span<const Point> second);

/// Along the axes, in metres: boxes of road users, obstacles, crosswalks.
struct Rectangle {
  double left = 0;
  double right = 0;
  double near = 0;
  double far = 0;

  [[nodiscard]] bool overlaps(const Rectangle& other) const {
    return left < other.right && other.left < right && near < other.far && other.near < far;
  }
  /// Its left and near sides belong to it, the others to its neighbours.
  [[nodiscard]] bool contains(Point point) const {
    return left <= point.x_m && point.x_m < right && near <= point.y_m && point.y_m < far;
  }
  [[nodiscard]] Point middle() const { return {(left + right) / 2, (near + far) / 2}; }
};

/// The smallest around the points. REQUIRES: at least one.
[[nodiscard]] inline Rectangle surrounding(std::span<const Point> points) {
  const auto across = std::ranges::minmax(points, {}, &Point::x_m);
  const auto along = std::ranges::minmax(points, {}, &Point::y_m);
  return {across.min.x_m, across.max.x_m, along.min.y_m, along.max.y_m};
}

}  // namespace jaywalk
