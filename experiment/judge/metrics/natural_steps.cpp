// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "experiment/judge/metrics/metrics.h"

namespace jaywalk {

bool is_natural_step(const TestView& view, ActorIndex actor, std::size_t tick) {
  const ActorState& before = view.state(actor, tick - 1);
  const ActorState& now = view.state(actor, tick);
  const double turn =
      std::fabs(std::remainder(now.heading_rad - before.heading_rad, 2 * std::numbers::pi));
  const bool turns_back =
      before.speed_mps > 0 && now.speed_mps > 0 && turn > 0.75 * std::numbers::pi;
  const bool loiters = now.speed_mps == 0 && view.values(SignalId::in_road, actor)[tick] != 0;
  return !turns_back && !loiters;
}

namespace metric {

std::optional<MetricValue> natural_steps(const TestView& view, ActorIndex actor) {
  if (view.ticks() < 2) return std::nullopt;
  double natural = 0;
  std::uint32_t first_odd = 0;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    if (is_natural_step(view, actor, tick)) {
      natural += 1;
    } else if (first_odd == 0) {
      first_odd = static_cast<std::uint32_t>(tick);
    }
  }
  return MetricValue{natural / static_cast<double>(view.ticks() - 1), first_odd, actor};
}

}  // namespace metric
}  // namespace jaywalk
