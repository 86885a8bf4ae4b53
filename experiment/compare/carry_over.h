#pragma once

// Chains of tests: with `world.av.carry_over` what a test leaves of the AV's last tick is the head
// start of the next test of the same behaviour and number of agents. Such tests run one after
// another (TestOrder::chained). A stored test keeps its head start, and can be run again alone.
// Read test_run.h and experiment.h first.

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

/// What each chain has left over. Chains may be at work on several threads, each on one.
class CarryOver {
 public:
  /// The plan must outlive it.
  explicit CarryOver(const ExperimentPlan& plan);

  /// REQUIRES: the test before it was finished(), or it is number 0.
  [[nodiscard]] int head_start(const TestKey& test) const;
  void finished(const TestKey& test, int left_over);

 private:
  /// By the test's number: of the last one, and of those that were finished long ago.
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
