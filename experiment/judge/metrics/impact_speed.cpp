// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> impact_speed(const TestView& view, ActorIndex actor) {
  const auto touched = view.values(SignalId::collision, actor);
  const auto first = std::ranges::find_if(touched, [](double value) { return value != 0; });
  if (first == touched.end()) return std::nullopt;
  return value_at(view.values(SignalId::impact_speed, actor),
                  static_cast<std::size_t>(first - touched.begin()), actor);
}

}  // namespace jaywalk::metric
