// SPDX-License-Identifier: Apache-2.0
#pragma once

// Behaviours x numbers of agents x tests, run in parallel and summed up. The outcome is a function
// of the tests alone: it does not depend on the number of threads. How one test is run is the
// caller's business (see test_run.h); so this file knows neither scenarios nor agents.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/summary.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Which test: the index of its behaviour in the plan, the number of agents, its number from 0, and
/// the index of the automated vehicle (AV) that it runs with.
struct TestKey {
  std::size_t behaviour = 0;
  std::uint32_t agents = 1;
  std::uint64_t number = 0;
  std::size_t vehicle = 0;
};

/// Runs one test. Called from several threads at once.
using TestFunction = std::function<Result<TestResult>(const TestKey&)>;

/// The results of the tests in progress are kept in memory, if they are summed up: about 40 bytes
/// each.
inline constexpr std::uint64_t kMaxTests = 10'000'000;

/// Whether tests of one behaviour with one number of agents may run in any order and at once, or
/// each needs the one before it: then they run one after another, in the order of their numbers,
/// and threads share out behaviours and numbers of agents.
enum class TestOrder { any, chained };

struct ExperimentPlan {
  std::vector<std::string> behaviours;
  std::vector<std::uint32_t> agents;
  /// REQUIRES: at most kMaxTests.
  std::uint64_t tests = 1000;
  /// The AVs that every test is run with; the measures are of the first.
  std::vector<std::string> vehicles{"given"};
  TestOrder order = TestOrder::any;
  /// Whether the outcome has summaries; if not, the caller sums up the tests of a store.
  bool summed_up = true;
  /// REQUIRES: at least 1.
  unsigned threads = 1;

  /// Pairs of behaviour and number of agents, and the same for every vehicle.
  [[nodiscard]] std::size_t rows() const { return behaviours.size() * agents.size(); }
  [[nodiscard]] std::size_t cells() const { return rows() * vehicles.size(); }
  /// In the order of vehicles, then behaviours, then numbers of agents. REQUIRES: a test of the
  /// plan.
  [[nodiscard]] std::size_t cell_of(const TestKey& test) const;
  /// Its number in that order, from 0. REQUIRES: a test of the plan.
  [[nodiscard]] std::uint64_t place_of(const TestKey& test) const {
    return cell_of(test) * tests + test.number;
  }
};

struct Progress {
  std::uint64_t done = 0;
  std::uint64_t total = 0;
};

enum class Proceed { yes, no };

/// Called from the thread that runs the experiment, some times a second and at the end; may end it.
using ProgressFunction = std::function<Proceed(const Progress&)>;

struct ExperimentOutcome {
  /// If they are summed up: the pairs of behaviour and number of agents all of whose tests with the
  /// first vehicle are finished, in the order of the plan. Their code lines are left to the caller.
  std::vector<Summary> summaries;
  Progress progress;
  /// The first test that could not be run, with the reason: they run in the order of behaviours,
  /// then numbers of agents, numbers of tests and vehicles; chained ones, and models of the AV
  /// (compares_models), in that of vehicles, behaviours, numbers of agents and numbers of tests.
  std::optional<TestKey> failed_test;
  Diagnostics failure;

  [[nodiscard]] bool complete() const { return progress.done == progress.total; }
};

/// Runs all tests of the plan. Rethrows an exception of a test (no memory left, say).
[[nodiscard]] ExperimentOutcome run_experiment(const ExperimentPlan& plan, const TestFunction& test,
                                               const ProgressFunction& progress);

}  // namespace jaywalk
