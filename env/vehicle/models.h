#pragma once

// The makers of the rows of models.def.

#include <memory>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

#define JAYWALK_VEHICLE_MODEL(name, function, summary) \
  [[nodiscard]] std::unique_ptr<VehicleController> function(const VehicleParameters& parameters);
#include "env/vehicle/models.def"
#undef JAYWALK_VEHICLE_MODEL

}  // namespace jaywalk
