#include "env/lane/out_of_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

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

double doubled_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Point& a = polygon.corners[i];
    const Point& b = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
    sum += a.x_m * b.y_m - b.x_m * a.y_m;
  }
  return sum;
}

/// The part of a polygon on one side of a line (Sutherland and Hodgman 1974).
Polygon cut(const Polygon& polygon, const Point& from, const Point& to, double side) {
  std::array<double, 17> sides;
  bool whole = true;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    sides[i] = side * cross(from, to, polygon.corners[i]);
    whole = whole && sides[i] >= 0;
  }
  if (whole) return polygon;
  sides[polygon.size] = sides[0];
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Point& a = polygon.corners[i];
    const Point& b = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
    const double fa = sides[i];
    const double fb = sides[i + 1];
    if (fa >= 0) kept.add(a);
    if ((fa >= 0) == (fb >= 0)) continue;
    const double share = fa / (fa - fb);
    kept.add({a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)});
  }
  return kept;
}

double common_area(const Polygon& box, const Polygon& quad) {
  const double side = doubled_area(quad) > 0 ? 1 : -1;
  Polygon rest = box;
  for (std::size_t i = 0; i < 4 && rest.size > 0; ++i) {
    rest = cut(rest, quad.corners[i], quad.corners[(i + 1) % 4], side);
  }
  return std::fabs(doubled_area(rest)) / 2;
}

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

}  // namespace

double out_of_bounds_share(const Road& road, const VehicleState& state,
                           const VehicleParameters& parameters, std::size_t near) {
  const Polygon box = box_of(state, parameters);
  const std::size_t first = near > kReach ? near - kReach : 0;
  const std::size_t last = std::min(road.middle.size() - 1, near + kReach);
  const double reach = std::hypot(parameters.length_m, parameters.width_m) / 2;
  double inside = 0;
  for (std::size_t i = first; i < last; ++i) {
    // A stretch that the car cannot touch has nothing in common with it.
    const Point centre{(road.middle[i].x_m + road.right[i + 1].x_m) / 2,
                       (road.middle[i].y_m + road.right[i + 1].y_m) / 2};
    const double far =
        reach + std::max({distance(centre, road.middle[i]), distance(centre, road.middle[i + 1]),
                          distance(centre, road.right[i])});
    const double dx = centre.x_m - state.x_m;
    const double dy = centre.y_m - state.y_m;
    if (dx * dx + dy * dy > far * far) continue;
    Polygon stretch;
    for (const Point& corner :
         {road.middle[i], road.middle[i + 1], road.right[i + 1], road.right[i]}) {
      stretch.add(corner);
    }
    inside += common_area(box, stretch);
  }
  return std::max(0.0, 1 - inside / (parameters.length_m * parameters.width_m));
}

}  // namespace jaywalk::lane
