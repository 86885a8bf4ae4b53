// SPDX-License-Identifier: Apache-2.0
#pragma once

// The car: a single-track model with saturating tyres, after CommonRoad's vehicle 2 (Althoff,
// Koschi and Manzinger 2017, "CommonRoad: composable benchmarks for motion planning on roads",
// vehicle models, BSD-3): a BMW 320i with lateral PAC2002 tyre forces, friction ellipse and load
// transfer. Its box is that of BeamNG's etk800, fitted to published traces.

namespace jaywalk::lane {

/// Metres, kilogrammes, seconds, radians.
struct VehicleParameters {
  double length_m = 4.69;
  double width_m = 2.04;
  double mass_kg = 1093.3;
  /// About the vertical axis, kg m^2.
  double inertia = 1791.6;
  /// From the centre of gravity to the axles, and its height above the ground.
  double front_axle_m = 1.1562;
  double rear_axle_m = 1.4227;
  double height_m = 0.574;
  /// Friction along and across the tyre, and the shape of its lateral force (PAC2002's C, K, E).
  double longitudinal_friction = 1.1739;
  double lateral_friction = 1.0489;
  double tyre_shape = 1.3507;
  double tyre_stiffness = 21.92;
  double tyre_curvature = -0.0074722;
  double most_steering_rad = 1.066;
  /// The front axle's share of the braking force.
  double brake_split = 0.66;
  /// The engine accelerates with most_acceleration up to switch_speed, then with constant power.
  double most_acceleration = 11.5;
  double switch_speed_mps = 7.319;

  [[nodiscard]] double wheelbase_m() const { return front_axle_m + rear_axle_m; }
};

struct VehicleState {
  /// The centre of gravity, which is taken as the middle of the box.
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
  /// Along and across the car; the speed along is never negative.
  double speed_mps = 0;
  double slip_mps = 0;
  double yaw_rate = 0;
  double steering_rad = 0;
  double acceleration = 0;

  [[nodiscard]] double lateral_acceleration() const { return yaw_rate * speed_mps; }
};

/// The lane-keeping assistant's decision.
struct Command {
  double acceleration = 0;
  double steering_rad = 0;
};

/// Between the command and the car: a pure delay, then a lag of first order and a limit of the rate
/// in the steering.
struct Actuator {
  double latency_s = 0;
  double steering_lag_s = 0.08;
  double steering_rate = 0.4;
};

/// Explicit Euler over `dt` seconds. Below 3 m/s the kinematic model takes over step by step.
void advance(VehicleState& state, const Command& command, const VehicleParameters& parameters,
             const Actuator& actuator, double dt);

/// The lateral force of a tyre in newtons at a slip angle, under a load in newtons.
[[nodiscard]] double lateral_force(const VehicleParameters& parameters, double slip_rad,
                                   double load);

}  // namespace jaywalk::lane
