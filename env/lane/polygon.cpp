// SPDX-License-Identifier: Apache-2.0
#include "env/lane/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace jaywalk::lane {
namespace {

/// Whether a point on the line through a and b lies between them.
bool lies_between(const Point& a, const Point& b, const Point& point) {
  return std::min(a.x_m, b.x_m) <= point.x_m && point.x_m <= std::max(a.x_m, b.x_m) &&
         std::min(a.y_m, b.y_m) <= point.y_m && point.y_m <= std::max(a.y_m, b.y_m);
}

bool opposite(double a, double b) { return (a > 0) != (b > 0) && a != 0 && b != 0; }

struct Box {
  double left, right, bottom, top;
};

Box box_of(const Quad& quad) {
  const auto [x0, x1] = std::minmax({quad[0].x_m, quad[1].x_m, quad[2].x_m, quad[3].x_m});
  const auto [y0, y1] = std::minmax({quad[0].y_m, quad[1].y_m, quad[2].y_m, quad[3].y_m});
  return {x0, x1, y0, y1};
}

bool apart(const Box& a, const Box& b) {
  return a.right < b.left || b.right < a.left || a.top < b.bottom || b.top < a.bottom;
}

const Point& corner(const Quad& quad, std::size_t i) { return quad[i % 4]; }

/// Whether the line from one point to another has both of `own` on one side and the other
/// quadrilateral on the other one, by more than rounding.
bool parts(const Point& from, const Point& to, std::span<const Point, 2> own, const Quad& other) {
  constexpr double kCertain = 1e-6;
  const double sign = cross(from, to, own[0]) > 0 ? 1 : -1;
  return std::ranges::all_of(own, [&](const Point& p) { return sign * cross(from, to, p) > 0; }) &&
         std::ranges::all_of(other,
                             [&](const Point& p) { return sign * cross(from, to, p) < -kCertain; });
}

/// Whether the far side of the first or the near side of the second lies between them: so it is
/// with most of those that are near each other on a road.
bool parted(const Quad& a, const Quad& b) {
  return parts(a[1], a[2], std::array{a[0], a[3]}, b) ||
         parts(b[0], b[3], std::array{b[1], b[2]}, a);
}

bool touch(const Quad& a, const Quad& b) {
  if (parted(a, b)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (segments_touch(corner(a, i), corner(a, i + 1), corner(b, j), corner(b, j + 1))) {
        return true;
      }
    }
  }
  // No sides touch: one of them may lie within the other as a whole.
  return contains(a, b[0]) || contains(b, a[0]);
}

/// Whether two neighbours, which share the side from a[1] to a[2] = b[0] to b[3], have more than it
/// in common.
bool neighbours_overlap(const Quad& a, const Quad& b) {
  const Point& left = a[1];
  const Point& right = a[2];
  const double a0 = cross(left, right, a[0]);
  const double a3 = cross(left, right, a[3]);
  const double b1 = cross(left, right, b[1]);
  const double b2 = cross(left, right, b[2]);
  const bool on_both_sides =
      (a0 > 0 && a3 > 0 && b1 < 0 && b2 < 0) || (a0 < 0 && a3 < 0 && b1 > 0 && b2 > 0);
  if (on_both_sides) return false;
  if (contains(a, b[1]) || contains(a, b[2]) || contains(b, a[0]) || contains(b, a[3])) return true;
  return segments_touch(a[0], a[1], b[1], b[2]) || segments_touch(a[0], a[1], b[2], b[3]) ||
         segments_touch(a[3], a[0], b[0], b[1]) || segments_touch(a[3], a[0], b[1], b[2]) ||
         segments_touch(a[3], a[0], b[2], b[3]) || segments_touch(a[2], a[3], b[0], b[1]) ||
         segments_touch(a[2], a[3], b[1], b[2]);
}

/// Whether two quadrilaterals that are no neighbours touch. From one to the next, a quadrilateral
/// moves by a piece of the middle line at most; where two are far apart, as many as that takes to
/// come near are passed over.
bool others_touch(const Road& road, std::span<const Quad> quads, std::span<const Box> boxes) {
  double longest = 0;
  double reach = 0;  // of a quadrilateral, from the middle line's point
  for (std::size_t i = 0; i < quads.size(); ++i) {
    longest = std::max(longest, distance(road.middle[i], road.middle[i + 1]));
    for (const Point& each : quads[i]) reach = std::max(reach, distance(road.middle[i], each));
  }
  constexpr double kSafety = 1.001;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    for (std::size_t j = i + 2; j < quads.size();) {
      if (!apart(boxes[i], boxes[j]) && touch(quads[i], quads[j])) return true;
      const double gap = distance(road.middle[i], road.middle[j]) - kSafety * 2 * reach;
      j += 1 + static_cast<std::size_t>(std::max(0.0, gap / (kSafety * longest) - 1));
    }
  }
  return false;
}

}  // namespace

double cross(const Point& origin, const Point& a, const Point& b) {
  return (a.x_m - origin.x_m) * (b.y_m - origin.y_m) - (a.y_m - origin.y_m) * (b.x_m - origin.x_m);
}

bool segments_touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double abc = cross(a, b, c);
  const double abd = cross(a, b, d);
  const double cda = cross(c, d, a);
  const double cdb = cross(c, d, b);
  if (opposite(abc, abd) && opposite(cda, cdb)) return true;
  return (abc == 0 && lies_between(a, b, c)) || (abd == 0 && lies_between(a, b, d)) ||
         (cda == 0 && lies_between(c, d, a)) || (cdb == 0 && lies_between(c, d, b));
}

bool contains(std::span<const Point> polygon, const Point& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point& a = polygon[i];
    const Point& b = polygon[j];
    // A ray to the right crosses an odd number of sides from within.
    if ((a.y_m > point.y_m) != (b.y_m > point.y_m) &&
        point.x_m < (b.x_m - a.x_m) * (point.y_m - a.y_m) / (b.y_m - a.y_m) + a.x_m) {
      inside = !inside;
    }
  }
  return inside;
}

bool is_simple(const Quad& quad) {
  return !segments_touch(quad[0], quad[1], quad[2], quad[3]) &&
         !segments_touch(quad[1], quad[2], quad[3], quad[0]) &&
         std::fabs(cross(quad[0], quad[1], quad[2]) + cross(quad[0], quad[2], quad[3])) > 0;
}

bool overlaps_itself(const Road& road) {
  std::vector<Quad> quads;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < road.left.size(); ++i) {
    quads.push_back({road.left[i], road.left[i + 1], road.right[i + 1], road.right[i]});
    if (!is_simple(quads.back())) return true;
    boxes.push_back(box_of(quads.back()));
  }
  for (std::size_t i = 0; i + 1 < quads.size(); ++i) {
    if (neighbours_overlap(quads[i], quads[i + 1])) return true;
  }
  return others_touch(road, quads, boxes);
}

Polyline outline(const Road& road) {
  Polyline ring = road.left;
  ring.insert(ring.end(), road.right.rbegin(), road.right.rend());
  return ring;
}

}  // namespace jaywalk::lane
