#pragma once

// What a command line of `compare` asks for.

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

/// Everything that the command line says, once it is known to be right.
struct Request {
  std::shared_ptr<const PreparedScenario> prepared;
  /// What the options that limit tests set in it.
  std::vector<std::string> limits;
  std::uint64_t seed = 0;
  ExperimentPlan plan;
  /// The experiment as a store and a report keep it.
  ExperimentDescription description;
  std::vector<FailureCondition> conditions;
  std::optional<StoreOptions> store;
  Criteria criteria;
  Ground ground;
  /// Who moves the vehicles (simulator_version.h).
  std::string simulator;
  /// Null: not wanted.
  std::unique_ptr<PlanCoverage> coverage;
  bool situations = false;
  /// Options that are given and need defects, if there are none.
  std::vector<OptionName> pointless;
  /// Kills that were counted elsewhere and stand beside.
  std::vector<KillLine> other_kills;
  /// So are the single tests.
  bool per_test = false;
  /// The cells where agents start are written.
  bool writes_starts = false;
};

/// Nothing after reporting what is wrong.
[[nodiscard]] std::optional<Request> read_request(const Arguments& arguments, Console& console);

/// Whether that can be carried out; false after reporting why not: it is too large, or some test
/// cannot be run (there are no start cells for it, say).
[[nodiscard]] bool can_be_run(const Request& request, Console& console);

}  // namespace jaywalk::command::compare
