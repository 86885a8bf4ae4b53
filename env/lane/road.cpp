// SPDX-License-Identifier: Apache-2.0
#include "env/lane/road.h"

#include <algorithm>
#include <cmath>

#include "env/lane/spline.h"

namespace jaywalk::lane {
namespace {

constexpr double kLeastSteps = 20;
/// Interpolated points of one road; the map holds some hundred metres.
constexpr double kMostSteps = 100'000;

/// As numpy.round(value, 3).
double to_millimetres(double value) { return std::rint(value * 1000) / 1000; }

struct Border {
  Point left;
  Point right;
};

/// The borders beside `from`, seen in the direction of `to`.
Border borders(const Point& from, const Point& to) {
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const double norm = std::sqrt(dx * dx + dy * dy);
  const double vx = dx / norm * kRoadWidth / 2;
  const double vy = dy / norm * kRoadWidth / 2;
  return {{from.x_m - vy, from.y_m + vx}, {from.x_m + vy, from.y_m - vx}};
}

}  // namespace

double distance(const Point& from, const Point& to) {
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  return std::sqrt(dx * dx + dy * dy);
}

double length(std::span<const Point> line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

Polyline integrate(std::span<const double> curvatures, const CurvatureFrame& frame) {
  Polyline points{frame.start};
  double heading = frame.heading_rad;
  const auto advance = [&] {
    points.push_back({points.back().x_m + frame.step_m * std::cos(heading),
                      points.back().y_m + frame.step_m * std::sin(heading)});
  };
  advance();
  for (std::size_t i = 0; i + 1 < curvatures.size(); ++i) {
    heading += frame.step_m * (curvatures[i + 1] + curvatures[i]) / 2;
    advance();
  }
  return points;
}

std::optional<Polyline> fit_into_map(Polyline points, double map_m, double margin_m) {
  if (points.empty()) return std::nullopt;
  Point least = points.front();
  Point most = points.front();
  for (const Point& point : points) {
    least = {std::min(least.x_m, point.x_m), std::min(least.y_m, point.y_m)};
    most = {std::max(most.x_m, point.x_m), std::max(most.y_m, point.y_m)};
  }
  const double room = map_m - 2 * margin_m;
  if (!(most.x_m - least.x_m <= room && most.y_m - least.y_m <= room)) return std::nullopt;
  for (Point& point : points) {
    point.x_m += margin_m - least.x_m;
    point.y_m += margin_m - least.y_m;
  }
  return points;
}

std::optional<Polyline> interpolate(std::span<const Point> points) {
  const std::optional<Spline> spline = Spline::through(points);
  const double metres = length(points);
  if (!spline || !(metres < kMostSteps)) return std::nullopt;
  const double steps = std::max(kLeastSteps, std::trunc(metres));
  // numpy.arange(0, 1 + 1/n, 1/n): rounding sometimes adds a point beyond 1.
  const double step = 1.0 / steps;
  const double stop = 1 + step;
  const auto count = static_cast<std::size_t>(std::ceil(stop / step));
  Polyline line;
  line.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point point = spline->at(static_cast<double>(i) * step);
    line.push_back({to_millimetres(point.x_m), to_millimetres(point.y_m)});
  }
  return line;
}

std::optional<Road> make_road(Polyline points) {
  std::optional<Polyline> middle = interpolate(points);
  if (!middle) return std::nullopt;
  return road_along(std::move(points), std::move(*middle));
}

Road road_along(Polyline points, Polyline middle) {
  Road road{std::move(points), std::move(middle), {}, {}};
  road.left.reserve(road.middle.size());
  road.right.reserve(road.middle.size());
  for (std::size_t i = 0; i + 1 < road.middle.size(); ++i) {
    const Border border = borders(road.middle[i], road.middle[i + 1]);
    road.left.push_back(border.left);
    road.right.push_back(border.right);
  }
  // The last point has no successor: seen from it, its predecessor's left is on the right.
  const Border last = borders(road.middle.back(), road.middle[road.middle.size() - 2]);
  road.left.push_back(last.right);
  road.right.push_back(last.left);
  return road;
}

Polyline lane_centre(const Road& road) {
  Polyline line;
  line.reserve(road.middle.size());
  for (std::size_t i = 0; i < road.middle.size(); ++i) {
    line.push_back({(road.middle[i].x_m + road.right[i].x_m) / 2,
                    (road.middle[i].y_m + road.right[i].y_m) / 2});
  }
  return line;
}

}  // namespace jaywalk::lane
