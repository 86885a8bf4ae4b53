// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a vehicle sees others. It serves the automated vehicle (AV) of a world and the driver with
// which a test's judge compares it. Read vehicle.h first.

#include <cstdint>
#include <optional>
#include <span>

#include "env/scene.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// A strip of the road as its sides in metres from the world's left.
struct Strip {
  double left_m = 0;
  double right_m = 0;
};

/// The place from which a vehicle looks, and the obstacles to its view.
struct Sight {
  Strip body;
  double front_m = 0;
  double length_m = 0;
  double range_m = 0;
  std::span<const Rectangle> obstacles;
};

/// A road user that the vehicle may see.
struct RoadUserBox {
  std::uint32_t id = 0;
  ActorKind kind = ActorKind::pedestrian;
  Rectangle box;
  double speed_mps = 0;
  double heading_rad = 0;
};

/// The line from one point to the other passes through the rectangle.
[[nodiscard]] bool stands_between(const Rectangle& through, Point from, Point to);

/// Empty if it is behind the vehicle, out of range or hidden: an obstacle stands between the middle
/// of the vehicle's front and the middle of the box.
[[nodiscard]] std::optional<SeenActor> see(const Sight& sight, const RoadUserBox& other);

}  // namespace jaywalk
