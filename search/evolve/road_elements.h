// SPDX-License-Identifier: Apache-2.0
#pragma once

// Roads of straight pieces and turns, and a simplified car that drives on them: what AmbieGen
// (ambiegen.cpp) evolves and judges by. Read env/lane/road.h first.

#include <span>
#include <vector>

#include "env/lane/road.h"
#include "search/test_input.h"

namespace jaywalk::search {

/// A piece of road: straight for some metres, or a turn by some degrees on a circle of 20 m.
struct RoadElement {
  enum class Kind { straight, right, left };

  Kind kind = Kind::straight;
  double value = 0;

  friend bool operator==(const RoadElement&, const RoadElement&) = default;
};
using RoadElements = std::vector<RoadElement>;

/// A kind by chance with a value by chance: whole, 5 to 30 m or 10 to 85 degrees.
[[nodiscard]] RoadElement draw_element(Random& random);
/// Draws an element of another kind.
[[nodiscard]] RoadElement draw_other(const RoadElement& element, Random& random);

/// The points where the elements begin and end, from the middle of the map upwards, as far as they
/// stay inside of it.
[[nodiscard]] lane::Polyline element_points(std::span<const RoadElement> elements, double map_m);

/// How far a simplified car leaves the road's middle line at most, in metres: it goes straight on
/// and faster as long as it is within a metre of the line, else it steers back by an angle that
/// grows with the distance, and slower. It begins at the road's start and once more in its middle.
/// 0 if no road goes through the points.
[[nodiscard]] double simplified_deviation_m(std::span<const Point> points);

/// How different two roads are: the share of places at which their elements are of different kinds
/// or differ by more than 10 in value, half as much. 0 to 1.
[[nodiscard]] double difference(std::span<const RoadElement> a, std::span<const RoadElement> b);

}  // namespace jaywalk::search
