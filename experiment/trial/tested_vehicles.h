#pragma once

// The automated vehicles (AVs) that the tests of an experiment are run with. Usually that is the
// one that the scenario describes. With defects to be found it is a healthy one, and the same with
// each of the defects, so that a test can be held against its counterpart.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

class PreparedScenario;
struct Scenario;

/// The AV as the scenario describes it.
inline constexpr std::string_view kGivenVehicle = "given";
/// Its healthy twin: without defects.
inline constexpr std::string_view kHealthyVehicle = "healthy";

struct TestedVehicle {
  /// `given`, `healthy`, or a defect as `latency=0.3`; each once.
  std::string name;
  VehicleParameters parameters;
};

/// The first is that of the measures: the given one; or, if the experiment has defects, the healthy
/// one, then the given one if that is another, then the healthy one with each of the defects.
[[nodiscard]] std::vector<TestedVehicle> tested_vehicles(const Scenario& scenario);

/// Its index among the scenario's vehicles; `given` is `healthy` where these are the same. Nothing
/// if there is none of that name.
[[nodiscard]] std::optional<std::size_t> find_vehicle(const PreparedScenario& prepared,
                                                      std::string_view name);

}  // namespace jaywalk
