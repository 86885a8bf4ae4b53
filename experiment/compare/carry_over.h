// SPDX-License-Identifier: Apache-2.0
#pragma once

// Chains of tests: with `world.av.carry_over` the cells that the AV had left to drive in a test's
// last tick are its head start in the next test of the same behaviour and number of agents. Such
// tests run one after another (TestOrder::chained). A stored test keeps its head start and can run
// again alone. Read test_run.h and experiment.h first.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/test_run/prepared_scenario.h"
#include "experiment/test_run/test_run.h"

namespace jaywalk {

/// How the tests of a scenario may be ordered.
[[nodiscard]] TestOrder test_order(const Scenario& scenario);

/// The cells that the tests of each chain left over. Chains may run on several threads, each chain
/// on one.
class CarryOver {
 public:
  /// The plan must outlive it.
  explicit CarryOver(const ExperimentPlan& plan);

  /// REQUIRES: the test before it was finished(), or it is number 0.
  [[nodiscard]] int head_start(const TestKey& test) const;
  void finished(const TestKey& test, int left_over);

 private:
  /// Left-over cells by test number: of the last test, and of tests from a continued store.
  using Chain = std::map<std::uint64_t, int>;
  [[nodiscard]] std::size_t chain_of(const TestKey& test) const;

  const ExperimentPlan& plan_;
  std::vector<Chain> chains_;
};

/// The test with the head start that the tests before it leave to it, which are run for that if the
/// scenario's tests are chained. Nothing if `proceed`, asked before each of them, says no.
[[nodiscard]] std::optional<TestSetup> in_its_chain(const PreparedScenario& prepared,
                                                    TestSetup setup,
                                                    const std::function<Proceed()>& proceed);

}  // namespace jaywalk
