// SPDX-License-Identifier: Apache-2.0
#pragma once

// The command line of `compare`, read and checked.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/failure_condition.h"
#include "experiment/compare/kills/kills_file.h"
#include "experiment/run/run_comparison.h"
#include "experiment/test_run/plan_coverage.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk::command::compare {

/// The options that can be read without the scenario, so that all their errors are reported at
/// once. Empty: the scenario's own.
struct CompareOptions {
  std::vector<std::string> behaviours;
  std::optional<std::vector<std::uint32_t>> agents;
  std::optional<std::uint64_t> tests;
  std::optional<std::uint64_t> seed;
  unsigned threads = 1;
  /// The settings of the scenario (`key=value`) that come from options which limit tests.
  std::vector<std::string> limits;
  std::vector<FailureCondition> conditions;
  std::optional<StoreOptions> store;
  OutputOptions output;
  /// The page (.html) or picture (.svg).
  std::optional<std::string> report;
  /// Files of kills from elsewhere.
  std::vector<std::string> kills;
  /// Given options that have no effect without defects.
  std::vector<OptionName> about_defects;
  bool coverage = false;
  bool situations = false;
  bool per_test = false;
  bool starts = false;

  [[nodiscard]] bool wants_page() const { return report && !report->ends_with(".svg"); }
};

/// The checked request of a command line.
struct Request {
  CompareOptions options;
  ComparisonRequest comparison;
  /// Null unless coverage is asked for.
  std::unique_ptr<PlanCoverage> coverage;
  /// Kills from other files, shown beside those of this comparison.
  std::vector<KillLine> other_kills;
};

/// Nothing after reporting errors.
[[nodiscard]] std::optional<Request> read_request(const Arguments& arguments, Console& console);

/// Whether the request can be carried out; false after reporting why not.
[[nodiscard]] bool can_be_run(const Request& request, Console& console);

}  // namespace jaywalk::command::compare
