#pragma once

// The ground that a test takes place on, in metres: lanes and pavements as areas. The axes are
// those of scene.h. What is measured and judged asks it who is on the road and who keeps its lane.

#include <vector>

#include "env/scene.h"

namespace jaywalk {

struct CrossingParameters;

enum class AreaKind { pavement, lane };

/// A convex polygon, counter-clockwise.
struct Area {
  AreaKind kind = AreaKind::pavement;
  std::vector<Point> corners;
  /// The lane in which the automated vehicle (AV) drives.
  bool of_av = false;
};

struct Ground {
  std::vector<Area> areas;

  /// Null if the AV drives outside all lanes.
  [[nodiscard]] const Area* av_lane() const;
};

/// The bands of the crossing world, as far as its road goes; of a map the stretches of its rows,
/// and its AV's lane over them. REQUIRES: parameters without problems().
[[nodiscard]] Ground ground(const CrossingParameters& parameters);

/// The point is in the area or on its edge.
[[nodiscard]] bool contains(const Area& area, Point point);

}  // namespace jaywalk
