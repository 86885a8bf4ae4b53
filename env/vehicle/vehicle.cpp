// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/vehicle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "env/vehicle/defects.h"

namespace jaywalk {

int periods_of(const VehicleController& controller, double seconds) {
  constexpr double kRounding = 1e-9;
  return std::max(1,
                  static_cast<int>(std::ceil(seconds / controller.longest_period_s() - kRounding)));
}

Motion drive_on(double speed, double change, double highest, double period) {
  const double after = std::clamp(speed + change, 0.0, highest);
  if (after == 0 && change < 0) period *= std::min(1.0, speed / -change);
  return {after, (speed + after) / 2 * period};
}

std::span<const VehicleModel> vehicle_models() {
#define JAYWALK_VEHICLE_MODEL(name, function, summary) VehicleModel{name, summary, function},
  static constexpr std::array kModels{
#include "env/vehicle/models.def"
  };
#undef JAYWALK_VEHICLE_MODEL
  return kModels;
}

const VehicleModel* find_vehicle_model(std::string_view name) {
  const std::span<const VehicleModel> all = vehicle_models();
  const auto found = std::ranges::find(all, name, &VehicleModel::name);
  return found == all.end() ? nullptr : &*found;
}

std::unique_ptr<VehicleController> make_controller(const VehicleParameters& parameters) {
  const VehicleModel* model = find_vehicle_model(parameters.model);
  assert(model != nullptr && "scenarios name models that exist");
  auto controller = parameters.own ? make_own(*parameters.own) : model->make(parameters);
  return with_defects(std::move(controller), parameters.defects);
}

}  // namespace jaywalk
