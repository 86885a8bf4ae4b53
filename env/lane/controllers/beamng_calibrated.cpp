// SPDX-License-Identifier: Apache-2.0
// Follows an elastic band that cuts corners, as BeamNG's AI does: curvature feed-forward with
// preview plus feedback of the lateral and the heading error. Calibrated on roads executed in
// BeamNG.tech (RILaST's data), see docs/reference/search_figures.md for how well it ranks roads
// that it never saw.

#include <algorithm>
#include <array>
#include <cmath>

#include "env/lane/controllers/controllers.h"
#include "env/lane/controllers/path_follower.h"
#include "env/lane/elastic_band.h"

namespace jaywalk::lane::controller::beamng_calibrated {
namespace {

enum Parameter : std::size_t {
  kFeedForward,
  kLateralGain,
  kHeadingGain,
  kPreviewLeast,
  kPreviewTime,
  kStiffness,
  kLeft,
  kRight,
  kOwnParameters,
};

constexpr std::array kParameters = {
    NumberParameter{"feed_forward", 1.2, 0, 10, "times the curvature ahead"},
    NumberParameter{"lateral_gain", 0.55, 0, 50, "steering per metre beside the line, times m/s"},
    NumberParameter{"heading_gain", 0.91, 0, 50, "steering per radian off the line's heading"},
    NumberParameter{"steering_preview_m", 4, 0, 100, "where the curvature is taken, at rest"},
    NumberParameter{"steering_preview_s", 0.37, 0, 10, "and so much farther with speed"},
    NumberParameter{"band_stiffness_m", 21, 1, 1000, "how far a corner is cut ahead"},
    NumberParameter{"band_left_m", 1.2, 0, 4, "the most it drives left of the middle"},
    NumberParameter{"band_right_m", 1.6, 0, 4, "the most it drives right of the middle"},
    NumberParameter{"lateral_acceleration", 4.6, 0.1, 20, "planned for curves, m/s2"},
    NumberParameter{"planned_braking", 5.6, 0.1, 20, "for curves ahead, m/s2"},
    NumberParameter{"preview_m", 22.5, 1, 500, "how far ahead curves are seen"},
    NumberParameter{"speed_gain", 2.7, 0, 50, "acceleration per difference of speed, 1/s"},
    NumberParameter{"most_acceleration", 6.5, 0.1, 20, "m/s2"},
    NumberParameter{"most_braking", 8, 0.1, 20, "m/s2"},
    NumberParameter{"latency_s", 0.02, 0, 1, "between command and actuators"},
    NumberParameter{"steering_lag_s", 0.05, 0.005, 1, "time constant of the steering"},
    NumberParameter{"steering_rate", 0.57, 0.01, 10, "the steering's speed, rad/s"},
};

BandParameters band(const ControllerSetup& setup) {
  BandParameters parameters;
  parameters.stiffness_m = setup.values[kStiffness];
  parameters.most_left_m = setup.values[kLeft];
  parameters.most_right_m = setup.values[kRight];
  parameters.start_m = setup.start_m;
  return parameters;
}

static_assert(kParameters.size() == kOwnParameters + PathFollower::kParameters);

class BandFollower : public Controller {
 public:
  explicit BandFollower(const ControllerSetup& setup)
      : vehicle_(setup.vehicle),
        values_(setup.values),
        follower_(setup, elastic_band(lane_centre(setup.road), band(setup))) {}

  Command command(const VehicleState& state) override {
    follower_.move_to({state.x_m, state.y_m});
    const std::size_t ahead = follower_.path().ahead(
        follower_.near(), values_[kPreviewLeast] + values_[kPreviewTime] * state.speed_mps);
    const double steering =
        std::atan(vehicle_.wheelbase_m() * follower_.path().curvature(ahead) *
                  values_[kFeedForward]) -
        values_[kLateralGain] * follower_.lateral_m() / std::max(1.0, state.speed_mps) -
        values_[kHeadingGain] * wrapped(state.heading_rad - follower_.heading());
    return follower_.command(steering, state.speed_mps);
  }

  [[nodiscard]] Actuator actuator() const override { return follower_.actuator(); }

 private:
  const VehicleParameters& vehicle_;
  std::span<const double> values_;
  PathFollower follower_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Controller> make(const ControllerSetup& setup) {
  return std::make_unique<BandFollower>(setup);
}

}  // namespace jaywalk::lane::controller::beamng_calibrated
