// SPDX-License-Identifier: Apache-2.0
#include "env/lane/vehicle.h"

#include <algorithm>
#include <cmath>

#include "env/scene.h"

namespace jaywalk::lane {
namespace {

/// The drive train's and the brakes' lag.
constexpr double kDriveLag = 0.05;
/// Below the first speed the car moves kinematically, above the second dynamically.
constexpr double kKinematicSpeed = 2;
constexpr double kDynamicSpeed = 3;

struct AxleForces {
  double front = 0;
  double rear = 0;
};

AxleForces loads(const VehicleParameters& p, double acceleration) {
  const double base = p.wheelbase_m();
  const double weight = p.mass_kg * kGravityMps2;
  const double front =
      p.mass_kg * (kGravityMps2 * p.rear_axle_m - acceleration * p.height_m) / base;
  // An axle that has left the ground bears nothing, and the other one the whole car.
  const double borne = std::clamp(front, 0.0, weight);
  return {borne, weight - borne};
}

AxleForces longitudinal(const VehicleParameters& p, double acceleration, const AxleForces& load) {
  const double force = p.mass_kg * acceleration;
  AxleForces forces{0, force};  // driven at the rear
  if (acceleration < 0) forces = {p.brake_split * force, (1 - p.brake_split) * force};
  const double mu = p.longitudinal_friction;
  return {std::clamp(forces.front, -mu * load.front, mu * load.front),
          std::clamp(forces.rear, -mu * load.rear, mu * load.rear)};
}

/// The share of the lateral force that remains beside the longitudinal one.
double friction_ellipse(const VehicleParameters& p, double force, double load) {
  const double used = force / (p.longitudinal_friction * load);
  return std::sqrt(std::max(0.04, 1 - used * used));
}

void actuate(VehicleState& s, const Command& command, const VehicleParameters& p,
             const Actuator& actuator, double dt) {
  const double rate = std::clamp((command.steering_rad - s.steering_rad) / actuator.steering_lag_s,
                                 -actuator.steering_rate, actuator.steering_rate);
  s.steering_rad =
      std::clamp(s.steering_rad + rate * dt, -p.most_steering_rad, p.most_steering_rad);
  const double engine = s.speed_mps > p.switch_speed_mps
                            ? p.most_acceleration * p.switch_speed_mps / s.speed_mps
                            : p.most_acceleration;
  const double wanted = std::min(command.acceleration, engine);
  s.acceleration += (wanted - s.acceleration) * std::min(1.0, dt / kDriveLag);
}

}  // namespace

double lateral_force(const VehicleParameters& p, double slip_rad, double load) {
  const double b = p.tyre_stiffness / (p.tyre_shape * p.lateral_friction);
  const double z = b * slip_rad;
  return -p.lateral_friction * load *
         std::sin(p.tyre_shape * std::atan(z - p.tyre_curvature * (z - std::atan(z))));
}

void advance(VehicleState& s, const Command& command, const VehicleParameters& p,
             const Actuator& actuator, double dt) {
  actuate(s, command, p, actuator, dt);
  const AxleForces load = loads(p, s.acceleration);
  const AxleForces along = longitudinal(p, s.acceleration, load);
  const double speed = std::max(s.speed_mps, 1.0);
  const double front_slip =
      std::atan2(s.slip_mps + p.front_axle_m * s.yaw_rate, speed) - s.steering_rad;
  const double rear_slip = std::atan2(s.slip_mps - p.rear_axle_m * s.yaw_rate, speed);
  const double front =
      lateral_force(p, front_slip, load.front) * friction_ellipse(p, along.front, load.front);
  const double rear =
      lateral_force(p, rear_slip, load.rear) * friction_ellipse(p, along.rear, load.rear);

  const double sine = std::sin(s.steering_rad);
  const double cosine = std::cos(s.steering_rad);
  const double front_across = front * cosine + along.front * sine;
  double forward =
      (along.front * cosine + along.rear - front * sine) / p.mass_kg + s.yaw_rate * s.slip_mps;
  const double sideways = (front_across + rear) / p.mass_kg - s.yaw_rate * s.speed_mps;
  const double turning = (p.front_axle_m * front_across - p.rear_axle_m * rear) / p.inertia;

  const double dynamic =
      std::clamp((s.speed_mps - kKinematicSpeed) / (kDynamicSpeed - kKinematicSpeed), 0.0, 1.0);
  if (dynamic < 1) forward = dynamic * forward + (1 - dynamic) * s.acceleration;
  s.speed_mps = std::max(0.0, s.speed_mps + forward * dt);
  s.slip_mps += sideways * dt;
  s.yaw_rate += turning * dt;
  if (dynamic < 1) {
    const double yaw_rate = s.speed_mps * std::tan(s.steering_rad) / p.wheelbase_m();
    s.slip_mps = dynamic * s.slip_mps + (1 - dynamic) * (yaw_rate * p.rear_axle_m);
    s.yaw_rate = dynamic * s.yaw_rate + (1 - dynamic) * yaw_rate;
  }
  s.heading_rad += s.yaw_rate * dt;
  const double c = std::cos(s.heading_rad);
  const double n = std::sin(s.heading_rad);
  s.x_m += (s.speed_mps * c - s.slip_mps * n) * dt;
  s.y_m += (s.speed_mps * n + s.slip_mps * c) * dt;
}

}  // namespace jaywalk::lane
