#pragma once

// What run_comparison() is asked for: which tests, by what they are judged, and where they are
// kept.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "experiment/compare/experiment.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/results/description.h"
#include "experiment/results/writer.h"
#include "experiment/scenario/scenario.h"
#include "experiment/test_run/prepared_scenario.h"

namespace jaywalk {

struct ComparisonRequest {
  std::shared_ptr<const PreparedScenario> prepared;
  /// Those by which the scenario was read: a store keeps them.
  ScenarioOptions options;
  std::uint64_t seed = 0;
  /// REQUIRES: its behaviours, vehicles and order are those of comparison_request(). Numbers of
  /// agents, tests and threads may be chosen.
  ExperimentPlan plan;
  Criteria criteria;
  /// Empty: no store keeps the tests.
  std::optional<StoreOptions> store;
  /// The simulator that moves the vehicles (simulator_version.h); empty: it is asked.
  std::optional<std::string> simulator;
  /// Whether it is noted which situations the tests cover; and a row for each test, which a store
  /// has anyway.
  bool situations = false;
  bool per_test = false;
};

/// The scenario's own experiment, judged by the scenario's assertions, on one thread.
[[nodiscard]] ComparisonRequest comparison_request(
    std::shared_ptr<const PreparedScenario> prepared);

/// The experiment as a store and a report keep it.
[[nodiscard]] ExperimentDescription describe(const ComparisonRequest& request);

/// Why it cannot be run: it is too large, asks for what excludes each other, or has a test that
/// cannot be run (there are no start cells for it, say).
[[nodiscard]] Diagnostics problems(const ComparisonRequest& request);

}  // namespace jaywalk
