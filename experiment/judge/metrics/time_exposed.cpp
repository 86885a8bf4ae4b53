// SPDX-License-Identifier: Apache-2.0
// How long, and how deep, the time to collision stayed below a threshold.

#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {
namespace {

constexpr double kThresholdS = 1;

}  // namespace

std::optional<MetricValue> tet(const TestView& view, ActorIndex actor) {
  const auto times = view.values(SignalId::ttc, actor);
  return sum_over_time(view, actor,
                       [&](std::size_t tick) { return times[tick] <= kThresholdS ? 1.0 : 0.0; });
}

std::optional<MetricValue> tit(const TestView& view, ActorIndex actor) {
  const auto times = view.values(SignalId::ttc, actor);
  return sum_over_time(view, actor,
                       [&](std::size_t tick) { return std::max(0.0, kThresholdS - times[tick]); });
}

std::optional<MetricValue> time_in_road(const TestView& view, ActorIndex actor) {
  const auto inside = view.values(SignalId::in_road, actor);
  return sum_over_time(view, actor,
                       [&](std::size_t tick) { return tick == 0 ? 0.0 : inside[tick]; });
}

}  // namespace jaywalk::metric
