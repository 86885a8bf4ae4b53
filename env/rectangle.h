#pragma once

// Rectangles along the axes of the world (scene.h): boxes of road users, obstacles, crosswalks.

#include <algorithm>
#include <span>

#include "env/scene.h"

namespace jaywalk {

/// In metres.
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
