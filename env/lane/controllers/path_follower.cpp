#include "env/lane/controllers/path_follower.h"

#include <algorithm>
#include <cmath>

namespace jaywalk::lane {
namespace {

SpeedPlanParameters speeds(std::span<const double> values, double speed_limit_mps) {
  return {.speed_limit_mps = speed_limit_mps,
          .lateral_acceleration = values[PathFollower::kLateralAcceleration],
          .braking = values[PathFollower::kPlannedBraking],
          .preview_m = values[PathFollower::kPreview],
          .latency_s = values[PathFollower::kLatency],
          .gain = values[PathFollower::kSpeedGain],
          .most_acceleration = values[PathFollower::kMostAcceleration],
          .most_braking = values[PathFollower::kMostBraking]};
}

}  // namespace

PathFollower::PathFollower(const ControllerSetup& setup, const Polyline& path)
    : vehicle_(setup.vehicle),
      values_(setup.values.last(kParameters)),
      path_(path),
      plan_(path_, speeds(values_, setup.speed_limit_mps)) {}

void PathFollower::move_to(const Point& place) {
  place_ = place;
  near_ = path_.nearest(place, near_);
}

double PathFollower::lateral_m() const {
  const Point& beside = path_.point(near_);
  return (place_.y_m - beside.y_m) * std::cos(heading()) -
         (place_.x_m - beside.x_m) * std::sin(heading());
}

Command PathFollower::command(double steering_rad, double speed_mps) const {
  return {plan_.acceleration(path_, near_, speed_mps),
          std::clamp(steering_rad, -vehicle_.most_steering_rad, vehicle_.most_steering_rad)};
}

Actuator PathFollower::actuator() const {
  return {values_[kLatency], values_[kSteeringLag], values_[kSteeringRate]};
}

}  // namespace jaywalk::lane
