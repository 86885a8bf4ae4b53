// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/careful_driver.h"

#include <algorithm>

namespace jaywalk {

CarefulDriver::CarefulDriver(const VehicleParameters& parameters)
    : perception_s_(parameters.reaction_s.value_or(kRiskPerceptionS)),
      deceleration_(parameters.deceleration_mps2.value_or(kCompetentBrakingMps2)),
      acceleration_(parameters.acceleration_mps2),
      line_stop_(perception_s_ + kBrakingDelayS) {}

/// The speed lost in `seconds`. Braking grows gradually and is released at once.
double CarefulDriver::press(double wanted_mps2, double seconds) {
  const double before = std::min(braking_, wanted_mps2);
  const double growing = std::min((wanted_mps2 - before) / kBrakingJerkMps3, seconds);
  braking_ = before + kBrakingJerkMps3 * growing;
  return (before + braking_) / 2 * growing + braking_ * (seconds - growing);
}

VehicleDecision CarefulDriver::decide(const VehicleView& view) {
  risks_.look(view, lane_of(view));
  // A vehicle waiting at a line brakes with 0 m/s2; that differs from "no braking".
  const std::optional<double> for_line = line_stop_.braking(view, deceleration_);
  const std::optional<double> risk_s = risks_.first_s();
  const double perceived_s =
      risk_s ? *risk_s + perception_s_ : std::numeric_limits<double>::infinity();
  // Braking may begin within the period.
  const double first_part =
      std::clamp(perceived_s + kBrakingDelayS - view.time_s, 0.0, view.period_s);
  double change = 0;
  if (first_part > 0) {
    const bool drives_on = !for_line && view.time_s + 1e-9 < perceived_s;
    if (drives_on) change += resume(view, acceleration_) * first_part;
    change -= press(for_line.value_or(0), first_part);
  }
  if (first_part < view.period_s) change -= press(deceleration_, view.period_s - first_part);
  return {change / view.period_s};
}

}  // namespace jaywalk
