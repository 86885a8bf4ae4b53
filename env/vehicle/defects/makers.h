#pragma once

// The makers of the rows of defects.def, each in the file of its family.

#include <memory>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

#define JAYWALK_DEFECT(name, family, unit, function, summary, source, ...) \
  [[nodiscard]] std::unique_ptr<VehicleController> function(               \
      std::unique_ptr<VehicleController> inner, double severity);
#include "env/vehicle/defects.def"
#undef JAYWALK_DEFECT

}  // namespace jaywalk
