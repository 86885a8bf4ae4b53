// SPDX-License-Identifier: Apache-2.0
#pragma once

// The ground that a test takes place on, in metres: lanes and pavements as areas, and what stands
// or is marked on them. The axes are those of scene.h. Metrics and assertions use it to find which
// actors are on the road or in a lane, and what a driver can see.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/grid/grid.h"
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

/// The kinds of the cells of the ground.
enum class Surface : unsigned char { pavement, lane, crosswalk, blocked };

/// `pavement`, `lane`, `crosswalk` or `blocked`.
[[nodiscard]] std::string_view name(Surface ground);

/// Some rows of one kind. Of a map, what its rows begin with.
struct PlanBand {
  AreaKind kind = AreaKind::pavement;
  int rows = 1;
  /// Which way traffic goes in a lane, forward or back.
  Direction direction = Direction::forward;
};

/// The ground as cells, for pictures and pages. Rows count from the AV's left, cells along its way.
struct GroundPlan {
  Grid grid;
  /// The side of a cell, in metres.
  double cell_m = 1;
  std::vector<PlanBand> bands;
  /// It is a map, so that bands say nothing of cells behind the first.
  bool is_drawn = false;
  /// Row by row.
  std::vector<Surface> cells;

  /// REQUIRES: the position lies on the grid.
  [[nodiscard]] Surface at(Position position) const {
    return cells[static_cast<std::size_t>(position.x) * static_cast<std::size_t>(grid.cells) +
                 static_cast<std::size_t>(position.y)];
  }
  [[nodiscard]] double length_m() const { return grid.cells * cell_m; }
  [[nodiscard]] double breadth_m() const { return grid.rows * cell_m; }
  /// REQUIRES: the row is on the grid.
  [[nodiscard]] const PlanBand& band_of(int row) const;
};

}  // namespace jaywalk
