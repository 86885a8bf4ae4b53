// SPDX-License-Identifier: Apache-2.0
// How close the AV and a road user come, and whether they touch.

#include <limits>

#include "experiment/judge/signals/boxes.h"
#include "experiment/judge/signals/signals.h"

namespace jaywalk::signal {
namespace {

/// The road user's displacement relative to the AV since the tick before, in metres.
Vector relative_way(const TestView& view, ActorIndex actor, std::size_t tick) {
  return displacement(view.state(actor, tick - 1), view.state(actor, tick)) -
         displacement(view.state(kAv, tick - 1), view.state(kAv, tick));
}

double distance_at(const TestView& view, ActorIndex actor, std::size_t tick) {
  return distance_m(view.box_at(kAv, tick), view.box_at(actor, tick));
}

}  // namespace

void distance(const TestView& view, ActorIndex actor, std::span<double> values) {
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    values[tick] = distance_at(view, actor, tick);
  }
}

void closest(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto actors = view.recording().actors();
  values[0] = distance_at(view, actor, 0);
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    values[tick] = closest_m(actors[kAv], {view.state(kAv, tick - 1), view.state(kAv, tick)},
                             actors[actor], {view.state(actor, tick - 1), view.state(actor, tick)});
  }
}

void collision(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto actors = view.recording().actors();
  values[0] = distance_at(view, actor, 0) <= 0;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    values[tick] = touch(actors[kAv], {view.state(kAv, tick - 1), view.state(kAv, tick)},
                         actors[actor], {view.state(actor, tick - 1), view.state(actor, tick)});
  }
}

void impact_speed(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto touched = view.values(SignalId::collision, actor);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    values[tick] = 0;
    if (touched[tick] == 0 || (tick > 0 && distance_at(view, actor, tick - 1) <= 0)) continue;
    const double after = view.state(kAv, tick).speed_mps;
    if (tick == 0) {
      values[tick] = after;
      continue;
    }
    const double before = view.state(kAv, tick - 1).speed_mps;
    const auto when = contact(view.box_before(kAv, tick), view.box_before(actor, tick),
                              relative_way(view, actor, tick), {0, 1});
    values[tick] = before + (after - before) * (when ? when->from : 1);
  }
}

}  // namespace jaywalk::signal
