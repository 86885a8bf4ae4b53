#include "experiment/statistics.h"

#include <cassert>
#include <cmath>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace jaywalk {

Sample summarise(std::span<const double> values) {
  Sample sample;
  sample.count = values.size();
  if (values.empty()) return sample;
  double sum = 0;
  for (const double value : values) sum += value;
  sample.mean = sum / static_cast<double>(values.size());
  for (const double value : values) {
    sample.squares += (value - sample.mean) * (value - sample.mean);
  }
  return sample;
}

ConfidenceInterval wilson_interval(std::uint64_t successes, std::uint64_t trials,
                                   double confidence) {
  assert(trials > 0 && successes <= trials);
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double scale = 1 + z * z / n;
  const double centre = (p + z * z / (2 * n)) / scale;
  const double half = z / scale * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  // At the ends the formula gives 0 and 1 but for rounding.
  return {.low = successes == 0 ? 0 : centre - half,
          .high = successes == trials ? 1 : centre + half};
}

std::optional<ConfidenceInterval> mean_interval(const Sample& sample, double confidence) {
  if (sample.count < 2) return std::nullopt;
  const auto n = static_cast<double>(sample.count);
  const boost::math::students_t distribution(n - 1);
  const double t = boost::math::quantile(distribution, (1 + confidence) / 2);
  const double half = t * std::sqrt(sample.squares / (n - 1) / n);
  return ConfidenceInterval{.low = sample.mean - half, .high = sample.mean + half};
}

}  // namespace jaywalk
