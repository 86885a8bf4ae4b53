// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jaywalk {

// After Liang and Barsky.
bool stands_between(const Rectangle& through, Point from, Point to) {
  double enters = 0;
  double leaves = 1;
  const auto clip = [&](double distance, double towards) {
    if (towards == 0) return distance >= 0;
    const double at = distance / towards;
    if (towards > 0) leaves = std::min(leaves, at);
    if (towards < 0) enters = std::max(enters, at);
    return true;
  };
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  return clip(from.x_m - through.left, -dx) && clip(through.right - from.x_m, dx) &&
         clip(from.y_m - through.near, -dy) && clip(through.far - from.y_m, dy) && enters < leaves;
}

std::optional<SeenActor> see(const Sight& sight, const RoadUserBox& other) {
  const double gap = other.box.near - sight.front_m;
  const bool in_range = gap <= sight.range_m && other.box.far > sight.front_m - sight.length_m;
  if (!in_range) return std::nullopt;
  const Point eye{(sight.body.left_m + sight.body.right_m) / 2, sight.front_m};
  const Point target = other.box.middle();
  const bool hidden = std::ranges::any_of(
      sight.obstacles, [&](const Rectangle& each) { return stands_between(each, eye, target); });
  if (hidden) return std::nullopt;
  return SeenActor{other.id,
                   other.kind,
                   gap,
                   other.box.left,
                   other.box.right,
                   other.speed_mps * std::sin(other.heading_rad),
                   other.speed_mps * std::cos(other.heading_rad),
                   other.box.far - other.box.near,
                   std::numbers::pi / 2 - other.heading_rad};
}

}  // namespace jaywalk
