// SPDX-License-Identifier: Apache-2.0
#pragma once

// One test of a lane-keeping assistant: it drives a road, and how far the car leaves its lane is
// measured. A pure function of its arguments. Read controller.h first.

#include <vector>

#include "env/lane/controller.h"

namespace jaywalk::lane {

struct DriveSettings {
  VehicleParameters vehicle;
  const ControllerKind* controller = nullptr;
  /// In the order of the controller's parameters; REQUIRES: as many.
  std::vector<double> values;
  double speed_limit_mps = 300 / 3.6;
  /// The test ends once a larger share of the car is out of bounds.
  double tolerance = 0.95;
  double step_s = 0.005;
  double control_s = 0.02;
  double sample_s = 1.0 / 12;
  double most_s = 60;
  /// Where the car starts, and how near to the road's end it has arrived.
  double start_m = 2.5;
  double goal_m = 8;
  /// The car is stuck if it moves less than a metre in that time.
  double stuck_s = 10;
};

/// With that controller and its default values.
[[nodiscard]] DriveSettings drive_settings(const ControllerKind& controller);

/// The car at one moment.
struct DriveSample {
  double time_s = 0;
  VehicleState car;
  /// The share of the car out of its lane, the distance from the lane's middle, and from its
  /// heading.
  double out_of_bounds = 0;
  double lateral_error_m = 0;
  double heading_error_rad = 0;
  /// Along the lane.
  double arc_m = 0;
};

enum class DriveEnd { arrived, out_of_bounds, stuck, time_over };

struct DriveResult {
  DriveEnd end = DriveEnd::time_over;
  double time_s = 0;
  double max_out_of_bounds = 0;
  /// The competition's oob_distance, 2 m less the distance from the lane's middle: its least value.
  double min_oob_distance_m = 2;
  double max_lateral_error_m = 0;
  double max_heading_error_rad = 0;
  double max_lateral_acceleration = 0;
  double max_speed_mps = 0;
  /// Where along the lane the largest share was out of bounds.
  double worst_arc_m = 0;
  std::vector<DriveSample> samples;
};

[[nodiscard]] DriveResult drive(const Road& road, const DriveSettings& settings);

}  // namespace jaywalk::lane
