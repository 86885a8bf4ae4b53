#include "experiment/compare/measures/measures.h"

namespace jaywalk::estimates {

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

}  // namespace jaywalk::estimates
