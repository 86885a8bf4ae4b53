// SPDX-License-Identifier: Apache-2.0
// Signals of time, place, speed and acceleration.

#include <algorithm>
#include <cmath>

#include "experiment/judge/signals/signals.h"

namespace jaywalk::signal {
namespace {

template <class Value>
void each_tick(const TestView& view, std::span<double> values, Value value) {
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) values[tick] = value(tick);
}

}  // namespace

void time(const TestView& view, ActorIndex, std::span<double> values) {
  each_tick(view, values,
            [&](std::size_t tick) { return static_cast<double>(tick) * view.tick_s(); });
}

void remaining(const TestView& view, ActorIndex, std::span<double> values) {
  each_tick(view, values, [&](std::size_t tick) {
    return static_cast<double>(view.ticks() - 1 - tick) * view.tick_s();
  });
}

void x(const TestView& view, ActorIndex actor, std::span<double> values) {
  each_tick(view, values, [&](std::size_t tick) { return view.state(actor, tick).x_m; });
}

void y(const TestView& view, ActorIndex actor, std::span<double> values) {
  each_tick(view, values, [&](std::size_t tick) { return view.state(actor, tick).y_m; });
}

void speed(const TestView& view, ActorIndex actor, std::span<double> values) {
  each_tick(view, values, [&](std::size_t tick) { return view.state(actor, tick).speed_mps; });
}

void av_x(const TestView& view, ActorIndex, std::span<double> values) { x(view, kAv, values); }

void av_y(const TestView& view, ActorIndex, std::span<double> values) { y(view, kAv, values); }

void av_speed(const TestView& view, ActorIndex, std::span<double> values) {
  speed(view, kAv, values);
}

void av_acceleration(const TestView& view, ActorIndex, std::span<double> values) {
  const auto speeds = view.values(SignalId::av_speed);
  each_tick(view, values, [&](std::size_t tick) {
    return tick == 0 ? 0 : (speeds[tick] - speeds[tick - 1]) / view.tick_s();
  });
}

void av_deceleration(const TestView& view, ActorIndex, std::span<double> values) {
  const auto accelerations = view.values(SignalId::av_acceleration);
  each_tick(view, values, [&](std::size_t tick) { return std::max(0.0, -accelerations[tick]); });
}

}  // namespace jaywalk::signal
