// SPDX-License-Identifier: Apache-2.0
#pragma once

// A line to be followed: arc length, heading and curvature of each of its points, and which of them
// is nearest to a car that moves along it. Metres, radians. Read road.h first.

#include <cstddef>
#include <vector>

#include "env/lane/road.h"

namespace jaywalk::lane {

class Path {
 public:
  /// REQUIRES: at least two points, no two neighbours the same.
  explicit Path(Polyline points);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Point& point(std::size_t i) const { return points_[i]; }
  /// From the beginning.
  [[nodiscard]] double arc_m(std::size_t i) const { return arcs_[i]; }
  [[nodiscard]] double heading(std::size_t i) const { return headings_[i]; }
  /// In 1/m, over two points to each side; positive to the left.
  [[nodiscard]] double curvature(std::size_t i) const { return curvatures_[i]; }

  /// The local minimum of the distance to a point, sought from `from` on.
  [[nodiscard]] std::size_t nearest(const Point& point, std::size_t from) const;
  /// The first point that is at least that far ahead of `from`, or the last one.
  [[nodiscard]] std::size_t ahead(std::size_t from, double metres) const;
  /// The distance of a point from the line's stretches around point `near`.
  [[nodiscard]] double distance_m(const Point& point, std::size_t near) const;

 private:
  Polyline points_;
  std::vector<double> arcs_;
  std::vector<double> headings_;
  std::vector<double> curvatures_;
};

/// The same angle from -pi to pi.
[[nodiscard]] double wrapped(double angle);

}  // namespace jaywalk::lane
