#pragma once

// The ground of a world as cells, for pictures and pages: the kind of each cell, and the bands
// along the road. Rows count from the automated vehicle's (AV's) left, cells along its way. Metrics
// and assertions use env/ground.h instead, which is in metres.

#include <string_view>
#include <vector>

#include "env/grid/grid.h"
#include "env/ground.h"

namespace jaywalk {

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
