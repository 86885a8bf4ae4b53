// SPDX-License-Identifier: Apache-2.0
#pragma once

// The bodies that agents of the crossing world move (pedestrians, cyclists, other vehicles), and
// the colours of signals. Read parameters.h first.

#include "env/crossing/layout.h"
#include "env/scene.h"

namespace jaywalk {

enum class SignalColour : unsigned char { green, amber, red };

/// `green`, `amber` or `red`, as vehicles see it.
[[nodiscard]] std::string_view name(SignalColour colour);

/// `zebra` or `signalled`.
[[nodiscard]] std::string_view name(CrosswalkKind kind);

struct RoadUser {
  ActorKind kind = ActorKind::pedestrian;
  GridPoint place;
  /// The greatest step in cells per tick.
  double speed = 1;
  /// The way of the last step, and before the first one, towards the road.
  Direction facing = Direction::forward;
  /// Cells that the last step led, and the ticks of the last step and of the last action.
  double step = 0;
  int stepped_in = 0;
  int acted_in = 0;
  /// Whether it has left at the end of the road; it then goes on without its agent.
  bool gone = false;
  /// Whether it belongs to a simulator's traffic and is not on the road now.
  bool absent = false;

  /// Vehicles and cyclists leave where the grid ends; pedestrians turn round there.
  [[nodiscard]] bool may_leave() const {
    return kind == ActorKind::vehicle || kind == ActorKind::cyclist;
  }
  /// The cells that it moved in the given tick.
  [[nodiscard]] double step_in(int tick) const { return stepped_in == tick ? step : 0; }
};

/// The box that stands for a body, in metres: its length is along its heading.
[[nodiscard]] double heading_rad(Direction direction);
/// The direction nearest to a heading.
[[nodiscard]] Direction nearest_direction(double heading_rad);

/// Half of the box's extent across the road and along it, as the body faces.
[[nodiscard]] BoxSize half_extent(const RoadUser& body);

/// The body's box, in metres.
[[nodiscard]] Rectangle box_of(const RoadUser& body, double cell_m);

/// Whether a step would take the body's box, turned that way, over a blocked cell. Cells that it
/// overlaps already do not count, so that a body that begins too near to a wall can leave it.
[[nodiscard]] bool is_blocked(const RoadUser& body, const Layout& layout, Direction direction,
                              double cells);

/// Moves `body` by `cells` in a direction, less at the grid's edge. Returns why no step is possible
/// (at the edge itself, or where it is blocked); empty if it was moved. Bodies that may leave go on
/// beyond the edge and are gone.
[[nodiscard]] std::string step(RoadUser& body, const Layout& layout, Direction direction,
                               double cells, int tick);

/// Repeats the last step of a body that has left the road, until it is more than `out_of_sight`
/// cells beyond the grid.
void leave(RoadUser& body, const Layout& layout, double out_of_sight, int tick);

}  // namespace jaywalk
