// SPDX-License-Identifier: Apache-2.0
#pragma once

// Everything about the motorway world that is a number or a choice: a straight carriageway on which
// an automated vehicle (AV) keeps its lane and agents drive vehicles. Lanes count from the left,
// from 1; lengths are in metres, speeds in metres per second.

#include <optional>
#include <vector>

#include "env/config/reader.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

struct MotorwayParameters {
  int lanes = 3;
  double lane_m = 3.5;
  double length_m = 1000;
  double tick_s = 0.5;

  struct AutomatedVehicle {
    int lane = 2;
    /// Where its front begins, and the speed that it keeps unless it brakes.
    double start_m = 100;
    double speed_mps = 30;
    double length_m = 4.5;
    double width_m = 1.8;
    VehicleParameters vehicle{.model = "idm"};
    /// See AvParameters::twin of the crossing.
    std::optional<VehicleParameters> twin;

    friend bool operator==(const AutomatedVehicle&, const AutomatedVehicle&) = default;
  } av;

  /// The vehicles that agents drive.
  struct Drivers {
    double greatest_speed_mps = 40;
    double acceleration_mps2 = 3;
    double braking_mps2 = 8;
    /// How long a change of lanes takes.
    double change_s = 2;
    /// Other agents' vehicles no further away than this are perceived.
    double sight_m = 150;
    /// They begin so far ahead of the AV's front, at the AV's speed, in other lanes than its own.
    double start_from_m = -60;
    double start_to_m = 40;

    friend bool operator==(const Drivers&, const Drivers&) = default;
  } drivers;

  /// The precondition: an agent has entered the AV's lane in front of it, no further ahead than
  /// the AV drives in this many seconds.
  double headway_s = 1;
  /// For how many ticks a test goes on after that.
  int aftermath = 10;
  double time_limit_s = 60;
  /// The cost of each agent and tick until the precondition, and the reward for meeting it.
  double cost = 1;
  double reward = 100;

  friend bool operator==(const MotorwayParameters&, const MotorwayParameters&) = default;
};

[[nodiscard]] std::vector<ParameterProblem> problems(const MotorwayParameters& parameters);

/// The middle of a lane, from the carriageway's left.
[[nodiscard]] inline double middle_of_lane(const MotorwayParameters& parameters, int lane) {
  return (lane - 0.5) * parameters.lane_m;
}

}  // namespace jaywalk
