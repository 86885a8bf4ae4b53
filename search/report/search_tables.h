// SPDX-License-Identifier: Apache-2.0
#pragma once

// The results of searches as text, CSV and JSON. Read run_summary.h first.

#include <string>
#include <string_view>
#include <vector>

#include "search/run_summary.h"
#include "search/search_experiment.h"

namespace jaywalk::search {

/// A generator's searches.
struct GeneratorResults {
  std::string name;
  std::vector<const SearchRun*> runs;
  std::vector<RunSummary> summaries;
  /// The requirements that their tests are judged by.
  std::vector<std::string> requirements;

  [[nodiscard]] std::vector<double> values(double RunSummary::*value) const;
  [[nodiscard]] TestsTo tests_to_failure() const;
  [[nodiscard]] TestsTo tests_to_violation(std::size_t requirement) const;
};

/// Complete searches alone, in the order of the plan.
[[nodiscard]] std::vector<GeneratorResults> group(const SearchExperiment& experiment,
                                                  const SearchResults& results);

/// A row of a table of generators; its cells are mean and standard deviation, or as text_of().
struct ResultRow {
  std::string_view title;
  /// In the order of the generators; `-` for one without a complete search.
  std::vector<std::string> cells;
};
/// The columns of summaries in which some search has a value.
[[nodiscard]] std::vector<ResultRow> result_rows(const std::vector<GeneratorResults>& generators);

/// How many searches found a failing test, and one that violates each requirement, and the median
/// number of tests to it (text_of()). The titles are those of the generators, which must live on.
[[nodiscard]] std::vector<ResultRow> first_rows(const std::vector<GeneratorResults>& generators);

/// The columns in which pairs of generators are compared.
[[nodiscard]] std::vector<const SummaryColumn*> tested_columns(
    const std::vector<GeneratorResults>& generators);

struct GeneratorPair {
  const GeneratorResults* first;
  const GeneratorResults* second;

  /// The p-value of Wilcoxon's signed-rank test. REQUIRES: every search has a value.
  [[nodiscard]] double p(double RunSummary::*value) const;
};
/// Pairs of generators with the same number of searches, two or more.
[[nodiscard]] std::vector<GeneratorPair> compared(const std::vector<GeneratorResults>& generators);

/// Means and standard deviations for each generator, and Wilcoxon's p-values of some columns for
/// each pair.
[[nodiscard]] std::string render_table(const std::vector<GeneratorResults>& generators);

/// One row for each search.
[[nodiscard]] std::string to_csv(const std::vector<GeneratorResults>& generators);

/// Everything: experiment, summaries, comparisons, and every test.
[[nodiscard]] std::string to_json(const SearchExperiment& experiment,
                                  const std::vector<GeneratorResults>& generators);

}  // namespace jaywalk::search
