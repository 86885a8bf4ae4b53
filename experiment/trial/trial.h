#pragma once

// One test: a behaviour, some agents, a seed. A trial is a pure function of the prepared scenario
// and its input; trials may run on several threads at once and in any order. Read scenario.h
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
#include "experiment/scenario/scenario.h"
#include "experiment/trial/covered_bins.h"
#include "experiment/trial/test_result.h"
#include "experiment/trial/test_troubles.h"
#include "experiment/trial/tested_vehicles.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// A behaviour whose program is compiled and whose parameters are terms.
struct PreparedBehaviour {
  std::string name;
  std::string program_path;
  std::shared_ptr<const Program> program;
  /// Lines of AgentSpeak, of the program and all that it includes, without blank ones and comments.
  std::uint64_t code_lines = 0;
  std::vector<Parameter> parameters;
  /// What its agents choose by where plans are learned(P) (policy/policy.h); null: by chance.
  std::shared_ptr<const Policy> policy;
  /// The texts that `program` and the team's were made from: programs and all that they include.
  std::vector<SourcePtr> sources;
  /// Programs of single agents, by number from 1; the others run `program`.
  std::map<std::uint32_t, std::shared_ptr<const Program>> team;
  /// Parameters of single agents, by number from 1; they take the place of the common ones.
  std::map<std::uint32_t, std::vector<Parameter>> agent_parameters;
};

/// Where a scenario's programs look for what they include.
[[nodiscard]] IncludePath include_path(const Scenario& scenario);

/// A scenario made ready to run: immutable, shared by all trials on all threads.
class PreparedScenario {
 public:
  /// Loads and compiles the behaviours' programs and checks the parameters against their initial
  /// beliefs. Warnings (a missing include, say) are added to `warnings`.
  [[nodiscard]] static Result<std::shared_ptr<const PreparedScenario>> prepare(
      Scenario scenario, Diagnostics& warnings);

  [[nodiscard]] const Scenario& scenario() const { return scenario_; }
  [[nodiscard]] const std::vector<PreparedBehaviour>& behaviours() const { return behaviours_; }
  /// The programs of the world's actors, in their order.
  [[nodiscard]] const std::vector<PreparedBehaviour>& actors() const { return actors_; }
  [[nodiscard]] const std::shared_ptr<const SymbolTable>& symbols() const { return symbols_; }
  /// The texts of all files that it was made from, each once, in the order in which they were read:
  /// with copies of these (ScenarioOptions::files) it can be made again.
  [[nodiscard]] const std::vector<SourcePtr>& inputs() const { return inputs_; }
  /// The AVs that tests can be run with (tested_vehicles.h), by name, and the world with each.
  [[nodiscard]] const std::vector<std::string>& vehicles() const { return vehicles_; }
  [[nodiscard]] const PreparedWorld& world(std::size_t vehicle) const { return *worlds_[vehicle]; }

 private:
  struct PreparedVehicle {
    std::string name;
    std::unique_ptr<const PreparedWorld> world;
  };

  PreparedScenario(Scenario scenario, std::shared_ptr<const SymbolTable> symbols,
                   std::vector<PreparedBehaviour> behaviours, std::vector<PreparedBehaviour> actors,
                   std::vector<SourcePtr> inputs, std::vector<PreparedVehicle> vehicles);

  Scenario scenario_;
  std::shared_ptr<const SymbolTable> symbols_;
  std::vector<PreparedBehaviour> behaviours_;
  std::vector<PreparedBehaviour> actors_;
  std::vector<SourcePtr> inputs_;
  std::vector<std::string> vehicles_;
  std::vector<std::unique_ptr<const PreparedWorld>> worlds_;
};

struct TrialInput {
  /// Index into the prepared scenario's behaviours.
  std::size_t behaviour = 0;
  std::uint32_t agents = 1;
  /// The experiment's seed and the test's number, from 0.
  std::uint64_t seed = 0;
  std::uint64_t test = 0;
  /// What the agents believe of earlier tests: the beliefs covered(Item, Bin, Times).
  std::vector<CoveredBin> feedback;
  /// What the test before has left over, in a world in which that matters (carry_over.h).
  int head_start = 0;
  /// Index into the prepared scenario's vehicles.
  std::size_t vehicle = 0;
  /// The cells where the agents start, if that is not for the scenario to say. REQUIRES: as many as
  /// agents, or none; a world that has cells.
  std::vector<Position> starts;
  /// These take the place of what the scenario sets for all agents of the behaviour. REQUIRES: the
  /// programs have such initial beliefs.
  std::vector<ParameterSetting> parameters;
};

