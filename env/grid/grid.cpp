// SPDX-License-Identifier: Apache-2.0
#include "env/grid/grid.h"

#include <array>
#include <cmath>

namespace jaywalk {
namespace {

struct DirectionRow {
  std::string_view name;
  int dx;
  int dy;
};

// In the order of the enumerators.
constexpr std::array<DirectionRow, kDirectionCount> kDirections{{
    {"left", -1, 0},
    {"right", 1, 0},
    {"forward", 0, 1},
    {"back", 0, -1},
}};

const DirectionRow& row(Direction direction) {
  return kDirections[static_cast<std::size_t>(direction)];
}

}  // namespace

std::string_view name(Direction direction) { return row(direction).name; }

std::optional<Direction> find_direction(std::string_view name) {
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    if (kDirections[i].name == name) return static_cast<Direction>(i);
  }
  return std::nullopt;
}

Position cell(GridPoint place) {
  return {static_cast<int>(std::floor(place.x + 0.5)), static_cast<int>(std::floor(place.y + 0.5))};
}

GridPoint ahead_of(GridPoint place, Direction direction, double cells) {
  const DirectionRow& step = row(direction);
  return {place.x + step.dx * cells, place.y + step.dy * cells};
}

Position neighbour(Position position, Direction direction) {
  const DirectionRow& step = row(direction);
  return {position.x + step.dx, position.y + step.dy};
}

}  // namespace jaywalk
