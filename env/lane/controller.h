// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lane-keeping assistants: each steers a car along the right lane of a road that it knows. A row of
// controllers.def and a file in controllers/ for each. Read vehicle.h and path.h first.

#include <memory>
#include <span>
#include <string_view>

#include "env/lane/road.h"
#include "env/lane/vehicle.h"
#include "env/number_parameter.h"

namespace jaywalk::lane {

class Controller {
 public:
  Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;
  virtual ~Controller() = default;

  /// The command for now. Called at equal intervals.
  [[nodiscard]] virtual Command command(const VehicleState& state) = 0;
  [[nodiscard]] virtual Actuator actuator() const = 0;
};

/// A controller's inputs; everything referred to must outlive it.
struct ControllerSetup {
  const Road& road;
  const VehicleParameters& vehicle;
  /// Values in the order of the kind's parameters.
  std::span<const double> values;
  double speed_limit_mps = 0;
  double start_m = 0;
};

struct ControllerKind {
  std::string_view name;
  std::string_view summary;
  std::span<const NumberParameter> parameters;
  std::unique_ptr<Controller> (*make)(const ControllerSetup& setup);
};

[[nodiscard]] std::span<const ControllerKind> controllers();
/// Null if there is none of that name.
[[nodiscard]] const ControllerKind* find_controller(std::string_view name);

}  // namespace jaywalk::lane
