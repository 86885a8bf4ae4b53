#pragma once

// The measures that are a sample's mean with its t interval.

#include "experiment/compare/measures/measures.h"

namespace jaywalk::estimates {

[[nodiscard]] inline Estimate mean_estimate(const Sample& sample) {
  if (sample.count == 0) return {};
  Estimate estimate{.value = sample.mean};
  if (const auto interval = mean_interval(sample)) {
    estimate.low = interval->low;
    estimate.high = interval->high;
  }
  return estimate;
}

}  // namespace jaywalk::estimates
