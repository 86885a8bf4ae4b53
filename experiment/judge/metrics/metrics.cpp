// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/metrics/metrics.h"

#include <algorithm>
#include <array>

#include "experiment/judge/metrics/extremes.h"

namespace jaywalk {

std::span<const Metric> metrics() {
  static constexpr std::array kMetrics = {
#define JAYWALK_METRIC(name, worst, unit, formula, source) \
  Metric{#name, Worst::worst, unit, formula, source, &metric::name},
#define JAYWALK_EXTREME(name, worst, signal, unit, formula, source) \
  Metric{#name, Worst::worst, unit, formula, source, &metric::worst<SignalId::signal>},
#include "experiment/judge/metrics/metrics.def"
#undef JAYWALK_METRIC
#undef JAYWALK_EXTREME
  };
  return kMetrics;
}

const Metric* find_metric(std::string_view name) {
  const auto found = std::ranges::find(metrics(), name, &Metric::name);
  return found == metrics().end() ? nullptr : &*found;
}

std::optional<MetricValue> measured(const Metric& metric, const TestView& view) {
  if (metric.worst == Worst::nearest) {
    const auto nearest = measured(*find_metric("min_distance"), view);
    return nearest ? metric.measure(view, nearest->actor) : std::nullopt;
  }
  std::optional<MetricValue> worst;
  for (const ActorIndex user : view.road_users()) {
    const auto value = metric.measure(view, user);
    if (!value) continue;
    const bool worse = !worst || (metric.worst == Worst::least ? value->value < worst->value
                                                               : value->value > worst->value);
    if (worse) worst = value;
  }
  return worst;
}

std::vector<std::optional<MetricValue>> measured_all(const TestView& view) {
  std::vector<std::optional<MetricValue>> values;
  for (const Metric& metric : metrics()) values.push_back(measured(metric, view));
  return values;
}

}  // namespace jaywalk
