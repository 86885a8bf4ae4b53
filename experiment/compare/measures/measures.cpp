// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/measures.h"

#include <algorithm>
#include <array>

namespace jaywalk {
namespace {

/// A sample's mean with its t interval.
Estimate mean_estimate(const Sample& sample) {
  if (sample.count == 0) return {};
  Estimate estimate{.value = sample.mean};
  if (const auto interval = mean_interval(sample)) {
    estimate.low = interval->low;
    estimate.high = interval->high;
  }
  return estimate;
}

}  // namespace

std::span<const Measure> measures() {
  static constexpr std::array kMeasures = {
#define JAYWALK_MEASURE(name, column, low, high, summary) \
  Measure{#name, column, low, high, summary, &estimates::name},
#include "experiment/compare/measures/measures.def"
#undef JAYWALK_MEASURE
  };
  return kMeasures;
}

const Measure* find_measure(std::string_view name) {
  const auto found = std::ranges::find_if(measures(), [&](const Measure& measure) {
    return measure.name == name || measure.column == name;
  });
  return found == measures().end() ? nullptr : &*found;
}

namespace estimates {

Estimate errored(const Summary& results) {
  return {.value = static_cast<double>(results.errored), .is_count = true};
}

Estimate accuracy(const Summary& results) {
  if (results.judged() == 0) return {};
  const ConfidenceInterval interval = wilson_interval(results.successes, results.judged());
  const auto tests = static_cast<double>(results.judged());
  return {.value = 100 * static_cast<double>(results.successes) / tests,
          .low = 100 * interval.low,
          .high = 100 * interval.high};
}

Estimate score(const Summary& results) { return mean_estimate(results.score); }

Estimate combined(const Summary& results) {
  const Estimate score_estimate = score(results);
  if (!score_estimate.value) return {};
  return {.value = *score_estimate.value * *accuracy(results).value / 1000};
}

Estimate combined_normalised(const Summary& results) {
  // The paper's smallest and largest combined scores lie at about 0 and 1 on this scale.
  constexpr double kOffset = 0.45;
  constexpr double kRange = 4.71;
  const Estimate plain = combined(results);
  if (!plain.value) return {};
  return {.value = (*plain.value + kOffset) / kRange};
}

Estimate ticks_success(const Summary& results) { return mean_estimate(results.ticks_success); }

Estimate ticks_all(const Summary& results) { return mean_estimate(results.ticks_all); }

Estimate cpu(const Summary& results) { return {.value = mean_estimate(results.cpu_us).value}; }

Estimate wall(const Summary& results) { return {.value = mean_estimate(results.wall_us).value}; }

Estimate code_lines(const Summary& results) {
  return {.value = static_cast<double>(results.code_lines), .is_count = true};
}

}  // namespace estimates

}  // namespace jaywalk
