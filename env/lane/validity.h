// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which roads the SBST/SBFT CPS competition accepts, with its own messages and its own oddities.
// After code_pipeline/validation.py and self_driving/road_polygon.py of its pipeline. Read road.h
// before.

#include <optional>
#include <string_view>

#include "env/lane/road.h"

namespace jaywalk::lane {

struct RoadRules {
  /// The side of the square map.
  double map_m = 200;
  std::size_t most_points = 500;
  double least_length_m = 20;
  /// In feet, as the competition has it: 14.3256 m.
  double least_radius_ft = 47;

  friend bool operator==(const RoadRules&, const RoadRules&) = default;
};

inline constexpr std::string_view kLeavesMap = "Not entirely inside the map boundaries";

struct RoadVerdict {
  /// Why the road is invalid, in the competition's words; empty if it is valid.
  std::string_view message;
  /// Present if a spline goes through the points, valid or not.
  std::optional<Road> road;

  [[nodiscard]] bool valid() const { return message.empty(); }
};

/// The rules are applied in the competition's order; the first one broken gives the message.
[[nodiscard]] RoadVerdict validate(Polyline points, const RoadRules& rules = {});

/// Whether validate() has no objection; faster than finding the first objection.
[[nodiscard]] bool is_valid(Polyline points, const RoadRules& rules = {});

/// The smallest radius of a circle through every other of five neighbouring points, in metres;
/// 0 if the road is straight. As in the competition, the last five are left out.
[[nodiscard]] double least_radius_m(std::span<const Point> line);

}  // namespace jaywalk::lane
