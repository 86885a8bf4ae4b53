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
#include "experiment/run/comparison_request.h"
#include "experiment/test_run/test_run.h"

namespace jaywalk {

/// What the caller wants to do meanwhile; each may be left out. The first three and `closed` are
/// called on the caller's thread, the others on any.
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
  /// Returns what `run` returns, which runs the test by the options: they may be changed before, so
  /// that somebody listens.
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
  /// Of all tests of the store, which may have had some before; of those that were run without one.
  Comparison comparison;
  ExperimentDescription description;
  /// Of the tests that were missing.
  Progress progress;
  /// Remarks for the authors of the AVs' controllers.
  std::vector<std::string> notes;
  /// What the tests of each of the comparison's summaries cover, if asked for.
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
