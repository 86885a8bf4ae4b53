#pragma once

// The command line of `compare`, read and checked.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/failure_condition.h"
#include "experiment/compare/kills/kills_file.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/results/writer.h"
#include "experiment/test_run/plan_coverage.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/store_options.h"

namespace jaywalk::command::compare {

/// The checked request of a command line.
struct Request {
  std::shared_ptr<const PreparedScenario> prepared;
  /// The settings of the scenario (`key=value`) that come from options which limit tests.
  std::vector<std::string> limits;
  std::uint64_t seed = 0;
  ExperimentPlan plan;
  /// The experiment as a store and a report keep it.
  ExperimentDescription description;
  std::vector<FailureCondition> conditions;
  std::optional<StoreOptions> store;
  Criteria criteria;
  Ground ground;
  /// The simulator that moves the vehicles, with its version (simulator_version.h).
  std::string simulator;
  /// Null unless coverage is asked for.
  std::unique_ptr<PlanCoverage> coverage;
  bool situations = false;
  /// Given options that have no effect, since they need defects and there are none.
  std::vector<OptionName> pointless;
  /// Kills from other files, shown beside those of this comparison.
  std::vector<KillLine> other_kills;
  /// Whether a row for each test is written.
  bool per_test = false;
  /// Whether the cells where agents start are written.
  bool writes_starts = false;
};

/// Nothing after reporting errors.
[[nodiscard]] std::optional<Request> read_request(const Arguments& arguments, Console& console);

/// Whether the request can be carried out; false after reporting why not: it is too large, or some
/// test cannot be run (there are no start cells for it, say).
[[nodiscard]] bool can_be_run(const Request& request, Console& console);

}  // namespace jaywalk::command::compare
