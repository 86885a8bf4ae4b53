// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/signals/boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jaywalk {
namespace {

Span1D projected(std::span<const Point> polygon, Vector axis) {
  Span1D result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Point& point : polygon) {
    const double at = point.x_m * axis.x + point.y_m * axis.y;
    result.from = std::min(result.from, at);
    result.to = std::max(result.to, at);
  }
  return result;
}

/// Cuts `times` down to those at which the projections on the axis touch; false if none is left.
bool cut(Span1D fixed, Span1D moving, double speed, Span1D& times) {
  if (speed == 0) return moving.from <= fixed.to && moving.to >= fixed.from;
  double enter = (fixed.from - moving.to) / speed;
  double leave = (fixed.to - moving.from) / speed;
  if (enter > leave) std::swap(enter, leave);
  times.from = std::max(times.from, enter);
  times.to = std::min(times.to, leave);
  return times.from <= times.to;
}

bool cut_by_edges(std::span<const Point> edges, std::span<const Point> fixed,
                  std::span<const Point> moving, Vector velocity, Span1D& times) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vector edge = edges[(i + 1) % edges.size()] - edges[i];
    if (edge.x == 0 && edge.y == 0) continue;
    const Vector axis{-edge.y, edge.x};
    if (!cut(projected(fixed, axis), projected(moving, axis), dot(axis, velocity), times)) {
      return false;
    }
  }
  return true;
}

/// Seen from the one, the way of the other.
Vector relative(const Movement& its_step, const Movement& step) {
  return displacement(step.from, step.to) - displacement(its_step.from, its_step.to);
}

/// From its middle to a corner.
double radius_m(const Actor& actor) { return std::hypot(actor.length_m, actor.width_m) / 2; }

/// The largest rounding error at places that are kilometres from the origin.
constexpr double kRoundingM = 1e-6;

}  // namespace

Vector heading(const ActorState& state) {
  return {std::cos(state.heading_rad), std::sin(state.heading_rad)};
}

Vector velocity(const ActorState& state) {
  const Vector ahead = heading(state);
  return {ahead.x * state.speed_mps, ahead.y * state.speed_mps};
}

Vector displacement(const ActorState& from, const ActorState& to) {
  return {to.x_m - from.x_m, to.y_m - from.y_m};
}

std::optional<Span1D> contact(std::span<const Point> fixed, std::span<const Point> moving,
                              Vector velocity, Span1D within) {
  Span1D times = within;
  if (!cut_by_edges(fixed, fixed, moving, velocity, times) ||
      !cut_by_edges(moving, fixed, moving, velocity, times)) {
    return std::nullopt;
  }
  return times;
}

double closest_m(const Actor& fixed, const Movement& its_step, const Actor& moving,
                 const Movement& step) {
  const auto begin = [](Movement each) {
    each.from.heading_rad = each.to.heading_rad;
    return each.from;
  };
  // Seen from the first box the other covers a convex polygon.
  return distance_m(box(fixed, begin(its_step)),
                    swept(box(moving, begin(step)), relative(its_step, step)));
}

bool touch(const Actor& fixed, const Movement& its_step, const Actor& moving,
           const Movement& step) {
  const Vector way = relative(its_step, step);
  const Vector apart = displacement(its_step.from, step.from);
  const double reach = radius_m(fixed) + radius_m(moving) + std::hypot(way.x, way.y) + kRoundingM;
  if (dot(apart, apart) > reach * reach) return false;
  return closest_m(fixed, its_step, moving, step) <= 0;
}

std::vector<Point> convex_hull(std::vector<Point> points) {
  // Andrew's monotone chain.
  std::ranges::sort(
      points, [](Point a, Point b) { return a.x_m < b.x_m || (a.x_m == b.x_m && a.y_m < b.y_m); });
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto add = [&](Point point, std::size_t base) {
    while (hull.size() >= base + 2 &&
           cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Point& point : points) add(point, 0);
  const std::size_t upper = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], upper);
  hull.pop_back();
  return hull;
}

std::vector<Point> swept(std::span<const Point> polygon, Vector way) {
  std::vector<Point> points(polygon.begin(), polygon.end());
  for (const Point& point : polygon) points.push_back({point.x_m + way.x, point.y_m + way.y});
  return convex_hull(std::move(points));
}

}  // namespace jaywalk
