// SPDX-License-Identifier: Apache-2.0
#pragma once

// The scenario's settings for SUMO under `world.simulator`; the table of keys is in the .cpp file.

#include <optional>
#include <string>
#include <vector>

#include "env/simulator/parameters.h"

namespace jaywalk {

/// A car-following model of SUMO with its parameters, called as SUMO calls them.
struct SumoModel {
  /// `constant` is none of SUMO's: a vehicle that keeps its speed whatever comes.
  std::string name = "Krauss";
  double accel_mps2 = 2;
  /// The decelerations of usual and of hardest braking; not given: 4.5 and 9, or less if the AV's
  /// are less.
  std::optional<double> decel_mps2;
  std::optional<double> emergency_decel_mps2;
  double min_gap_m = 2.5;
  double tau_s = 1;
  /// How imperfectly it drives, 0 to 1; of the models that have it.
  double sigma = 0;
};

/// Vehicles that enter one after another.
struct SumoFlow {
  /// Counted from 1, from the AV's left; on a given map the lane of the route's first edge, from
  /// its outer side. 0: not given, the first, or on a map SUMO's choice.
  int lane = 0;
  /// On a given map: its edges.
  std::vector<std::string> route;
  /// Seconds from one vehicle to the next, on average.
  double every_s = 5;
  double speed_mps = 9;
  double length_m = 4.5;
  double width_m = 1.8;
  SumoModel model;
};

struct SumoSettings {
  SumoModel av;
  bool brakes_for_pedestrians = true;
  double step_s = 0.1;
  std::vector<SumoFlow> traffic;
  /// A given map: its file, the AV's way through it, and where on that way y = 0 is.
  std::string net;
  std::vector<std::string> route;
  double begin_m = 0;
};

/// The steps of a tick: SUMO counts in milliseconds, so as many as wanted or a few more. 0: the
/// tick is not a whole number of milliseconds.
[[nodiscard]] int sumo_steps(double tick_s, double step_s);

/// The settings in the parameters. REQUIRES: parameters without problems.
[[nodiscard]] SumoSettings sumo_settings(const SimulatorParameters& parameters);

}  // namespace jaywalk
