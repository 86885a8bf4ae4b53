#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> max_drac(const TestView& view, ActorIndex actor) {
  return greatest(view, SignalId::drac, actor);
}

}  // namespace jaywalk::metric
