#pragma once

// What the searches of a generator come to, and how two generators compare. Read search.h before.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "search/search.h"

namespace jaywalk::search {

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
  /// Number of the first failing test, from 1; 0 if none failed.
  double first_failure = 0;
  double failures_per_1000 = 0;
  /// Mean of the measure of that name; not a number if the SUT has none.
  double naturalness = std::numeric_limits<double>::quiet_NaN();
  /// What really passed for each test, in milliseconds.
  double generation_ms = 0;
  double execution_ms = 0;
};

[[nodiscard]] RunSummary summarise(const SearchRun& run, const SutModel& model);

/// How a test differs from others: its own signature or its input's.
[[nodiscard]] std::vector<double> signature(const ExecutedTest& test, const SearchSpace& space);

struct MeanAndDeviation {
  double mean = 0;
  /// Of the sample (n - 1); 0 for one value.
  double deviation = 0;
};
[[nodiscard]] MeanAndDeviation mean_and_deviation(std::span<const double> values);

/// The two-sided p-value of Wilcoxon's signed-rank test (1945) for pairs; zero differences are left
/// out, equal ones share their ranks, the distribution is exact. 1 if all differences are zero.
/// REQUIRES: as many values on both sides.
[[nodiscard]] double wilcoxon_signed_rank(std::span<const double> first,
                                          std::span<const double> second);

/// The middle value, or the mean of the two in the middle; 0 for none.
[[nodiscard]] double median(std::vector<double> values);

/// Median pairwise Euclidean distance; 0 for fewer than two.
[[nodiscard]] double median_distance(const std::vector<std::vector<double>>& signatures);

/// Groups failing tests: each joins the first group whose founder's signature is at most `reach`
/// away or founds one. Largest groups first; the members are indices.
[[nodiscard]] std::vector<std::vector<std::size_t>> cluster(
    const std::vector<std::vector<double>>& signatures, double reach);

/// A column of the tables: how RunSummary is shown and exported.
struct SummaryColumn {
  std::string_view name;
  std::string_view title;
  double RunSummary::*value = nullptr;
  int decimals = 2;
  /// Differs from run to run, as it is measured time.
  bool is_time = false;
};
[[nodiscard]] std::span<const SummaryColumn> summary_columns();

}  // namespace jaywalk::search
