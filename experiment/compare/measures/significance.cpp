// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/significance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace jaywalk {
namespace {

double real(std::uint64_t count) { return static_cast<double>(count); }

std::uint64_t total(const Counts& counts) {
  std::uint64_t sum = 0;
  for (const auto& [value, count] : counts) sum += count;
  return sum;
}

double two_sided(double z) {
  return std::min(
      1.0, 2 * boost::math::cdf(boost::math::complement(boost::math::normal(), std::fabs(z))));
}

}  // namespace

double PairedOutcomes::difference() const {
  return all() == 0 ? 0 : (real(first_only) - real(second_only)) / real(all());
}

double mcnemar(const PairedOutcomes& outcomes) {
  const std::uint64_t differing = outcomes.first_only + outcomes.second_only;
  if (differing == 0) return 1;
  // The exact test: if both were equally good, each differing test would be a fair coin.
  const boost::math::binomial chance(real(differing), 0.5);
  const double fewer = real(std::min(outcomes.first_only, outcomes.second_only));
  return std::min(1.0, 2 * boost::math::cdf(chance, fewer));
}

ConfidenceInterval difference_interval(const PairedOutcomes& outcomes, double confidence) {
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  // Agresti and Min: half a test is added to each of the four cells.
  const double n = real(outcomes.all()) + 2;
  const double first = (real(outcomes.first_only) + 0.5) / n;
  const double second = (real(outcomes.second_only) + 0.5) / n;
  const double middle = first - second;
  const double half = z * std::sqrt((first + second - middle * middle) / n);
  return {.low = std::max(-1.0, middle - half), .high = std::min(1.0, middle + half)};
}

std::optional<RankComparison> compare_ranks(const Counts& first, const Counts& second) {
  const double n = real(total(first));
  const double m = real(total(second));
  if (n == 0 || m == 0) return std::nullopt;
  Counts together = first;
  for (const auto& [value, count] : second) together[value] += count;
  // U: pairs in which the first is greater; ties among all values lessen the variance.
  double greater = 0;
  double below = 0;
  double ties = 0;
  for (const auto& [value, count] : together) {
    const auto mine = first.find(value);
    const auto others = second.find(value);
    const double here = others == second.end() ? 0 : real(others->second);
    // Values ascend: `below` counts the second's values that are less; ties count half.
    if (mine != first.end()) greater += real(mine->second) * (below + here / 2);
    below += here;
    const double t = real(count);
    ties += t * t * t - t;
  }
  RankComparison result{.a12 = greater / (n * m)};
  const double all = n + m;
  const double variance = n * m / 12 * (all + 1 - (all > 1 ? ties / (all * (all - 1)) : 0));
  // With the correction for continuity.
  const double away = std::max(0.0, std::fabs(greater - n * m / 2) - 0.5);
  if (variance > 1e-9) result.p = two_sided(away / std::sqrt(variance));
  return result;
}

std::optional<MeanComparison> compare_means(const Sample& first, const Sample& second) {
  if (first.count < 2 || second.count < 2) return std::nullopt;
  const double n = real(first.count);
  const double m = real(second.count);
  const double a = first.squares / (n - 1) / n;
  const double b = second.squares / (m - 1) / m;
  if (!(a + b > 0)) return std::nullopt;
  // Welch's t-test, for samples of unequal variance.
  const double freedom = (a + b) * (a + b) / (a * a / (n - 1) + b * b / (m - 1));
  const double difference = first.mean - second.mean;
  const double t = std::fabs(difference) / std::sqrt(a + b);
  const boost::math::students_t distribution(freedom);
  const double pooled = std::sqrt((first.squares + second.squares) / (n + m - 2));
  // Hedges' correction of Cohen's d for small samples.
  const double correction = 1 - 3 / (4 * (n + m) - 9);
  return MeanComparison{
      .p = std::min(1.0, 2 * boost::math::cdf(boost::math::complement(distribution, t))),
      .g = difference / pooled * correction};
}

std::vector<double> holm(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> corrected(p_values.size());
  double least = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const double p = p_values[order[rank]] * real(p_values.size() - rank);
    // A greater p-value may not become less than one before it.
    least = std::max(least, std::min(1.0, p));
    corrected[order[rank]] = least;
  }
  return corrected;
}

}  // namespace jaywalk
