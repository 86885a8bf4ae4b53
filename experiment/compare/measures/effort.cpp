// How long a test takes: in ticks, in computing time, and in lines to write.

#include "experiment/compare/measures/mean_estimate.h"
#include "experiment/compare/measures/measures.h"

namespace jaywalk::estimates {

Estimate ticks_success(const Summary& results) { return mean_estimate(results.ticks_success); }

Estimate ticks_all(const Summary& results) { return mean_estimate(results.ticks_all); }

Estimate cpu(const Summary& results) { return {.value = mean_estimate(results.cpu_us).value}; }

Estimate wall(const Summary& results) { return {.value = mean_estimate(results.wall_us).value}; }

Estimate code_lines(const Summary& results) {
  return {.value = static_cast<double>(results.code_lines), .is_count = true};
}

}  // namespace jaywalk::estimates
