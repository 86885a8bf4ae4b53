#include "experiment/judge/metrics/extremes.h"

namespace jaywalk::metric {

std::optional<MetricValue> min_pret(const TestView& view, ActorIndex actor) {
  return least(view, SignalId::pret, actor);
}

}  // namespace jaywalk::metric
