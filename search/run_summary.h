// SPDX-License-Identifier: Apache-2.0
#pragma once

// The results of a generator's searches, and how two generators compare. Read search.h first.

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "search/search.h"

namespace jaywalk::search {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One search in numbers (Peltomäki et al. 2022, table 1).
struct RunSummary {
  double tests = 0;
  double failures = 0;
  /// Tests without a result.
  double errors = 0;
  /// Mean fitness of the last 80 and the last 20 percent of the tests.
  double fitness_last_80 = 0;
  double fitness_last_20 = 0;
  /// Median Euclidean distance between the signatures of failing tests; 0 for fewer than two.
  double diversity = 0;
  double unwrapped_diversity = 0;
  double invalid_pct = 0;
  double simulated_s = 0;
  /// Stretches of road on which tests failed that differ by more than 0.5, 1, 2 or 4 m, the share
  /// of failing tests with another one within 1 m, and how different they are by the competition's
  /// measure (failing_stretch.h); not a number if the SUT does not drive on roads.
  double distinct_half_m = kUnknown;
  double distinct_1m = kUnknown;
  double distinct_2m = kUnknown;
  double distinct_4m = kUnknown;
  double twins_pct = kUnknown;
  double sparseness = kUnknown;
  /// How many tests it took to find the first failing one; not a number if none failed.
  double tests_to_failure = kUnknown;
  /// Tests to the first one that violated each requirement (requirements_of()), in their order.
  std::vector<double> tests_to_violation = {};
  double failures_per_1000 = 0;
  /// Mean of the measure of that name; not a number if the SUT has none.
  double naturalness = kUnknown;
  /// Bins of situations (judge/situations/situations.h) that the tests met, and the first 100 of
  /// them; not a number if the SUT does not measure them.
  double situation_bins = kUnknown;
  double situation_bins_100 = kUnknown;
  /// The real time for each test, in milliseconds.
  double generation_ms = 0;
  double execution_ms = 0;
};

[[nodiscard]] RunSummary summarise(const SearchRun& run, const SutModel& model);

/// How a test differs from others: its own signature or its input's.
[[nodiscard]] std::vector<double> signature(const ExecutedTest& test, const SearchSpace& space);

/// How many tests searches needed to find something, those that did not find it counted as well.
struct TestsTo {
  std::size_t found = 0;
  std::size_t searches = 0;
  /// Over all searches, one that found nothing having needed more than any; none: so did the one in
  /// the middle.
  std::optional<double> median;
  /// The fewest tests of a search that found nothing.
  double in_vain = 0;
};
/// `needed`: of each search, not a number if it found nothing; `executed`: all its tests.
[[nodiscard]] TestsTo tests_to(std::span<const double> needed, std::span<const double> executed);
/// `12 of 20, 118`: how many found it, and the median; `3 of 20, > 300`.
[[nodiscard]] std::string text_of(const TestsTo& found);

struct MeanAndDeviation {
  double mean = 0;
  /// The sample's standard deviation (n - 1); 0 for one value.
  double deviation = 0;
};
/// Mean and deviation of the values that are numbers; not a number if none is.
[[nodiscard]] MeanAndDeviation mean_and_deviation(std::span<const double> values);

/// The two-sided p-value of Wilcoxon's signed-rank test (1945) for pairs; zero differences are left
/// out, equal ones share their ranks, the distribution is exact. 1 if all differences are zero.
/// REQUIRES: as many values on both sides.
[[nodiscard]] double wilcoxon_signed_rank(std::span<const double> first,
                                          std::span<const double> second);

/// The middle value, or the mean of the two in the middle; 0 for none.
[[nodiscard]] double median(std::vector<double> values);

[[nodiscard]] double euclidean_distance(const std::vector<double>& a, const std::vector<double>& b);
/// Median pairwise Euclidean distance; 0 for fewer than two.
[[nodiscard]] double median_distance(const std::vector<std::vector<double>>& signatures);

/// Groups the numbers from 0 to `count` - 1: each joins the first group whose founder is the `same`
/// or founds one. Largest groups first, the founder first in each.
[[nodiscard]] std::vector<std::vector<std::size_t>> cluster(
    std::size_t count, const std::function<bool(std::size_t founder, std::size_t other)>& same);

/// A column of the tables: how RunSummary is shown and exported.
struct SummaryColumn {
  std::string_view name;
  std::string_view title;
  double RunSummary::*value = nullptr;
  int decimals = 2;
  enum class Kind {
    plain,
    tested,  ///< pairs of generators are compared by it; every search has a value or none has
    time,    ///< differs from run to run, as it is measured time
  };
  Kind kind = Kind::plain;
};
[[nodiscard]] std::span<const SummaryColumn> summary_columns();

}  // namespace jaywalk::search
