// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/road_user.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace jaywalk {
namespace {

constexpr double kReached = 1e-9;

// Ten steps of a tenth of a cell lead to the next one, not a hair's breadth beside it.
GridPoint rounded(GridPoint place) {
  constexpr double kParts = 1e9;
  return {std::round(place.x * kParts) / kParts, std::round(place.y * kParts) / kParts};
}

// How far a step can lead before the grid ends.
double room(GridPoint place, const Grid& grid, Direction direction) {
  switch (direction) {
    case Direction::left:
      return place.x;
    case Direction::right:
      return grid.rows - 1 - place.x;
    case Direction::forward:
      return grid.cells - 1 - place.y;
    case Direction::back:
      return place.y;
  }
  return 0;
}

}  // namespace

std::string_view name(SignalColour colour) {
  static constexpr std::array<std::string_view, 3> kNames{"green", "amber", "red"};
  return kNames[static_cast<std::size_t>(colour)];
}

std::string_view name(CrosswalkKind kind) {
  return kind == CrosswalkKind::zebra ? "zebra" : "signalled";
}

double heading_rad(Direction direction) {
  using std::numbers::pi;
  switch (direction) {
    case Direction::left:
      return pi;
    case Direction::right:
      return 0;
    case Direction::forward:
      return pi / 2;
    case Direction::back:
      return -pi / 2;
  }
  return 0;
}

Direction nearest_direction(double heading_rad) {
  const double ahead = std::sin(heading_rad);
  const double right = std::cos(heading_rad);
  if (std::fabs(ahead) >= std::fabs(right))
    return ahead >= 0 ? Direction::forward : Direction::back;
  return right >= 0 ? Direction::right : Direction::left;
}

BoxSize half_extent(const RoadUser& body) {
  const BoxSize size = size_of(body.kind);
  const bool along = body.facing == Direction::forward || body.facing == Direction::back;
  // As a BoxSize: its length along the road, its width across.
  return along ? BoxSize{size.length_m / 2, size.width_m / 2}
               : BoxSize{size.width_m / 2, size.length_m / 2};
}

Rectangle box_of(const RoadUser& body, double cell_m) {
  const BoxSize half = half_extent(body);
  const double x = (body.place.x + 0.5) * cell_m;
  const double y = (body.place.y + 0.5) * cell_m;
  return {x - half.width_m, x + half.width_m, y - half.length_m, y + half.length_m};
}

bool is_blocked(const RoadUser& body, const Layout& layout, Direction direction, double cells) {
  RoadUser turned = body;
  turned.facing = direction;
  RoadUser there = turned;
  there.place =
      ahead_of(body.place, direction, std::min(cells, room(body.place, layout.grid(), direction)));
  const double cell_m = layout.cell_m();
  const Rectangle from = box_of(turned, cell_m);
  const Rectangle to = box_of(there, cell_m);
  const Rectangle way{std::min(from.left, to.left), std::max(from.right, to.right),
                      std::min(from.near, to.near), std::max(from.far, to.far)};
  const std::vector<Position> met = layout.blocked_cells(way);
  if (met.empty()) return false;
  const std::vector<Position> before = layout.blocked_cells(box_of(body, cell_m));
  return std::ranges::any_of(
      met, [&](Position each) { return std::ranges::find(before, each) == before.end(); });
}

std::string step(RoadUser& body, const Layout& layout, Direction direction, double cells,
                 int tick) {
  if (body.gone) return "it has left the road";
  const double free = room(body.place, layout.grid(), direction);
  const bool leaves = body.may_leave() && cells > free + kReached;
  if (free < kReached && !leaves) {
    return fmt::format("a step {} from ({:.6g},{:.6g}) leaves the grid", name(direction),
                       body.place.x, body.place.y);
  }
  const double length = leaves ? cells : std::min(cells, free);
  if (is_blocked(body, layout, direction, cells)) {
    return fmt::format("a step {} from ({:.6g},{:.6g}) is blocked", name(direction), body.place.x,
                       body.place.y);
  }
  body.place = rounded(ahead_of(body.place, direction, length));
  body.facing = direction;
  body.step = length;
  body.stepped_in = tick;
  body.gone = leaves;
  return {};
}

void leave(RoadUser& body, const Layout& layout, double out_of_sight, int tick) {
  const Grid grid = layout.grid();
  const double beyond = std::max({-body.place.x, -body.place.y, body.place.x - (grid.rows - 1),
                                  body.place.y - (grid.cells - 1)});
  if (beyond > out_of_sight) return;
  body.place = rounded(ahead_of(body.place, body.facing, body.step));
  body.stepped_in = tick;
}

}  // namespace jaywalk
