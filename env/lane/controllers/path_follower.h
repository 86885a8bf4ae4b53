// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shared by controllers that steer along a path at a planned speed: the car's place beside the
// path, its planned speed, the commands to its actuators. Each controller steers in its own way.
// Read path.h first.

#include <vector>

#include "env/lane/controller.h"
#include "env/lane/path.h"

namespace jaywalk::lane {

struct SpeedPlanParameters {
  double speed_limit_mps = 0;
  /// In curves, and when braking for them, m/s2.
  double lateral_acceleration = 4.6;
  double braking = 5.6;
  double preview_m = 22.5;
  double latency_s = 0;
  /// Acceleration per difference of speed, 1/s, and its bounds, m/s2.
  double gain = 2.7;
  double most_acceleration = 6.5;
  double most_braking = 8;
};

/// A speed for every point of a path: what its curvature allows, reached by braking in time.
class SpeedPlan {
 public:
  SpeedPlan(const Path& path, const SpeedPlanParameters& parameters);

  /// For a car beside point `near` of the path.
  [[nodiscard]] double acceleration(const Path& path, std::size_t near, double speed_mps) const;

 private:
  SpeedPlanParameters parameters_;
  std::vector<double> squares_;  // of each point's speed
};

class PathFollower {
 public:
  /// The last parameters of such a controller, in this order.
  enum Parameter : std::size_t {
    kLateralAcceleration,
    kPlannedBraking,
    kPreview,
    kSpeedGain,
    kMostAcceleration,
    kMostBraking,
    kLatency,
    kSteeringLag,
    kSteeringRate,
  };
  static constexpr std::size_t kParameters = kSteeringRate + 1;

  /// The objects that the setup refers to must outlive the follower.
  PathFollower(const ControllerSetup& setup, const Polyline& path);

  /// Sets the place of the car, or of the part of it that follows the path.
  void move_to(const Point& place);

  [[nodiscard]] const Path& path() const { return path_; }
  /// The path's point beside it, and its direction there.
  [[nodiscard]] std::size_t near() const { return near_; }
  [[nodiscard]] double heading() const { return path_.heading(near_); }
  /// The distance to the path; positive on its left side.
  [[nodiscard]] double lateral_m() const;

  /// Steers as far as the vehicle can, and accelerates as planned.
  [[nodiscard]] Command command(double steering_rad, double speed_mps) const;
  [[nodiscard]] Actuator actuator() const;

 private:
  const VehicleParameters& vehicle_;
  std::span<const double> values_;  // those of Parameter
  Path path_;
  SpeedPlan plan_;
  Point place_;
  std::size_t near_ = 0;
};

}  // namespace jaywalk::lane
