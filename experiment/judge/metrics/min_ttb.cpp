#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> min_ttb(const TestView& view, ActorIndex actor) {
  return least(view, SignalId::ttb, actor);
}

}  // namespace jaywalk::metric
