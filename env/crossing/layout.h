// SPDX-License-Identifier: Apache-2.0
#pragma once

// The ground of a crossing world, cell by cell: from bands along the road, or from a map drawn with
// letters, with crosswalks and obstacles laid over it.
//
//   .  pavement          >  lane, forward     <  lane, back
//   x  junction: road that lanes share        #  blocked: a building, a wall
//
// A map has a line for each row, from the AV's left to its right, and a letter for each cell.

#include <optional>
#include <string_view>
#include <vector>

#include "env/crossing/parameters.h"
#include "env/ground.h"
#include "env/scene.h"

namespace jaywalk {

class Layout {
 public:
  /// REQUIRES: parameters without problems().
  explicit Layout(const CrossingParameters& parameters);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// REQUIRES: the position lies on the grid.
  [[nodiscard]] Surface at(Position position) const {
    const auto row = static_cast<std::size_t>(position.x);
    if (cells_.empty()) return rows_[row];
    return cells_[row * static_cast<std::size_t>(grid_.cells) +
                  static_cast<std::size_t>(position.y)];
  }
  [[nodiscard]] bool is_road(Position position) const {
    const Surface ground = at(position);
    return ground == Surface::lane || ground == Surface::crosswalk;
  }
  /// Whether a body can be there: the position lies on the grid and is not blocked.
  [[nodiscard]] bool is_free(Position position) const {
    return grid_.contains(position) && at(position) != Surface::blocked;
  }
  /// The blocked cells that an area (in metres) overlaps; touching is not overlapping.
  [[nodiscard]] std::vector<Position> blocked_cells(const Rectangle& area) const;
  [[nodiscard]] double cell_m() const { return cell_m_; }

 private:
  Grid grid_;
  double cell_m_ = 0;
  bool has_blocked_cells_ = false;
  std::vector<Surface> rows_;   // if every row is of one kind
  std::vector<Surface> cells_;  // else, row by row
};

/// The surface that a letter of a map stands for; nothing for an unknown letter.
[[nodiscard]] std::optional<Surface> find_surface(char letter);

struct CrossingParameters;

/// The bands of the crossing world, as far as its road goes; of a map the stretches of its rows,
/// and its AV's lane over them. REQUIRES: parameters without problems().
[[nodiscard]] Ground ground(const CrossingParameters& parameters);

/// The obstacles of the crossing world, in their order.
[[nodiscard]] std::vector<Rectangle> obstacles(const CrossingParameters& parameters);

}  // namespace jaywalk
