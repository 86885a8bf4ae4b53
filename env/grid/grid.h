// SPDX-License-Identifier: Apache-2.0
#pragma once

// Positions, directions and bounds on a grid of square cells. Worlds with a road lay it along +y:
// `x` is the lateral row, counted from the far left as seen when driving forward, `y` the
// longitudinal cell.

#include <optional>
#include <string_view>

namespace jaywalk {

struct Position {
  int x = 0;
  int y = 0;

  friend bool operator==(const Position&, const Position&) = default;
};

/// A point of the grid's plane: whole numbers are the middles of cells, as a Position has them.
struct GridPoint {
  double x = 0;
  double y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

[[nodiscard]] constexpr GridPoint middle(Position position) {
  return {static_cast<double>(position.x), static_cast<double>(position.y)};
}

/// The cell in which a place lies; on the border between two, the one further on.
[[nodiscard]] Position cell(GridPoint place);

/// Whole numbers from `first` to `last`, both included; empty if `last` is less than `first`.
struct Interval {
  int first = 0;
  int last = -1;

  [[nodiscard]] bool contains(int value) const { return first <= value && value <= last; }
  [[nodiscard]] bool empty() const { return last < first; }
  /// The number of values in it.
  [[nodiscard]] int size() const { return empty() ? 0 : last - first + 1; }

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The four neighbours, as seen when driving forward (+y): left is x - 1.
enum class Direction { left, right, forward, back };

inline constexpr int kDirectionCount = 4;

/// `left`, `right`, `forward` or `back`: the word that agents and scenarios use.
[[nodiscard]] std::string_view name(Direction direction);
[[nodiscard]] std::optional<Direction> find_direction(std::string_view name);

/// The neighbour in that direction, on the grid or not.
[[nodiscard]] Position neighbour(Position position, Direction direction);
/// The place `cells` cells away in that direction.
[[nodiscard]] GridPoint ahead_of(GridPoint place, Direction direction, double cells);

struct Grid {
  int rows = 0;
  int cells = 0;

  [[nodiscard]] bool contains(Position position) const {
    return position.x >= 0 && position.x < rows && position.y >= 0 && position.y < cells;
  }
};

}  // namespace jaywalk
