// SPDX-License-Identifier: Apache-2.0
#include "env/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace jaywalk {
namespace {

double cross(Point origin, Point a, Point b) {
  return (a.x_m - origin.x_m) * (b.y_m - origin.y_m) - (a.y_m - origin.y_m) * (b.x_m - origin.x_m);
}

// Some edge of `first` has all of `second` strictly on its outer side.
bool separates(std::span<const Point> first, std::span<const Point> second) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Point from = first[i];
    const Point to = first[(i + 1) % first.size()];
    if (std::ranges::all_of(second, [&](Point p) { return cross(from, to, p) < 0; })) return true;
  }
  return false;
}

/// From a point to the nearest one of an edge.
Point way_to_edge(Point p, Point from, Point to) {
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const double length2 = dx * dx + dy * dy;
  const double along =
      length2 > 0 ? ((p.x_m - from.x_m) * dx + (p.y_m - from.y_m) * dy) / length2 : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return {p.x_m - from.x_m - t * dx, p.y_m - from.y_m - t * dy};
}

/// The shortest way found so far; one root is drawn in the end, as that takes longest.
struct Shortest {
  Point way{};
  double square = std::numeric_limits<double>::infinity();

  void corners_to_edges(std::span<const Point> corners, std::span<const Point> polygon) {
    for (const Point corner : corners) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point other = way_to_edge(corner, polygon[i], polygon[(i + 1) % polygon.size()]);
        const double length2 = other.x_m * other.x_m + other.y_m * other.y_m;
        if (length2 >= square) continue;
        square = length2;
        way = other;
      }
    }
  }
};

}  // namespace

std::string_view name(ActorKind kind) {
  static constexpr std::array<std::string_view, 4> names{"vehicle", "pedestrian", "cyclist",
                                                         "signal"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<Point> box(const Actor& actor, const ActorState& state) {
  const double c = std::cos(state.heading_rad);
  const double s = std::sin(state.heading_rad);
  const double l = actor.length_m / 2;
  const double w = actor.width_m / 2;
  const auto corner = [&](double ahead, double left) {
    return Point{state.x_m + c * ahead - s * left, state.y_m + s * ahead + c * left};
  };
  return {corner(-l, -w), corner(l, -w), corner(l, w), corner(-l, w)};
}

double distance_m(std::span<const Point> first, std::span<const Point> second) {
  if (!separates(first, second) && !separates(second, first)) return 0;
  Shortest shortest;
  shortest.corners_to_edges(first, second);
  shortest.corners_to_edges(second, first);
  return std::hypot(shortest.way.x_m, shortest.way.y_m);
}

BoxSize size_of(ActorKind kind) {
  switch (kind) {
    case ActorKind::vehicle:
      return {4.5, 1.8};
    case ActorKind::pedestrian:
      return {kPedestrianSizeM, kPedestrianSizeM};
    case ActorKind::cyclist:
      return {1.8, 0.6};
    case ActorKind::signal:
      return {0.3, 0.3};
  }
  return {};
}

}  // namespace jaywalk
