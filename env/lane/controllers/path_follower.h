#pragma once

// What controllers have in common that steer along a path at a planned speed: where the car is
// beside it, how fast it is to go, what its actuators do. How it steers is the controller's own.
// Read speed_plan.h before.

#include "env/lane/controller.h"
#include "env/lane/controllers/speed_plan.h"

namespace jaywalk::lane {

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

  /// The car, or the part of it that is to follow the path, is there now.
  void move_to(const Point& place);

  [[nodiscard]] const Path& path() const { return path_; }
  /// The path's point beside it, and its direction there.
  [[nodiscard]] std::size_t near() const { return near_; }
  [[nodiscard]] double heading() const { return path_.heading(near_); }
  /// The distance to the path; positive to the left of it.
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
