// SPDX-License-Identifier: Apache-2.0
#pragma once

// The careful and competent human driver of UN Regulation No. 157 (the performance model of its
// annex on traffic disturbances), also of ISO 34502. A risk begins as hazards.h defines it; the
// driver perceives it for 0.4 s, begins to brake 0.75 s later, and presses the pedal so that the
// deceleration grows at 12.65 m/s^3 up to 0.774 g, until no actor is a risk any more. The model
// `careful-competent` drives so, and so does the imagined driver of the signal `avoidable`
// (experiment/judge/signals/careful_drive.cpp).

#include <limits>
#include <optional>

#include "env/scene.h"
#include "env/vehicle/hazards.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// Seconds in which a risk is perceived, and from then until braking begins.
inline constexpr double kRiskPerceptionS = 0.4;
inline constexpr double kBrakingDelayS = 0.75;
/// How fast the deceleration grows, in m/s^3, and how far, in m/s^2.
inline constexpr double kBrakingJerkMps3 = 12.65;
inline constexpr double kCompetentBrakingMps2 = 0.774 * kGravityMps2;

class CarefulDriver final : public VehicleController {
 public:
  /// `reaction_s` is the time of perception, `deceleration_mps2` the strongest braking.
  explicit CarefulDriver(const VehicleParameters& parameters = {});

  VehicleDecision decide(const VehicleView& view) override;
  /// Short against the 0.6 s in which the braking grows.
  [[nodiscard]] double longest_period_s() const override { return 0.05; }

 private:
  double press(double wanted_mps2, double seconds);

  double perception_s_;
  double deceleration_;
  double acceleration_;
  Risks risks_;
  LineStop line_stop_;
  double braking_ = 0;  // now, m/s^2
};

}  // namespace jaywalk
