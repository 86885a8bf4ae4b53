// SPDX-License-Identifier: Apache-2.0
#pragma once

// Roads of the SBST/SBFT CPS competition: two lanes of 4 m, drawn through a few points; cars drive
// in the right lane. Metres, radians; angles count counter-clockwise from x. Read spline.h before,
// validity.h next.

#include <optional>
#include <span>
#include <vector>

#include "env/scene.h"

namespace jaywalk::lane {

/// A line through points.
using Polyline = std::vector<Point>;

inline constexpr double kRoadWidth = 8;
inline constexpr double kLaneWidth = 4;

/// Where a road that is given by its curvatures begins and how far apart its points are.
struct CurvatureFrame {
  double step_m = 15;
  Point start{100, 10};
  double heading_rad = 1.5707963267948966;
};

[[nodiscard]] double distance(const Point& from, const Point& to);
[[nodiscard]] double length(std::span<const Point> line);

/// Points of a road from its curvatures (1/m), one point more than curvatures: the first stretch is
/// straight, then the heading turns by the step times the mean of two neighbouring curvatures
/// (Peltomäki et al. 2022, section 2.1; the first heading is the frame's).
[[nodiscard]] Polyline integrate(std::span<const double> curvatures,
                                 const CurvatureFrame& frame = {});

/// The same points, moved so that their box begins at (margin, margin); none if the box does not
/// fit into a square map with that margin.
[[nodiscard]] std::optional<Polyline> fit_into_map(Polyline points, double map_m,
                                                   double margin_m = 10);

/// About a point a metre along the spline, at least 20 steps, rounded to millimetres. None if there
/// is no spline through the points.
[[nodiscard]] std::optional<Polyline> interpolate(std::span<const Point> points);

/// A road that can be driven on: the points it was made from, its middle line and its borders. All
/// three lines have as many points.
struct Road {
  Polyline points;
  Polyline middle;
  Polyline left;
  Polyline right;
};

[[nodiscard]] std::optional<Road> make_road(Polyline points);
/// The road of an interpolation that is there already. REQUIRES: two points of it.
[[nodiscard]] Road road_along(Polyline points, Polyline middle);

/// The middle line of the right lane.
[[nodiscard]] Polyline lane_centre(const Road& road);

}  // namespace jaywalk::lane
