// SPDX-License-Identifier: Apache-2.0
#pragma once

// One test: a behaviour, some agents, a seed. A test is a pure function of the prepared scenario
// and its setup; tests may run on several threads at once and in any order. Read scenario.h
// before.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "env/simulator/simulator.h"
#include "env/vehicle/controller_processes.h"
#include "env/world/world_spec.h"
#include "experiment/judge/recording.h"
#include "experiment/policy/policy.h"
#include "experiment/scenario/files/portable_names.h"
#include "experiment/scenario/scenario.h"
#include "experiment/test_run/covered_bins.h"
#include "experiment/test_run/prepared_scenario.h"
#include "experiment/test_run/test_result.h"
#include "interpreter/mas/mas.h"

namespace jaywalk {

/// All that decides a test: with the same setup it comes out the same. Which test of an experiment
/// it is says a TestKey (compare/experiment.h).
struct TestSetup {
  /// Index into the prepared scenario's behaviours.
  std::size_t behaviour = 0;
  std::uint32_t agents = 1;
  /// The experiment's seed and the test's number, from 0.
  std::uint64_t seed = 0;
  std::uint64_t test = 0;
  /// The agents' beliefs about earlier tests: covered(Item, Bin, Times).
  std::vector<CoveredBin> feedback;
  /// The head start that the test before has left over, where tests depend on each other
  /// (carry_over.h).
  int head_start = 0;
  /// Index into the prepared scenario's vehicles.
  std::size_t vehicle = 0;
  /// The cells where the agents start, if that is not for the scenario to say. REQUIRES: as many as
  /// agents, or none; a world that has cells.
  std::vector<Position> starts;
  /// They replace the scenario's values for all agents of the behaviour. REQUIRES: the programs
  /// have such initial beliefs.
  std::vector<ParameterSetting> parameters;
};

/// Looks at a test as it runs: called before the first tick and after each.
using TestObserver = std::function<void(const World& world, const Mas& mas)>;

struct TestOptions {
  TestObserver observe;
  /// Receives every scene of the test, and its events: `precondition` for each agent that met it,
  /// `collision` for each one that the AV touched, the world's own (World::events), `errored` with
  /// the reason, `feedback` with the agents' beliefs about earlier tests, and `head_start`, if
  /// there was one. Null: nothing is recorded.
  Recording* record = nullptr;
  /// Observes the agents as they reason (interpreter/agent/surroundings/observer.h). Null: none
  /// does.
  ReasoningObserver* observer = nullptr;
  /// Chooses for learning agents instead of the behaviour's policy; null: the policy does.
  OptionPolicies* policies = nullptr;
  /// Shortens paths in kept messages of errors; null: they stay as they are.
  const PortableNames* names = nullptr;
  std::function<void(std::string_view line)> print;
  std::function<void(std::string_view line)> log;
  /// Reasoning cycles of one agent in one tick before the test is given up.
  std::uint64_t max_cycles_per_tick = 1'000'000;
  /// Reasoning cycles of one agent in all before the test is given up, in place of the scenario's
  /// limit; and ticks. 0: that limit, and none.
  std::uint64_t max_cycles = 0;
  std::uint64_t max_ticks = 0;
  bool measure_cpu = false;
  /// Called from time to time, in the middle of whatever agents do: true gives the test up. Not
  /// set: never.
  std::function<bool()> interrupted;
};

/// The full result of running a test. Measures see its TestResult, tables of single tests show its
/// TestOutcome, stores keep its TestRecord.
struct TestRun {
  WorldResult outcome;
  /// The head start of the next test (World::left_over).
  int left_over = 0;
  /// The test came to an end of its own; otherwise it is errored and `message` says why and where:
  /// which agent ran away, reached a limit or stopped it, or what the AV's controller did.
  bool completed = true;
  /// It was given up because TestOptions::interrupted said so: that is no result.
  bool interrupted = false;
  std::string message;
  std::uint64_t cycles = 0;
  TestTroubles troubles;
  /// Remarks for the author of the AV's controller; usually none.
  std::vector<std::string> notes;
  /// CPU time that the agents spent reasoning, if measured.
  double cpu_s = 0;
};

/// Its values for the measures; only the times if it ended errored.
[[nodiscard]] TestResult result_of(const TestRun& run, double wall_us = 0);
/// Its line in a table of single tests.
[[nodiscard]] TestOutcome outcome_of(const TestRun& run);

/// A test that is errored for that reason without having been run.
[[nodiscard]] TestRun errored_test(std::string why, const TestOptions& options);

/// Runs tests one after another, each as if it were the only one. It reuses its objects for the
/// next test, which is cheap if that has the same behaviour and number of agents.
class TestRunner {
 public:
  /// The scenario must outlive it.
  explicit TestRunner(const PreparedScenario& prepared) : prepared_(prepared) {}

  /// As run_test.
  [[nodiscard]] TestRun run(const TestSetup& setup, const TestOptions& options = {});

  /// It has just run the same test, with another vehicle perhaps: its processes know the views.
  [[nodiscard]] bool has_run(const TestSetup& setup) const;

 private:
  void add_agents(const TestSetup& setup);

  const PreparedScenario& prepared_;
  std::unique_ptr<Mas> mas_;
  // The agents of the last test.
  std::size_t behaviour_ = 0;
  std::uint32_t agents_ = 0;
  std::optional<std::uint64_t> test_;
  std::vector<AgentSpec> specs_;
  ControllerProcesses processes_;
  Simulators simulators_;
};

/// Test runners for tests on several threads: each test borrows one, if it can the one that has
/// just run it with another vehicle.
class TestRunners {
 public:
  /// The scenario must outlive them.
  explicit TestRunners(const PreparedScenario& prepared) : prepared_(prepared) {}

  /// As run_test, on any thread. Without enough memory the test is errored.
  [[nodiscard]] TestRun run(const TestSetup& setup, const TestOptions& options = {});

 private:
  [[nodiscard]] std::unique_ptr<TestRunner> idle_runner(const TestSetup& setup);

  const PreparedScenario& prepared_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<TestRunner>> idle_;
};

/// One test by itself. REQUIRES: a behaviour of the scenario, at least one agent and, if the
/// scenario has start cells, as many in this test.
[[nodiscard]] TestRun run_test(const PreparedScenario& prepared, const TestSetup& setup,
                               const TestOptions& options = {});

/// How the world begins the test. The seed for where agents start is mix(mix(seed, test),
/// 0); it does not depend on the behaviour.
[[nodiscard]] WorldStart start_of(const TestSetup& setup);

/// The start cells of a test, in a world that has cells: the scenario's own or drawn ones.
[[nodiscard]] std::vector<Position> start_cells(const Scenario& scenario, const TestSetup& setup);

/// The start cells of the tests from 0, by number (print_start_cells).
[[nodiscard]] std::map<std::uint64_t, std::vector<Position>> start_cells(const Scenario& scenario,
                                                                         std::uint32_t agents,
                                                                         std::uint64_t seed,
                                                                         std::uint64_t tests);

/// Why the test cannot run (a behaviour or start cells that do not exist); empty if it can.
[[nodiscard]] std::string problem(const PreparedScenario& prepared, const TestSetup& setup);

}  // namespace jaywalk
