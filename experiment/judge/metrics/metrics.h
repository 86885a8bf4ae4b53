// SPDX-License-Identifier: Apache-2.0
#pragma once

// The metrics of one test, the rows of metrics.def: each gives a value with its tick and the road
// user that it is about. compare/measures/ sums up the tests of a behaviour, with the distributions
// of these metrics. Read judge/signals/signals.h first.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "experiment/judge/signals/signals.h"

namespace jaywalk {

/// Not NaN; infinite if nothing would help (a deceleration).
struct MetricValue {
  double value = 0;
  /// The tick of the value; for a duration, the tick in which it began.
  std::uint32_t tick = 0;
  ActorIndex actor = 0;

  friend bool operator==(const MetricValue&, const MetricValue&) = default;
};

/// Which road user's value is the test's: the least one, the greatest one, or that of the nearest
/// road user.
enum class Worst { least, greatest, nearest };

struct Metric {
  std::string_view name;
  Worst worst = Worst::least;
  std::string_view unit;
  std::string_view formula;
  std::string_view source;
  /// The value for one road user. Nothing if it does not exist (no collision course, no conflict
  /// area).
  std::optional<MetricValue> (*measure)(const TestView& view, ActorIndex actor);
};

[[nodiscard]] std::span<const Metric> metrics();
/// Null if there is none of that name.
[[nodiscard]] const Metric* find_metric(std::string_view name);

/// The test's value: the worst one over its road users, that of the first of equals.
[[nodiscard]] std::optional<MetricValue> measured(const Metric& metric, const TestView& view);
/// All metrics in the order of metrics().
[[nodiscard]] std::vector<std::optional<MetricValue>> measured_all(const TestView& view);

/// Whether a person might take the step that led to this tick's state: one would hardly turn
/// straight back, or stand still in the road. REQUIRES: tick > 0.
[[nodiscard]] bool is_natural_step(const TestView& view, ActorIndex actor, std::size_t tick);

namespace metric {
#define JAYWALK_EXTREME(name, worst, signal, unit, formula, source)
#define JAYWALK_METRIC(name, worst, unit, formula, source) \
  std::optional<MetricValue> name(const TestView& view, ActorIndex actor);
#include "experiment/judge/metrics/metrics.def"
#undef JAYWALK_METRIC
#undef JAYWALK_EXTREME
}  // namespace metric

}  // namespace jaywalk
