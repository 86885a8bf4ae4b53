// SPDX-License-Identifier: Apache-2.0
#pragma once

// The few statistics that the measures need: a sample's mean and spread, and 95 % intervals.

#include <cstdint>
#include <optional>
#include <span>

namespace jaywalk {

inline constexpr double kConfidence = 0.95;

struct ConfidenceInterval {
  double low = 0;
  double high = 0;
};

/// The count, mean and spread of a sample, without its values.
struct Sample {
  std::uint64_t count = 0;
  double mean = 0;
  /// The sum of the squared deviations from the mean.
  double squares = 0;
};

/// Two passes in the order of the values, so that equal values in equal order give equal bits.
[[nodiscard]] Sample summarise(std::span<const double> values);

/// summarise() for values that are not kept: add all of them, call end_pass(), and add all of them
/// again in the same order. Gives the same bits as summarise().
class SampleMaker {
 public:
  void add(double value);
  void end_pass();
  /// REQUIRES: both passes have ended.
  [[nodiscard]] Sample sample() const { return sample_; }

 private:
  Sample sample_;
  double sum_ = 0;
  bool has_mean_ = false;
};

/// The interval of a proportion, from 0 to 1, after Wilson (1927), "Probable inference, the law of
/// succession, and statistical inference". REQUIRES: successes <= tests and tests > 0.
[[nodiscard]] ConfidenceInterval wilson_interval(std::uint64_t successes, std::uint64_t tests,
                                                 double confidence = kConfidence);

/// Spearman's coefficient of rank correlation; equal values share their ranks' mean. Nothing for
/// fewer than two pairs, or if all values of a side are equal. REQUIRES: as many of each.
[[nodiscard]] std::optional<double> rank_correlation(std::span<const double> first,
                                                     std::span<const double> second);

/// The interval of a mean by Student's t; none for fewer than two values.
[[nodiscard]] std::optional<ConfidenceInterval> mean_interval(const Sample& sample,
                                                              double confidence = kConfidence);

}  // namespace jaywalk
