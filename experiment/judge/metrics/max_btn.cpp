#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> max_btn(const TestView& view, ActorIndex actor) {
  return greatest(view, SignalId::btn, actor);
}

}  // namespace jaywalk::metric
