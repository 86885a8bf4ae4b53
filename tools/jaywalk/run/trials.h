// SPDX-License-Identifier: Apache-2.0
#pragma once

// `check --try`: starts the commands that files name, asks each its first questions and says what
// it answered, before a long run depends on it.

#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "env/environment_process/process_environment.h"
#include "env/vehicle/vehicle.h"
#include "experiment/scenario/scenario.h"
#include "interpreter/support/diagnostics.h"
#include "search/search_experiment.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/run/own_world.h"

namespace jaywalk {

/// Prints a line for each command that answered; errors about the others are diagnostics at the
/// keys that name them.
class Trials {
 public:
  explicit Trials(Console& console) : console_(console) {}

  /// The controllers of its AVs, and its simulator.
  void try_scenario(const Scenario& scenario, Diagnostics& diagnostics);
  /// The system under test executes one input; or its scenario is tried.
  void try_search(const search::SearchExperiment& experiment, Diagnostics& diagnostics);
  /// The world of a project with these agents. Nothing after adding errors.
  [[nodiscard]] std::optional<EnvironmentIdentity> try_world(const OwnWorld& world,
                                                             const std::vector<std::string>& agents,
                                                             Diagnostics& diagnostics);

 private:
  using Clock = std::chrono::steady_clock;

  void try_controller(const VehicleParameters& vehicle, const Scenario& scenario,
                      Diagnostics& diagnostics);
  void try_simulator(const Scenario& scenario, Diagnostics& diagnostics);
  void say(std::string_view key, std::string_view command, std::string_view answered,
           Clock::time_point since);

  Console& console_;
  /// The commands that were tried.
  std::set<std::vector<std::string>> tried_;
};

}  // namespace jaywalk
