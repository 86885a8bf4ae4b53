// SPDX-License-Identifier: Apache-2.0
#pragma once

// Whether two behaviours differ by more than chance, and by how much: tests of hypotheses, sizes of
// effects, and a correction for asking often.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "experiment/compare/measures/statistics.h"

namespace jaywalk {

/// The same tests of two behaviours: how many succeeded for both, the one alone, the other alone,
/// neither.
struct PairedOutcomes {
  std::uint64_t both = 0;
  std::uint64_t first_only = 0;
  std::uint64_t second_only = 0;
  std::uint64_t neither = 0;

  [[nodiscard]] std::uint64_t all() const { return both + first_only + second_only + neither; }
  /// The first's share of successes less the second's.
  [[nodiscard]] double difference() const;
};

/// The exact two-sided test of McNemar (1947): the binomial distribution of the tests in which they
/// differ. 1 if they never do.
[[nodiscard]] double mcnemar(const PairedOutcomes& outcomes);

/// The interval of the difference of two paired proportions, after Wald with the correction of
/// Agresti and Min (2005): half a test is added to each of the four numbers.
[[nodiscard]] ConfidenceInterval difference_interval(const PairedOutcomes& outcomes,
                                                     double confidence = kConfidence);

/// How often each value was seen.
using Counts = std::map<std::uint32_t, std::uint64_t>;

struct RankComparison {
  /// Two-sided, of the test of Mann and Whitney (1947) by the normal approximation with corrections
  /// for ties and continuity.
  double p = 1;
  /// How probable it is that a value of the first is greater than one of the second, equal ones
  /// counting half (Vargha and Delaney 2000): 0.5 if neither tends to be.
  double a12 = 0.5;
};
/// Nothing if either is empty.
[[nodiscard]] std::optional<RankComparison> compare_ranks(const Counts& first,
                                                          const Counts& second);

struct MeanComparison {
  /// Two-sided, of the test of Welch (1947).
  double p = 1;
  /// The difference in standard deviations, pooled, corrected for small samples (Hedges 1981).
  double g = 0;
};
/// Nothing for fewer than two values on a side, or if none of them vary.
[[nodiscard]] std::optional<MeanComparison> compare_means(const Sample& first,
                                                          const Sample& second);

/// p-values corrected for multiple tests by the step-down method of Holm (1979), in the order
/// given. A corrected value bounds the chance of a single false alarm among all of them.
[[nodiscard]] std::vector<double> holm(std::span<const double> p_values);

}  // namespace jaywalk
