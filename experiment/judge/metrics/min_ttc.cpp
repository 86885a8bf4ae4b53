#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> min_ttc(const TestView& view, ActorIndex actor) {
  return least(view, SignalId::ttc, actor);
}

}  // namespace jaywalk::metric
