// SPDX-License-Identifier: Apache-2.0
// Pure pursuit (Coulter 1992, "Implementation of the pure pursuit path tracking algorithm") of the
// lane's middle with a planned speed. Its numbers are set so that 2.6 % of uniform random roads
// fail, as in Peltomäki et al. 2022.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "env/lane/controllers/controllers.h"
#include "env/lane/path.h"

namespace jaywalk::lane::controller::paper_rate {
namespace {

enum Parameter : std::size_t {
  kLookahead,
  kGain,
  kLateral,
  kPreview,
  kPlanBrake,
  kSpeedGain,
  kAcceleration,
  kBrake,
  kLatency,
  kLag,
  kRate,
};

constexpr std::array kParameters = {
    NumberParameter{"lookahead_m", 17, 1, 100, "how far ahead the pursued point is"},
    NumberParameter{"steering_gain", 1.03, 0, 10, "times the pure pursuit's steering angle"},
    NumberParameter{"lateral_acceleration", 5.25, 0.1, 20, "planned for curves, m/s2"},
    NumberParameter{"preview_m", 50, 1, 500, "how far ahead curves are seen"},
    NumberParameter{"planned_braking", 3.4, 0.1, 20, "at which it begins to brake, m/s2"},
    NumberParameter{"speed_gain", 4.6, 0, 50, "acceleration per difference of speed, 1/s"},
    NumberParameter{"most_acceleration", 6.5, 0.1, 20, "m/s2"},
    NumberParameter{"most_braking", 8, 0.1, 20, "m/s2"},
    NumberParameter{"latency_s", 0.06, 0, 1, "between command and actuators"},
    NumberParameter{"steering_lag_s", 0.08, 0.005, 1, "time constant of the steering"},
    NumberParameter{"steering_rate", 0.4, 0.01, 10, "the steering's speed, rad/s"},
};

/// Near points count as being at the car already.
constexpr double kHereMetres = 2;
/// From this share of the planned braking on it no longer accelerates.
constexpr double kCoastingShare = 0.8;

class PurePursuit : public Controller {
 public:
  explicit PurePursuit(const ControllerSetup& setup)
      : vehicle_(setup.vehicle),
        values_(setup.values),
        speed_limit_(setup.speed_limit_mps),
        path_(lane_centre(setup.road)) {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      squared_speeds_.push_back(values_[kLateral] / std::max(1e-6, std::fabs(path_.curvature(i))));
    }
  }

  Command command(const VehicleState& state) override {
    near_ = path_.nearest({state.x_m, state.y_m}, near_);
    double acceleration = planned_acceleration(state);
    const Point rear{state.x_m - vehicle_.rear_axle_m * std::cos(state.heading_rad),
                     state.y_m - vehicle_.rear_axle_m * std::sin(state.heading_rad)};
    const Point goal = pursued();
    const double dx = goal.x_m - rear.x_m;
    const double dy = goal.y_m - rear.y_m;
    const double bearing = wrapped(std::atan2(dy, dx) - state.heading_rad);
    const double turn = 2 * std::sin(bearing) / std::max(std::hypot(dx, dy), 1.0);
    const double steering = std::clamp(values_[kGain] * std::atan(vehicle_.wheelbase_m() * turn),
                                       -vehicle_.most_steering_rad, vehicle_.most_steering_rad);

    // The curvature that is driven or about to be.
    const double curvature =
        std::max(std::fabs(turn), std::fabs(state.yaw_rate) / std::max(state.speed_mps, 3.0));
    const double safe = std::sqrt(values_[kLateral] / std::max(1e-6, curvature));
    acceleration = std::min(acceleration, values_[kSpeedGain] * (safe - state.speed_mps));
    const double used =
        std::min(1.0, curvature * state.speed_mps * state.speed_mps / values_[kLateral]);
    return {std::clamp(acceleration, -values_[kBrake],
                       values_[kAcceleration] * std::sqrt(1 - used * used)),
            steering};
  }

  [[nodiscard]] Actuator actuator() const override {
    return {values_[kLatency], values_[kLag], values_[kRate]};
  }

 private:
  /// So that every curve in sight is reached at its speed.
  [[nodiscard]] double planned_acceleration(const VehicleState& state) const {
    const double speed = state.speed_mps;
    const double reaction = speed * (values_[kLatency] + values_[kLag]);
    double here = std::numeric_limits<double>::infinity();
    double braking = 0;
    for (std::size_t i = near_; i < path_.size(); ++i) {
      const double ahead = path_.arc_m(i) - path_.arc_m(near_);
      if (ahead > values_[kPreview]) break;
      const double squared = squared_speeds_[i];
      if (ahead <= kHereMetres + reaction) {
        here = std::min(here, squared);
      } else {
        braking =
            std::max(braking, (speed * speed - squared) / (2 * std::max(1.0, ahead - reaction)));
      }
    }
    const double now = std::min(speed_limit_, std::sqrt(here));
    const double acceleration = values_[kSpeedGain] * (now - speed);
    if (braking > values_[kPlanBrake]) return std::min(acceleration, -braking);
    if (braking > kCoastingShare * values_[kPlanBrake]) return std::min(acceleration, 0.0);
    return acceleration;
  }

  /// Beyond the end the road goes straight on.
  [[nodiscard]] Point pursued() const {
    const std::size_t i = path_.ahead(near_, values_[kLookahead]);
    const double rest = values_[kLookahead] - (path_.arc_m(i) - path_.arc_m(near_));
    if (rest <= 0) return path_.point(i);
    const double heading = path_.heading(path_.size() - 1);
    return {path_.point(i).x_m + rest * std::cos(heading),
            path_.point(i).y_m + rest * std::sin(heading)};
  }

  const VehicleParameters& vehicle_;
  std::span<const double> values_;
  double speed_limit_;
  Path path_;
  /// Square of the speed at which to drive the curve, at each point.
  std::vector<double> squared_speeds_;
  std::size_t near_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Controller> make(const ControllerSetup& setup) {
  return std::make_unique<PurePursuit>(setup);
}

}  // namespace jaywalk::lane::controller::paper_rate
