#pragma once

// What an agent of the crossing world moves: a pedestrian, a cyclist, another vehicle; and what a
// signal shows. Read parameters.h before.

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
  /// It has left at the end of the road, and goes on without its agent.
  bool gone = false;
  /// It is a simulator's, and not on the road now.
  bool absent = false;

  /// Vehicles and cyclists leave where the grid ends; pedestrians turn round there.
  [[nodiscard]] bool may_leave() const {
    return kind == ActorKind::vehicle || kind == ActorKind::cyclist;
  }
  /// What it has moved in a tick, in cells.
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

/// Why a step cannot be made; empty if `body` was moved. It leads `cells` in a direction, less at
/// the grid's edge; at the edge itself, or where it is blocked, no step is possible. Those that may
/// leave go on beyond the edge and are gone.
[[nodiscard]] std::string step(RoadUser& body, const Layout& layout, Direction direction,
                               double cells, int tick);

/// One more tick of somebody who is gone: as the last step, until it is out of everybody's sight.
void leave(RoadUser& body, const Layout& layout, double out_of_sight, int tick);

}  // namespace jaywalk
