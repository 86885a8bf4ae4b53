// SPDX-License-Identifier: Apache-2.0
#pragma once

// The plane geometry that the validity of a road needs: whether segments touch, whether the area of
// a road overlaps itself. All tests are those of the sign of an area, without tolerances.

#include <array>
#include <span>

#include "env/lane/road.h"

namespace jaywalk::lane {

using Quad = std::array<Point, 4>;

/// Twice the signed area of the triangle; positive if it is counter-clockwise.
[[nodiscard]] double cross(const Point& origin, const Point& a, const Point& b);
/// Whether two segments have a point in common.
[[nodiscard]] bool segments_touch(const Point& a, const Point& b, const Point& c, const Point& d);
/// Whether a point lies in a polygon, by the parity of crossings.
[[nodiscard]] bool contains(std::span<const Point> polygon, const Point& point);
/// A quadrilateral whose sides do not cross and which has an area.
[[nodiscard]] bool is_simple(const Quad& quad);

/// Whether the road's area, cut into a quadrilateral for each stretch of its middle line, overlaps
/// itself: each must be simple, neighbours share their common side alone, others nothing.
[[nodiscard]] bool overlaps_itself(const Road& road);

/// The road's outline: the left border, then the right one back.
[[nodiscard]] Polyline outline(const Road& road);

}  // namespace jaywalk::lane
