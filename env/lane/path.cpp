// SPDX-License-Identifier: Apache-2.0
#include "env/lane/path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jaywalk::lane {
namespace {

constexpr std::size_t kCurvatureReach = 2;
constexpr std::size_t kDistanceReach = 3;

double squared(const Point& a, const Point& b) {
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return dx * dx + dy * dy;
}

double distance_to_segment(const Point& from, const Point& to, const Point& point) {
  const double ex = to.x_m - from.x_m;
  const double ey = to.y_m - from.y_m;
  const double along =
      ((point.x_m - from.x_m) * ex + (point.y_m - from.y_m) * ey) / (ex * ex + ey * ey);
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(from.x_m + share * ex - point.x_m, from.y_m + share * ey - point.y_m);
}

}  // namespace

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

Path::Path(Polyline points)
    : points_(std::move(points)),
      arcs_(points_.size()),
      headings_(points_.size()),
      curvatures_(points_.size()) {
  const std::size_t n = points_.size();
  for (std::size_t i = 1; i < n; ++i) {
    arcs_[i] = arcs_[i - 1] + lane::distance(points_[i - 1], points_[i]);
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    headings_[i] =
        std::atan2(points_[i + 1].y_m - points_[i].y_m, points_[i + 1].x_m - points_[i].x_m);
  }
  headings_[n - 1] = headings_[n - 2];
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = i > kCurvatureReach ? i - kCurvatureReach : 0;
    const std::size_t last = std::min(n - 2, i + kCurvatureReach);
    if (last > first && arcs_[last] > arcs_[first]) {
      curvatures_[i] = wrapped(headings_[last] - headings_[first]) / (arcs_[last] - arcs_[first]);
    }
  }
}

std::size_t Path::nearest(const Point& point, std::size_t from) const {
  std::size_t near = from;
  const auto distance2 = [&](std::size_t i) { return squared(points_[i], point); };
  while (near + 1 < size() && distance2(near + 1) <= distance2(near)) ++near;
  while (near > 0 && distance2(near - 1) < distance2(near)) --near;
  return near;
}

std::size_t Path::ahead(std::size_t from, double metres) const {
  std::size_t i = from;
  while (i + 1 < size() && arcs_[i] - arcs_[from] < metres) ++i;
  return i;
}

double Path::distance_m(const Point& point, std::size_t near) const {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t first = near > kDistanceReach ? near - kDistanceReach : 0;
  const std::size_t last = std::min(size() - 1, near + kDistanceReach);
  for (std::size_t i = first; i < last; ++i) {
    least = std::min(least, distance_to_segment(points_[i], points_[i + 1], point));
  }
  return least;
}

}  // namespace jaywalk::lane
