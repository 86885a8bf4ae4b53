#pragma once

// Coverage of the tests in a store: of situations from their recordings, of the agents' programs by
// running them again.

#include <functional>

#include "experiment/report/tables/situation_coverage.h"
#include "experiment/results/reader.h"
#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {

/// Which tests; empty fields: all.
struct CoverageWanted {
  std::optional<std::string> behaviour;
  std::optional<std::uint32_t> agents;
  /// The most tests of each behaviour and number of agents; the first ones are taken.
  std::optional<std::uint64_t> tests;
};

/// Called now and then; may end it, and there is no result then.
using CoverageProgress = std::function<Proceed(const Progress&)>;

/// A row for each behaviour and number of agents. Tests that are not in the store cover nothing.
[[nodiscard]] Result<std::vector<SituationRow>> stored_situations(const ResultsReader& store,
                                                                  const CoverageWanted& wanted,
                                                                  const CoverageProgress& progress);

/// Runs the tests again and returns the coverage of their programs. The result does not depend on
/// the number of threads.
[[nodiscard]] Result<SourceCoverage> stored_plan_coverage(const ResultsReader& store,
                                                          const CoverageWanted& wanted,
                                                          unsigned threads,
                                                          const CoverageProgress& progress);

}  // namespace jaywalk
