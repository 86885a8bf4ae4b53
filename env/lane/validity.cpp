// SPDX-License-Identifier: Apache-2.0
#include "env/lane/validity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "env/lane/polygon.h"

namespace jaywalk::lane {
namespace {

constexpr double kFeetPerMetre = 3.280839895;
constexpr std::size_t kWindow = 5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Radius of the circle through three points; infinite if they lie on a line.
double radius(const Point& a, const Point& b, const Point& c) {
  const double b2 = b.x_m * b.x_m + b.y_m * b.y_m;
  const double ab = (a.x_m * a.x_m + a.y_m * a.y_m - b2) / 2;
  const double bc = (b2 - c.x_m * c.x_m - c.y_m * c.y_m) / 2;
  const double det = (a.x_m - b.x_m) * (b.y_m - c.y_m) - (b.x_m - c.x_m) * (a.y_m - b.y_m);
  if (std::fabs(det) < 1e-6) return kInfinity;
  const double x = (ab * (b.y_m - c.y_m) - bc * (a.y_m - b.y_m)) / det;
  const double y = ((a.x_m - b.x_m) * bc - (b.x_m - c.x_m) * ab) / det;
  return std::sqrt((x - a.x_m) * (x - a.x_m) + (y - a.y_m) * (y - a.y_m));
}

/// The competition's is_inside_map, in which `and` binds more tightly than its authors meant: a
/// road that lies altogether right of or above the map passes.
bool passes_bounds(std::span<const Point> line, double map) {
  double x0 = kInfinity;
  double x1 = -kInfinity;
  double y0 = kInfinity;
  double y1 = -kInfinity;
  for (const Point& point : line) {
    x0 = std::min(x0, point.x_m);
    x1 = std::max(x1, point.x_m);
    y0 = std::min(y0, point.y_m);
    y1 = std::max(y1, point.y_m);
  }
  return 0 < x0 || (x0 > map && 0 < x1) || (x1 > map && 0 < y0) || (y0 > map && 0 < y1) || y1 > map;
}

/// Whether the outline touches the map's boundary or has the map's corner within.
bool touches_boundary(const Road& road, double map) {
  const Polyline ring = outline(road);
  // A road that lies strictly inside, as most do, touches no border.
  if (std::ranges::all_of(ring, [map](const Point& point) {
        return 0 < point.x_m && point.x_m < map && 0 < point.y_m && point.y_m < map;
      })) {
    return false;
  }
  const Quad square{Point{map, 0}, Point{map, map}, Point{0, map}, Point{0, 0}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& next = ring[(i + 1) % ring.size()];
    for (std::size_t j = 0; j < 4; ++j) {
      if (segments_touch(ring[i], next, square[j], square[(j + 1) % 4])) return true;
    }
  }
  return contains(ring, square[0]);
}

/// Whether the line's interpolation is longer than this for certain: it goes from the line's first
/// point to its last.
bool interpolation_exceeds(const Polyline& line, double metres) {
  constexpr double kRounding_m = 0.01;
  constexpr double kFew_m = 10'000;
  const auto same = [](const Point& a, const Point& b) { return distance(a, b) == 0; };
  return distance(line.front(), line.back()) > metres + kRounding_m && length(line) < kFew_m &&
         std::ranges::adjacent_find(line, same) == line.end();
}

/// The competition measures the length of the interpolation's interpolation.
std::string_view length_problem(const Polyline& middle, const RoadRules& rules) {
  if (interpolation_exceeds(middle, rules.least_length_m)) return {};
  const std::optional<Polyline> twice = interpolate(middle);
  if (!twice) return "ERROR ValueError: Invalid inputs.";
  return length(*twice) > rules.least_length_m ? "" : "The road is not long enough.";
}

bool is_too_sharp(const Polyline& middle, const RoadRules& rules) {
  const double feet = least_radius_m(middle) * kFeetPerMetre;
  return feet > 0 && feet < rules.least_radius_ft;
}

std::string_view problem(const Road& road, const RoadRules& rules) {
  if (road.points.size() > rules.most_points) {
    return "The road definition contains too many points";
  }
  if (!passes_bounds(road.middle, rules.map_m) || touches_boundary(road, rules.map_m)) {
    return kLeavesMap;
  }
  if (overlaps_itself(road)) return "The road is self-intersecting";
  if (const std::string_view message = length_problem(road.middle, rules); !message.empty()) {
    return message;
  }
  return is_too_sharp(road.middle, rules) ? "The road is too sharp" : "";
}

}  // namespace

double least_radius_m(std::span<const Point> line) {
  double least = kInfinity;
  for (std::size_t i = 0; i + kWindow < line.size(); ++i) {
    least = std::min(least, radius(line[i], line[i + 2], line[i + 4]));
  }
  return least == kInfinity ? 0 : least;
}

RoadVerdict validate(Polyline points, const RoadRules& rules) {
  if (points.size() < 2) return {.message = "Not enough road points."};
  std::optional<Road> road = make_road(std::move(points));
  if (!road) return {.message = "ERROR ValueError: Invalid inputs."};
  const std::string_view message = problem(*road, rules);
  return {.message = message, .road = std::move(road)};
}

bool is_valid(Polyline points, const RoadRules& rules) {
  if (points.size() < 2 || points.size() > rules.most_points) return false;
  std::optional<Polyline> middle = interpolate(points);
  if (!middle || is_too_sharp(*middle, rules) || !passes_bounds(*middle, rules.map_m)) return false;
  const Road road = road_along(std::move(points), std::move(*middle));
  return !touches_boundary(road, rules.map_m) && !overlaps_itself(road) &&
         length_problem(road.middle, rules).empty();
}

}  // namespace jaywalk::lane
