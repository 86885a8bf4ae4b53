// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scenario, made ready to run: its world, its behaviours' programs, its automated vehicle (AV),
// the defaults of its experiment. A YAML file says it (docs/reference/scenarios.md). Single tests
// of it can be run here; comparison.h runs all of them.
//
//   const auto scenario = jaywalk::RunnableScenario::read("scenarios/paper.yaml");
//   if (!scenario) ... scenario.diagnostics().render()
//   const jaywalk::TestReport report = scenario.value().run({.behaviour = "proximity"}).value();

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <jaywalk/diagnostics.h>
#include <jaywalk/interpreter.h>
#include <jaywalk/judge.h>
#include <jaywalk/vehicle.h>

namespace jaywalk {

class PreparedScenario;
struct Scenario;
struct ScenarioOptions;

/// Which part of a scenario's file is used, and what replaces its values: the command's options.
struct ScenarioChoice {
  /// Replaces the file's `preset`.
  std::optional<std::string> preset;
  /// `dotted.path=value`, in order, as given to `--set`; the last one counts.
  std::vector<std::string> sets;
  /// Names of the scenario's behaviours, or paths of programs: these and no others. Empty: all.
  std::vector<std::string> behaviours;
  /// Policy files by which agents choose (policy.h); empty: the scenario's.
  std::vector<std::string> policies;
  /// An AV of this program instead of the scenario's, of which the sensors' range, the period and
  /// the defects are kept. No store keeps its tests, since it could not run them again.
  std::shared_ptr<const OwnVehicle> vehicle;
  ProgramFolders folders;
  /// The folder of what is installed with Jaywalk, share/jaywalk (the package's jaywalk_DATA_DIR),
  /// in which `$jaywalk/…` lies; empty: there is none.
  std::string data_folder;
};

/// Which test.
struct TestChoice {
  /// By name; empty: the first one.
  std::string behaviour;
  /// 1 to 10,000.
  std::uint32_t agents = 1;
  /// From 0, less than 10,000,000.
  std::uint64_t test = 0;
  /// Nothing: the scenario's.
  std::optional<std::uint64_t> seed;
  /// The text that agents print, line by line.
  std::function<void(std::string_view line)> print = {};
  /// Called from time to time: true gives the test up, which is an error of run().
  std::function<bool()> interrupted = {};
};

/// One actor at one moment: the middle of its box in metres, y along the road (the AV's way), x to
/// its right; its speed in m/s, its heading in radians, counter-clockwise from x.
struct ActorMoment {
  double x_m = 0;
  double y_m = 0;
  double speed_mps = 0;
  double heading_rad = 0;
};

struct ActorTrack {
  std::string name;       // "av", or the agent's
  std::string_view kind;  // "vehicle", "pedestrian", …
  double length_m = 0;    // of its box, along its heading
  double width_m = 0;
  /// Before the first tick and after each.
  std::vector<ActorMoment> moments;
};

/// Something that happened in a test.
struct TestEvent {
  std::uint32_t tick = 0;
  /// The actor's name; empty if it concerns the whole test.
  std::string actor;
  /// `precondition`, `collision`, …, and details.
  std::string kind;
  std::string text;
};

/// The outcome of one test.
struct TestReport {
  /// Why it came to no end of its own (an agent looped, a limit was reached, the AV's controller
  /// failed); empty: it did. Of an errored test nothing else counts.
  std::string error;
  /// The precondition of the assertion under test was met.
  bool succeeded = false;
  /// The word for why it ended: `precondition`, `collision`, `road_end`, `time_limit`, …
  std::string ended_by;
  std::uint32_t ticks = 0;
  double tick_s = 1;
  /// Rewards less costs, the mean over all agents.
  double score = 0;
  /// Speed of the first collision in m/s, if there was one.
  std::optional<double> impact_mps;
  /// The AV is the first, then the agents in their order.
  std::vector<ActorTrack> actors;
  std::vector<TestEvent> events;
  /// By the scenario's assertions, or those that run() was given.
  std::vector<TestVerdict> verdicts;
  std::vector<MetricReading> metrics;
};

/// Immutable and cheap to copy; its tests may run on several threads at once.
class RunnableScenario {
 public:
  /// Errors, in the scenario and the programs, have their places.
  [[nodiscard]] static Result<RunnableScenario> read(const std::string& path,
                                                     const ScenarioChoice& choice = {});
  /// From a text; programs are found relative to the folder in `name`.
  [[nodiscard]] static Result<RunnableScenario> parse(const std::string& name, std::string text,
                                                      const ScenarioChoice& choice = {});

  [[nodiscard]] const std::string& name() const;
  /// "crossing", "motorway", … (world.h).
  [[nodiscard]] std::string_view world() const;
  [[nodiscard]] std::vector<std::string> behaviours() const;
  /// The AVs that tests are run with: the given one alone, or those of its defects or models.
  [[nodiscard]] std::vector<std::string> vehicles() const;
  /// The defaults of the experiment: numbers of agents, tests of each, seed.
  [[nodiscard]] std::vector<std::uint32_t> agents() const;
  [[nodiscard]] std::uint64_t tests() const;
  [[nodiscard]] std::uint64_t seed() const;
  /// The assertions that the scenario names.
  [[nodiscard]] const JudgingRules& rules() const;
  /// Of values and programs that are allowed but unusual.
  [[nodiscard]] const Diagnostics& warnings() const;

  /// Runs one test; the same choice gives the same report. Errors: there is no such test, or it was
  /// interrupted.
  [[nodiscard]] Result<TestReport> run(const TestChoice& choice = {}) const;
  [[nodiscard]] Result<TestReport> run(const TestChoice& choice, const JudgingRules& rules) const;

  // For the rest of this project.
  [[nodiscard]] const std::shared_ptr<const PreparedScenario>& prepared() const;
  [[nodiscard]] const ScenarioOptions& options() const;

 private:
  struct Parts;
  explicit RunnableScenario(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
  [[nodiscard]] static Result<RunnableScenario> made(Result<Scenario> scenario,
                                                     ScenarioOptions options,
                                                     std::shared_ptr<const OwnVehicle> vehicle);

  std::shared_ptr<const Parts> parts_;
};

}  // namespace jaywalk
