// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace jaywalk {
namespace {

std::vector<double> ranks(std::span<const double> values) {
  std::vector<double> ranks;
  for (const double value : values) {
    const auto below = std::ranges::count_if(values, [&](double v) { return v < value; });
    const auto equal = std::ranges::count(values, value);
    ranks.push_back(static_cast<double>(below) + (static_cast<double>(equal) + 1) / 2);
  }
  return ranks;
}

}  // namespace

Sample summarise(std::span<const double> values) {
  SampleMaker maker;
  for (const double value : values) maker.add(value);
  maker.end_pass();
  for (const double value : values) maker.add(value);
  maker.end_pass();
  return maker.sample();
}

void SampleMaker::add(double value) {
  if (has_mean_) {
    sample_.squares += (value - sample_.mean) * (value - sample_.mean);
  } else {
    sum_ += value;
    ++sample_.count;
  }
}

void SampleMaker::end_pass() {
  if (!has_mean_ && sample_.count > 0) sample_.mean = sum_ / static_cast<double>(sample_.count);
  has_mean_ = true;
}

std::optional<double> rank_correlation(std::span<const double> first,
                                       std::span<const double> second) {
  assert(first.size() == second.size());
  const std::vector<double> x = ranks(first);
  const std::vector<double> y = ranks(second);
  const Sample of_x = summarise(x);
  const Sample of_y = summarise(y);
  if (of_x.squares == 0 || of_y.squares == 0) return std::nullopt;
  double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) products += (x[i] - of_x.mean) * (y[i] - of_y.mean);
  return products / std::sqrt(of_x.squares * of_y.squares);
}

ConfidenceInterval wilson_interval(std::uint64_t successes, std::uint64_t tests,
                                   double confidence) {
  assert(tests > 0 && successes <= tests);
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const auto n = static_cast<double>(tests);
  const double p = static_cast<double>(successes) / n;
  const double scale = 1 + z * z / n;
  const double centre = (p + z * z / (2 * n)) / scale;
  const double half = z / scale * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  // At the ends the formula gives 0 and 1 but for rounding.
  return {.low = successes == 0 ? 0 : centre - half,
          .high = successes == tests ? 1 : centre + half};
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
