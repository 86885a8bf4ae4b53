// SPDX-License-Identifier: Apache-2.0
// The controller of Stanley, which won the DARPA Grand Challenge of 2005 (Hoffmann, Tomlin,
// Montemerlo and Thrun 2007, "Autonomous automobile trajectory tracking for off-road driving",
// equation 5): the heading error plus the angle whose tangent is the front axle's lateral error
// over the speed. Its steering is as slow as that of `paper-rate`, with the rate of CommonRoad's
// vehicle; with a faster one (0.57 rad/s, 20 ms) it never leaves its lane.

#include <array>
#include <cmath>

#include "env/lane/controllers/controllers.h"
#include "env/lane/controllers/path_follower.h"

namespace jaywalk::lane::controller::stanley {
namespace {

enum Parameter : std::size_t {
  kGain,
  kSoftening,
  kOwnParameters,
};

constexpr std::array kParameters = {
    NumberParameter{"gain", 2.5, 0, 50, "of the lateral error, 1/s"},
    NumberParameter{"softening", 1, 0.01, 50, "added to the speed that divides it, m/s"},
    NumberParameter{"lateral_acceleration", 4, 0.1, 20, "planned for curves, m/s2"},
    NumberParameter{"planned_braking", 4, 0.1, 20, "for curves ahead, m/s2"},
    NumberParameter{"preview_m", 40, 1, 500, "how far ahead curves are seen"},
    NumberParameter{"speed_gain", 2.7, 0, 50, "acceleration per difference of speed, 1/s"},
    NumberParameter{"most_acceleration", 6.5, 0.1, 20, "m/s2"},
    NumberParameter{"most_braking", 8, 0.1, 20, "m/s2"},
    NumberParameter{"latency_s", 0.06, 0, 1, "between command and actuators"},
    NumberParameter{"steering_lag_s", 0.08, 0.005, 1, "time constant of the steering"},
    NumberParameter{"steering_rate", 0.4, 0.01, 10, "the steering's speed, rad/s"},
};

static_assert(kParameters.size() == kOwnParameters + PathFollower::kParameters);

class Stanley : public Controller {
 public:
  explicit Stanley(const ControllerSetup& setup)
      : front_axle_m_(setup.vehicle.front_axle_m),
        values_(setup.values),
        follower_(setup, lane_centre(setup.road)) {}

  Command command(const VehicleState& state) override {
    follower_.move_to({state.x_m + front_axle_m_ * std::cos(state.heading_rad),
                       state.y_m + front_axle_m_ * std::sin(state.heading_rad)});
    const double steering =
        wrapped(follower_.heading() - state.heading_rad) -
        std::atan(values_[kGain] * follower_.lateral_m() / (values_[kSoftening] + state.speed_mps));
    return follower_.command(steering, state.speed_mps);
  }

  [[nodiscard]] Actuator actuator() const override { return follower_.actuator(); }

 private:
  double front_axle_m_;
  std::span<const double> values_;
  PathFollower follower_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Controller> make(const ControllerSetup& setup) {
  return std::make_unique<Stanley>(setup);
}

}  // namespace jaywalk::lane::controller::stanley
