// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "experiment/export/openscenario/courses.h"

namespace jaywalk {
namespace {

double extent(const Actor& actor) { return std::hypot(actor.length_m, actor.width_m) / 2; }

}  // namespace

ActorState state_at(const Moving& moving, double time_s) {
  const double t = std::max(time_s - moving.start_s, 0.0);
  const auto after = std::ranges::upper_bound(moving.points, t, {}, &Waypoint::time_s);
  if (after == moving.points.end()) {
    const Waypoint& last = moving.points.back();
    return {last.x_m, last.y_m, 0, last.heading_rad};
  }
  const Waypoint& to = *after;
  const Waypoint& from = after == moving.points.begin() ? to : *std::prev(after);
  const double duration = to.time_s - from.time_s;
  const double share = duration > 0 ? (t - from.time_s) / duration : 0;
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const double speed = duration > 0 && time_s >= moving.start_s ? std::hypot(dx, dy) / duration : 0;
  return {from.x_m + share * dx, from.y_m + share * dy, speed, from.heading_rad};
}

std::optional<double> first_touch(const Moving& first, const Moving& second, double until_s,
                                  double step_s) {
  const double reach = extent(first.actor) + extent(second.actor);
  const auto steps = static_cast<std::size_t>(std::ceil(until_s / step_s));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double time = std::min(static_cast<double>(i) * step_s, until_s);
    const ActorState a = state_at(first, time);
    const ActorState b = state_at(second, time);
    if (std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) > reach) continue;
    if (distance_m(box(first.actor, a), box(second.actor, b)) <= 0) return time;
  }
  return std::nullopt;
}

std::optional<double> time_to_collision(const Moving& av, const Moving& other, double time_s) {
  const ActorState a = state_at(av, time_s);
  const ActorState b = state_at(other, 0);
  const double front = a.y_m + av.actor.length_m / 2;
  double near = b.y_m;
  for (const Point& corner : box(other.actor, b)) near = std::min(near, corner.y_m);
  if (a.speed_mps <= 0 || front >= near) return std::nullopt;
  return distance_m(box(av.actor, a), box(other.actor, b)) / a.speed_mps;
}

std::optional<double> first_below(const Moving& av, const Moving& other, double value_s,
                                  double until_s, double step_s) {
  const auto steps = static_cast<std::size_t>(std::ceil(until_s / step_s));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double time = static_cast<double>(i) * step_s;
    const auto ttc = time_to_collision(av, other, time);
    if (ttc && *ttc < value_s) return time;
  }
  return std::nullopt;
}

}  // namespace jaywalk
