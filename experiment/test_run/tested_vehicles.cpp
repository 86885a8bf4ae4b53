// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/tested_vehicles.h"

#include <algorithm>

#include "env/vehicle/defects.h"
#include "experiment/test_run/prepared_scenario.h"

namespace jaywalk {
namespace {

/// The world's own models, or its simulator's.
std::vector<TestedVehicle> by_models(const Scenario& scenario) {
  std::vector<TestedVehicle> vehicles;
  for (const std::string& model : scenario.experiment.avs) {
    TestedVehicle& vehicle = vehicles.emplace_back(
        TestedVehicle{model, scenario.world->vehicle(), scenario.world->simulator()});
    if (vehicle.simulator.name.empty()) {
      vehicle.parameters.model = model;
    } else {
      vehicle.simulator.settings[std::string(kAvModelKey)].text = model;
    }
  }
  return vehicles;
}

}  // namespace

bool compares_models(const std::vector<std::string>& vehicles) {
  return vehicles.front() != kGivenVehicle && vehicles.front() != kHealthyVehicle;
}

std::vector<TestedVehicle> tested_vehicles(const Scenario& scenario) {
  const VehicleParameters& given = scenario.world->vehicle();
  const SimulatorParameters& simulator = scenario.world->simulator();
  if (!scenario.experiment.avs.empty()) return by_models(scenario);
  if (scenario.experiment.defects.empty()) return {{std::string(kGivenVehicle), given, simulator}};
  VehicleParameters healthy = scenario.world->healthy_vehicle();
  std::vector<TestedVehicle> vehicles{{std::string(kHealthyVehicle), healthy, simulator}};
  if (given != healthy) vehicles.push_back({std::string(kGivenVehicle), given, simulator});
  for (const VehicleDefect& defect : scenario.experiment.defects) {
    healthy.defects = {defect};
    vehicles.push_back({text_of(defect), healthy, simulator});
  }
  return vehicles;
}

std::optional<std::size_t> find_vehicle(const PreparedScenario& prepared, std::string_view name) {
  const auto& names = prepared.vehicles();
  auto found = std::ranges::find(names, name);
  if (found == names.end() && name == kGivenVehicle) {
    found = std::ranges::find(names, kHealthyVehicle);
  }
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace jaywalk
