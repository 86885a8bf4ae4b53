#include "experiment/trial/tested_vehicles.h"

#include <algorithm>

#include "env/vehicle/defects.h"
#include "experiment/trial/trial.h"

namespace jaywalk {

std::vector<TestedVehicle> tested_vehicles(const Scenario& scenario) {
  const VehicleParameters& given = scenario.world.av.vehicle;
  if (scenario.experiment.defects.empty()) return {{std::string(kGivenVehicle), given}};
  VehicleParameters healthy = healthy_twin(scenario.world.av);
  std::vector<TestedVehicle> vehicles{{std::string(kHealthyVehicle), healthy}};
  if (given != healthy) vehicles.push_back({std::string(kGivenVehicle), given});
  for (const VehicleDefect& defect : scenario.experiment.defects) {
    healthy.defects = {defect};
    vehicles.push_back({text_of(defect), healthy});
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
