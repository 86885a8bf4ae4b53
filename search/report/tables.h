#pragma once

// The results of searches as text, CSV and JSON. Read statistics.h before.

#include <string>

#include "search/experiment.h"
#include "search/statistics.h"

namespace jaywalk::search {

/// A generator's searches.
struct GeneratorResults {
  std::string name;
  std::vector<const SearchRun*> runs;
  std::vector<RunSummary> summaries;

  [[nodiscard]] std::vector<double> values(double RunSummary::*value) const;
};

/// Complete searches alone, in the order of the plan.
[[nodiscard]] std::vector<GeneratorResults> group(const SearchExperiment& experiment,
                                                  const SearchResults& results);

/// Means and standard deviations for each generator, and Wilcoxon's p-values of failing tests and
/// diversity for each pair.
[[nodiscard]] std::string render_table(const std::vector<GeneratorResults>& generators);

/// One row for each search.
[[nodiscard]] std::string to_csv(const std::vector<GeneratorResults>& generators);

/// Everything: experiment, summaries, comparisons, and every test.
[[nodiscard]] std::string to_json(const SearchExperiment& experiment,
                                  const std::vector<GeneratorResults>& generators);

}  // namespace jaywalk::search
