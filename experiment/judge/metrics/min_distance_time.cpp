// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/metrics/extremes.h"
#include "experiment/judge/signals/boxes.h"

namespace jaywalk::metric {
namespace {

/// The part of the motion to `tick` after which the boxes are first as near as they come; within
/// that motion the distance of two convex boxes has one valley.
double part_until_nearest(const TestView& view, ActorIndex actor, std::size_t tick) {
  const std::vector<Point> av = view.box_before(kAv, tick);
  const std::vector<Point> other = view.box_before(actor, tick);
  const Vector way = displacement(view.state(actor, tick - 1), view.state(actor, tick)) -
                     displacement(view.state(kAv, tick - 1), view.state(kAv, tick));
  if (const auto touching = contact(av, other, way, {0, 1})) return touching->from;
  const auto distance_after = [&](double part) {
    std::vector<Point> moved = other;
    for (Point& corner : moved) {
      corner.x_m += way.x * part;
      corner.y_m += way.y * part;
    }
    return distance_m(av, moved);
  };
  constexpr int kHalvings = 60;
  double from = 0;
  double to = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double left = from + (to - from) / 3;
    const double right = to - (to - from) / 3;
    // On a flat bottom the first moment counts.
    (distance_after(left) <= distance_after(right) ? to : from) =
        distance_after(left) <= distance_after(right) ? right : left;
  }
  return (from + to) / 2;
}

}  // namespace

std::optional<MetricValue> min_distance_time(const TestView& view, ActorIndex actor) {
  auto nearest = least<SignalId::closest>(view, actor);
  if (!nearest) return std::nullopt;
  const double parts =
      nearest->tick == 0 ? 0 : nearest->tick - 1 + part_until_nearest(view, actor, nearest->tick);
  nearest->value = parts * view.tick_s();
  return nearest;
}

}  // namespace jaywalk::metric
