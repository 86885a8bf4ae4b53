// SPDX-License-Identifier: Apache-2.0
#pragma once

// A comparison as one call: runs every behaviour with every number of agents in seeded tests on
// several threads, judges each test, keeps it in a store if one is asked for, and sums them up.
//
//   ComparisonRequest request = comparison_request(prepared);
//   request.store = StoreOptions{.path = "runs.gpkg", .resume = true};
//   const Result<ComparisonResults> results = run_comparison(request);

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/comparison.h"
#include "experiment/compare/per_test.h"
#include "experiment/judge/situations/situations.h"
#include "experiment/results/writer.h"
#include "experiment/scenario/scenario.h"
#include "experiment/test_run/test_run.h"

namespace jaywalk {

/// Which tests, by what they are judged, and where they are kept.
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

/// Functions of the caller, each of which may be left out. The first three are called on the
/// caller's thread, the others on any.
struct ComparisonHooks {
  /// The store is open, and tests would begin. With `no` nothing is run: there are no results, and
  /// the error says nothing.
  std::function<Proceed()> opened;
  /// Some times a second and at the end: how many of the tests that were missing are done.
  std::function<void(const Progress&)> progress;
  /// The tests have ended, and the store is closed; now they are summed up, unless it could not be
  /// written for that reason.
  std::function<void(const std::optional<std::string>& unwritten)> closed;
  /// From time to time, also in the middle of tests: true ends the comparison; finished tests are
  /// kept.
  std::function<bool()> interrupted;
  /// Returns what `run` returns, which runs the test by the options; it may add observers to these
  /// first.
  std::function<TestRun(const TestKey& test, const TestSetup& setup, TestOptions& options,
                        const std::function<TestRun()>& run)>
      around;
  /// The test is not run, since another part has it or the store had it.
  std::function<void(const TestKey& test)> skipped;
  /// A test with the first vehicle has ended.
  std::function<void(const TestKey& test, const TestResult& result, const Recording& recording)>
      measured;
};

struct ComparisonResults {
  /// Sums up all tests of the store, which may have had some before; without a store those of this
  /// call.
  Comparison comparison;
  ExperimentDescription description;
  /// Counts the tests that were missing.
  Progress progress;
  /// Remarks for the authors of the AVs' controllers.
  std::vector<std::string> notes;
  /// The situations that the tests of each of the comparison's summaries cover, if asked for.
  std::vector<SituationCoverage> situations;
  /// The single tests, if asked for and not in a store; else null.
  std::unique_ptr<PerTestTable> per_test;
};

/// Runs the tests that the store does not have, or all. The results depend on no thread. An
/// interrupted comparison is not `complete`. Errors: problems() of the request, a store that cannot
/// be opened or written, a test that cannot be run.
[[nodiscard]] Result<ComparisonResults> run_comparison(const ComparisonRequest& request,
                                                       const ComparisonHooks& hooks = {});

}  // namespace jaywalk
