#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> time_in_road(const TestView& view, ActorIndex actor) {
  const auto inside = view.values(SignalId::in_road, actor);
  return sum_over_time(view, actor,
                       [&](std::size_t tick) { return tick == 0 ? 0.0 : inside[tick]; });
}

}  // namespace jaywalk::metric