/// Looks at a trial as it runs: called before the first tick and after each.
using TrialObserver = std::function<void(const World& world, const Mas& mas)>;

struct TrialOptions {
  TrialObserver observe;
  /// Receives every scene of the test, and its events: `precondition`, of each agent that met it,
  /// `collision`, of the one the AV touched, the world's own (World::events), `errored`, why the
  /// test came to no end of its own, `feedback`, what the agents believed of earlier tests, and
  /// `head_start`, if there was one. Null: nothing is recorded.
  Recording* record = nullptr;
  /// Looks at the agents as they reason (interpreter/agent/surroundings/observer.h). Null: nobody
  /// does.
  ReasoningObserver* observer = nullptr;
  /// Whom agents ask that learn, in place of the behaviour's policy; null: that.
  OptionPolicies* policies = nullptr;
  std::function<void(std::string_view line)> print;
  std::function<void(std::string_view line)> log;
  /// Reasoning cycles of one agent in one tick before the trial is given up.
  std::uint64_t max_cycles_per_tick = 1'000'000;
  /// Reasoning cycles of one agent in all before the trial is given up, in place of the scenario's
  /// limit; and ticks. 0: that limit, and none.
  std::uint64_t max_cycles = 0;
  std::uint64_t max_ticks = 0;
  bool measure_cpu = false;
  /// Asked now and then, in the middle of whatever agents do: true gives the trial up. Not set:
  /// never.
  std::function<bool()> interrupted;
};

struct TrialResult {
  WorldResult outcome;
  /// The head start of the next test (World::left_over).
  int left_over = 0;
  /// The test came to an end of its own; otherwise it is errored and `message` says why and where:
  /// which agent ran away, reached a limit or stopped it, or what the AV's controller did.
  bool completed = true;
  /// It was given up because TrialOptions::interrupted said so: that is no result.
  bool interrupted = false;
  std::string message;
  std::uint64_t cycles = 0;
  TestTroubles troubles;
  /// What the author of the AV's controller should know; usually empty.
  std::string note;
  /// CPU time that the agents spent reasoning, if measured.
  double cpu_s = 0;
};

/// What comes of it for a table of single tests.
[[nodiscard]] TestOutcome outcome_of(const TrialResult& trial);

/// Runs trials one after another, each as if it were the only one: what it has built for one is
/// used again for the next, which with the same behaviour and number of agents costs little.
class TrialRunner {
 public:
  /// The scenario must outlive it.
  explicit TrialRunner(const PreparedScenario& prepared) : prepared_(prepared) {}

  /// As run_trial.
  [[nodiscard]] TrialResult run(const TrialInput& input, const TrialOptions& options = {});

 private:
  void add_agents(const TrialInput& input);

  const PreparedScenario& prepared_;
  std::unique_ptr<Mas> mas_;
  // The agents of the last trial.
  std::size_t behaviour_ = 0;
  std::uint32_t agents_ = 0;
  std::vector<AgentSpec> specs_;
  ControllerProcesses processes_;
  Simulators simulators_;
};

/// Trial runners for trials on several threads: each trial borrows one.
class TrialRunners {
 public:
  /// The scenario must outlive them.
  explicit TrialRunners(const PreparedScenario& prepared) : prepared_(prepared) {}

  /// As run_trial, on any thread. Without enough memory the trial is errored.
  [[nodiscard]] TrialResult run(const TrialInput& input, const TrialOptions& options = {});

 private:
  const PreparedScenario& prepared_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<TrialRunner>> idle_;
};

/// One trial by itself. REQUIRES: a behaviour of the scenario, at least one agent and, if the
/// scenario has start cells, as many in this test.
[[nodiscard]] TrialResult run_trial(const PreparedScenario& prepared, const TrialInput& input,
                                    const TrialOptions& options = {});

/// How the world begins the trial's test. The seed for where agents start is mix(mix(seed, test),
/// 0); it does not depend on the behaviour.
[[nodiscard]] WorldStart start_of(const TrialInput& input);

/// The start cells of a trial, in a world that has cells: the scenario's own or drawn ones.
[[nodiscard]] std::vector<Position> start_cells(const Scenario& scenario, const TrialInput& input);

/// Those of the tests from 0, by number (print_start_cells).
[[nodiscard]] std::map<std::uint64_t, std::vector<Position>> start_cells(const Scenario& scenario,
                                                                         std::uint32_t agents,
                                                                         std::uint64_t seed,
                                                                         std::uint64_t tests);

/// Why the trial cannot run (a behaviour or start cells that do not exist); empty if it can.
[[nodiscard]] std::string obstacle(const PreparedScenario& prepared, const TrialInput& input);

}  // namespace jaywalk
