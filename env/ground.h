#pragma once

// The ground that a test takes place on, in metres: lanes and pavements as areas, and what stands
// or is marked on them. The axes are those of scene.h. Metrics and assertions use it to find which
// actors are on the road or in a lane, and what a driver can see.

#include <optional>
#include <string>
#include <vector>

#include "env/rectangle.h"
#include "env/scene.h"

namespace jaywalk {

enum class AreaKind { pavement, lane };

/// A convex polygon, counter-clockwise.
struct Area {
  AreaKind kind = AreaKind::pavement;
  std::vector<Point> corners;
  /// The lane in which the automated vehicle (AV) drives.
  bool of_av = false;
};

/// A crosswalk: vehicles stop before it while it is closed to them.
struct GroundCrosswalk {
  /// It is closed while a pedestrian's middle is in one of `parts`; else while a signal is not
  /// green.
  bool zebra = true;
  /// The areas of lanes that it covers, and the y at which it begins.
  std::vector<Rectangle> parts;
  double begins_m = 0;
  /// The names of the actors that are its signals.
  std::vector<std::string> signals;
};

struct Ground {
  std::vector<Area> areas;
  /// Objects that hide actors behind them.
  std::vector<Rectangle> obstacles;
  std::vector<GroundCrosswalk> crosswalks;
  /// The speed at which the AV drives there while nothing is in its way; empty if that is not
  /// known.
  std::optional<double> cruise_mps;
  /// From tick to tick road users go evenly from one place to the next; if not, all of a tick's
  /// move is made when it begins.
  bool moves_evenly = false;

  /// Null if the AV drives outside all lanes.
  [[nodiscard]] const Area* av_lane() const;
};

/// The point is in the area or on its edge.
[[nodiscard]] bool contains(const Area& area, Point point);

}  // namespace jaywalk
