#include "experiment/measures/measures.h"

namespace jaywalk::estimates {

Estimate accuracy(const Summary& results) {
  if (results.tests == 0) return {};
  const ConfidenceInterval interval = wilson_interval(results.successes, results.tests);
  const auto tests = static_cast<double>(results.tests);
  return {.value = 100 * static_cast<double>(results.successes) / tests,
          .low = 100 * interval.low,
          .high = 100 * interval.high};
}

}  // namespace jaywalk::estimates
