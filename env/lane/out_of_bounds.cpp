// SPDX-License-Identifier: Apache-2.0
#include "env/lane/out_of_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "env/lane/polygon.h"

namespace jaywalk::lane {
namespace {

constexpr std::size_t kReach = 14;

/// A convex polygon of few corners. A quadrilateral cut by four lines has at most eight.
struct Polygon {
  std::array<Point, 16> corners;
  std::size_t size = 0;

  void add(const Point& point) { corners[size++] = point; }
};

double doubled_area(std::span<const Point> corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[i + 1 < corners.size() ? i + 1 : 0];
    sum += a.x_m * b.y_m - b.x_m * a.y_m;
  }
  return sum;
}

/// Puts the part of a polygon on one side of a line (Sutherland and Hodgman 1974) into `kept`;
/// false, and nothing is put, if that is all of it.
bool cut(const Polygon& polygon, const Point& from, const Point& to, double side, Polygon& kept) {
  std::array<double, 17> sides;
  bool whole = true;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    sides[i] = side * cross(from, to, polygon.corners[i]);
    whole = whole && sides[i] >= 0;
  }
  if (whole) return false;
  sides[polygon.size] = sides[0];
  kept.size = 0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Point& a = polygon.corners[i];
    const Point& b = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
    const double fa = sides[i];
    const double fb = sides[i + 1];
    if (fa >= 0) kept.add(a);
    // This side crosses the line: the crossing is a new corner.
    if ((fa >= 0) == (fb >= 0)) continue;
    const double share = fa / (fa - fb);
    kept.add({a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)});
  }
  return true;
}

/// Areas that two convex polygons have in common.
class CommonArea {
 public:
  explicit CommonArea(const Polygon& box) : box_(box) {}

  double with(const Quad& quad) {
    // The interior of a counter-clockwise quadrilateral lies on the left side of its edges.
    const double side = doubled_area(quad) > 0 ? 1 : -1;
    const Polygon* rest = &box_;
    Polygon* next = &first_;
    for (std::size_t i = 0; i < 4 && rest->size > 0; ++i) {
      if (!cut(*rest, quad[i], quad[(i + 1) % 4], side, *next)) continue;
      rest = next;
      next = next == &first_ ? &second_ : &first_;
    }
    return std::fabs(doubled_area({rest->corners.data(), rest->size})) / 2;
  }

 private:
  const Polygon& box_;
  Polygon first_;
  Polygon second_;
};

Polygon box_of(const VehicleState& state, const VehicleParameters& parameters) {
  const double c = std::cos(state.heading_rad);
  const double s = std::sin(state.heading_rad);
  const double l = parameters.length_m / 2;
  const double w = parameters.width_m / 2;
  Polygon box;
  for (const auto& [along, left] :
       {std::pair{l, w}, std::pair{-l, w}, std::pair{-l, -w}, std::pair{l, -w}}) {
    box.add({state.x_m + c * along - s * left, state.y_m + s * along + c * left});
  }
  return box;
}

/// Points as the car sees them.
class CarFrame {
 public:
  CarFrame(const VehicleState& state, const VehicleParameters& parameters)
      : middle_{state.x_m, state.y_m},
        cosine_(std::cos(state.heading_rad)),
        sine_(std::sin(state.heading_rad)),
        along_(parameters.length_m / 2 + kCertain),
        left_(parameters.width_m / 2 + kCertain) {}

  /// Beyond which of the lines through the sides of the car's box a point lies, by more than
  /// rounding: a bit for each.
  [[nodiscard]] unsigned beyond(const Point& point) const {
    const double dx = point.x_m - middle_.x_m;
    const double dy = point.y_m - middle_.y_m;
    const double along = cosine_ * dx + sine_ * dy;
    const double left = cosine_ * dy - sine_ * dx;
    return (along > along_ ? 1U : 0U) | (along < -along_ ? 2U : 0U) | (left > left_ ? 4U : 0U) |
           (left < -left_ ? 8U : 0U);
  }

 private:
  static constexpr double kCertain = 1e-6;
  Point middle_;
  double cosine_;
  double sine_;
  double along_;
  double left_;
};

}  // namespace

double out_of_bounds_share(const Road& road, const VehicleState& state,
                           const VehicleParameters& parameters, std::size_t near) {
  const Polygon box = box_of(state, parameters);
  const CarFrame frame(state, parameters);
  CommonArea common(box);
  const std::size_t first = near > kReach ? near - kReach : 0;
  const std::size_t last = std::min(road.middle.size() - 1, near + kReach);
  const auto beyond = [&](std::size_t i) {
    return frame.beyond(road.middle[i]) & frame.beyond(road.right[i]);
  };
  double inside = 0;
  unsigned here = beyond(first);
  for (std::size_t i = first; i < last; ++i) {
    const unsigned before = here;
    here = beyond(i + 1);
    // A stretch that lies beyond one of the car's sides has nothing in common with it.
    if ((before & here) != 0) continue;
    inside += common.with({road.middle[i], road.middle[i + 1], road.right[i + 1], road.right[i]});
  }
  return std::max(0.0, 1 - inside / (parameters.length_m * parameters.width_m));
}

}  // namespace jaywalk::lane
