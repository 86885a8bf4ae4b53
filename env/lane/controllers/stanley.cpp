// The controller of Stanley, which won the DARPA Grand Challenge of 2005 (Hoffmann, Tomlin,
// Montemerlo and Thrun 2007, "Autonomous automobile trajectory tracking for off-road driving",
// equation 5): the heading error plus the angle whose tangent is the front axle's lateral error
// over the speed.

#include <algorithm>
#include <array>
#include <cmath>

#include "env/lane/controllers/controllers.h"
#include "env/lane/controllers/speed_plan.h"

namespace jaywalk::lane::controller::stanley {
namespace {

enum Parameter : std::size_t {
  kGain,
  kSoftening,
  kLateral,
  kPlanBrake,
  kPreview,
  kSpeedGain,
  kAcceleration,
  kBrake,
  kLatency,
  kLag,
  kRate,
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
    NumberParameter{"latency_s", 0.02, 0, 1, "between command and actuators"},
    NumberParameter{"steering_lag_s", 0.05, 0.005, 1, "time constant of the steering"},
    NumberParameter{"steering_rate", 0.57, 0.01, 10, "the steering's speed, rad/s"},
};

SpeedPlanParameters speeds(const ControllerSetup& setup) {
  return {.speed_limit_mps = setup.speed_limit_mps,
          .lateral_acceleration = setup.values[kLateral],
          .braking = setup.values[kPlanBrake],
          .preview_m = setup.values[kPreview],
          .latency_s = setup.values[kLatency],
          .gain = setup.values[kSpeedGain],
          .most_acceleration = setup.values[kAcceleration],
          .most_braking = setup.values[kBrake]};
}

class Stanley : public Controller {
 public:
  explicit Stanley(const ControllerSetup& setup)
      : vehicle_(setup.vehicle),
        values_(setup.values),
        path_(lane_centre(setup.road)),
        plan_(path_, speeds(setup)) {}

  Command command(const VehicleState& state) override {
    const Point front{state.x_m + vehicle_.front_axle_m * std::cos(state.heading_rad),
                      state.y_m + vehicle_.front_axle_m * std::sin(state.heading_rad)};
    near_ = path_.nearest(front, near_);
    const double heading = path_.heading(near_);
    const double lateral = (front.y_m - path_.point(near_).y_m) * std::cos(heading) -
                           (front.x_m - path_.point(near_).x_m) * std::sin(heading);
    const double steering =
        wrapped(heading - state.heading_rad) -
        std::atan(values_[kGain] * lateral / (values_[kSoftening] + state.speed_mps));
    return {plan_.acceleration(path_, near_, state.speed_mps),
            std::clamp(steering, -vehicle_.most_steering_rad, vehicle_.most_steering_rad)};
  }

  [[nodiscard]] Actuator actuator() const override {
    return {values_[kLatency], values_[kLag], values_[kRate]};
  }

 private:
  const VehicleParameters& vehicle_;
  std::span<const double> values_;
  Path path_;
  SpeedPlan plan_;
  std::size_t near_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Controller> make(const ControllerSetup& setup) {
  return std::make_unique<Stanley>(setup);
}

}  // namespace jaywalk::lane::controller::stanley
