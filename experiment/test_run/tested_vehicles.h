// SPDX-License-Identifier: Apache-2.0
#pragma once

// The automated vehicles (AVs) that the tests of an experiment are run with. Usually that is the
// one that the scenario describes. With defects to be found it is a healthy one, and the same with
// each of the defects, so that a test can be held against its counterpart.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/simulator/parameters.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

class PreparedScenario;
struct Scenario;

/// The AV as the scenario describes it.
inline constexpr std::string_view kGivenVehicle = "given";
/// Its healthy twin: without defects.
inline constexpr std::string_view kHealthyVehicle = "healthy";

struct TestedVehicle {
  /// `given`, `healthy`, a defect as `latency=0.3`, or a model as `Krauss`; each once.
  std::string name;
  VehicleParameters parameters;
  /// Which simulator moves it, and with which model.
  SimulatorParameters simulator;
};

/// The first is that of the measures: the given one; or, if the experiment has defects, the healthy
/// one, then the given one if that is another, then the healthy one with each of the defects; or,
/// if the experiment compares models, the given one with each of them.
[[nodiscard]] std::vector<TestedVehicle> tested_vehicles(const Scenario& scenario);

/// Whether vehicles of those names are models held against each other, rather than a healthy one
/// and defects of it.
[[nodiscard]] bool compares_models(const std::vector<std::string>& vehicles);

/// Its index among the scenario's vehicles; `given` is `healthy` where these are the same. Nothing
/// if there is none of that name.
[[nodiscard]] std::optional<std::size_t> find_vehicle(const PreparedScenario& prepared,
                                                      std::string_view name);

}  // namespace jaywalk
