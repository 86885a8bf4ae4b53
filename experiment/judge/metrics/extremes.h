// SPDX-License-Identifier: Apache-2.0
#pragma once

// The least or greatest value of a signal, with its tick: what many metrics are.

#include <algorithm>
#include <cmath>

#include "experiment/judge/metrics/metrics.h"

namespace jaywalk::metric {

[[nodiscard]] inline MetricValue value_at(std::span<const double> values, std::size_t tick,
                                          ActorIndex actor) {
  return {values[tick], static_cast<std::uint32_t>(tick), actor};
}

/// The least finite value; nothing if there is none.
template <SignalId signal>
[[nodiscard]] std::optional<MetricValue> least(const TestView& view, ActorIndex actor) {
  const auto values = view.values(signal, actor);
  const auto found = std::ranges::min_element(values);
  if (!std::isfinite(*found)) return std::nullopt;
  return value_at(values, static_cast<std::size_t>(found - values.begin()), actor);
}

/// The greatest value, which may be infinite.
template <SignalId signal>
[[nodiscard]] std::optional<MetricValue> greatest(const TestView& view, ActorIndex actor) {
  const auto values = view.values(signal, actor);
  const auto found = std::ranges::max_element(values);
  return value_at(values, static_cast<std::size_t>(found - values.begin()), actor);
}

/// The sum of a function of the tick over all ticks, times the length of a tick; the tick of the
/// first that is not 0.
template <class Value>
[[nodiscard]] MetricValue sum_over_time(const TestView& view, ActorIndex actor, Value value) {
  MetricValue result{.actor = actor};
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const double each = value(tick);
    if (result.value == 0 && each != 0) result.tick = static_cast<std::uint32_t>(tick);
    result.value += each * view.tick_s();
  }
  return result;
}

}  // namespace jaywalk::metric
