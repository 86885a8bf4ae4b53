// SPDX-License-Identifier: Apache-2.0
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

SpeedPlan::SpeedPlan(const Path& path, const SpeedPlanParameters& parameters)
    : parameters_(parameters) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    squares_.push_back(parameters.lateral_acceleration /
                       std::max(1e-5, std::fabs(path.curvature(i))));
  }
}

double SpeedPlan::acceleration(const Path& path, std::size_t near, double speed_mps) const {
  const SpeedPlanParameters& p = parameters_;
  const double reaction = speed_mps * p.latency_s;
  double wanted2 = p.speed_limit_mps * p.speed_limit_mps;
  double distance = 0;  // to the point that asks for the least speed
  for (std::size_t i = near; i < path.size(); ++i) {
    const double arc = path.arc_m(i) - path.arc_m(near);
    if (arc > p.preview_m) break;
    const double ahead = std::max(0.0, arc - reaction);
    const double allowed2 = squares_[i] + 2 * p.braking * ahead;
    if (allowed2 >= wanted2) continue;
    wanted2 = allowed2;
    distance = ahead;
  }
  const double wanted = std::sqrt(wanted2);
  const double used = std::min(
      1.0, std::fabs(path.curvature(near)) * speed_mps * speed_mps / p.lateral_acceleration);
  const bool brakes = distance > 0 && speed_mps > wanted - 0.5;
  return std::clamp(p.gain * (wanted - speed_mps) - (brakes ? p.braking : 0), -p.most_braking,
                    p.most_acceleration * std::sqrt(1 - used * used));
}

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
