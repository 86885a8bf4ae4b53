#include "experiment/compare/measures/mean_estimate.h"
#include "experiment/compare/measures/measures.h"

namespace jaywalk::estimates {

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

}  // namespace jaywalk::estimates
