// SPDX-License-Identifier: Apache-2.0
#include "env/lane/drive.h"

#include <algorithm>
#include <cmath>

#include "env/lane/out_of_bounds.h"
#include "env/lane/path.h"

namespace jaywalk::lane {
namespace {

/// Commands arrive a fixed number of control steps late.
class DelayLine {
 public:
  explicit DelayLine(std::size_t steps) : commands_(steps + 1) {}

  Command pass(const Command& command) {
    commands_[next_] = command;
    next_ = (next_ + 1) % commands_.size();
    return commands_[next_];
  }

 private:
  std::vector<Command> commands_;
  std::size_t next_ = 0;
};

/// Times are sums of steps; half a nanosecond is their error.
bool due(double time, double at) { return time >= at - 1e-9; }

class Drive {
 public:
  Drive(const Road& road, const DriveSettings& settings)
      : road_(road),
        settings_(settings),
        lane_(lane_centre(road)),
        controller_(settings.controller->make({.road = road,
                                               .vehicle = settings.vehicle,
                                               .values = settings.values,
                                               .speed_limit_mps = settings.speed_limit_mps,
                                               .start_m = settings.start_m})),
        actuator_(controller_->actuator()),
        delay_(static_cast<std::size_t>(
            std::max(0L, std::lround(actuator_.latency_s / settings.control_s)))) {
    car_.heading_rad = lane_.heading(0);
    car_.x_m = lane_.point(0).x_m + settings.start_m * std::cos(car_.heading_rad);
    car_.y_m = lane_.point(0).y_m + settings.start_m * std::sin(car_.heading_rad);
    moved_at_ = {car_.x_m, car_.y_m};
  }

  DriveResult run() {
    double next_sample = 0;
    double next_control = 0;
    while (time_ < settings_.most_s) {
      if (due(time_, next_sample)) {
        next_sample += settings_.sample_s;
        if (sample_ends()) break;
      }
      if (due(time_, next_control)) {
        next_control += settings_.control_s;
        command_ = delay_.pass(controller_->command(car_));
      }
      advance(car_, command_, settings_.vehicle, actuator_, settings_.step_s);
      result_.max_lateral_acceleration =
          std::max(result_.max_lateral_acceleration, std::fabs(car_.lateral_acceleration()));
      time_ += settings_.step_s;
    }
    result_.time_s = time_;
    return std::move(result_);
  }

 private:
  /// Takes a sample; whether the test is over.
  bool sample_ends() {
    const Point at{car_.x_m, car_.y_m};
    near_ = lane_.nearest(at, near_);
    DriveSample now{.time_s = time_, .car = car_};
    now.out_of_bounds = out_of_bounds_share(road_, car_, settings_.vehicle, near_);
    now.lateral_error_m = lane_.distance_m(at, near_);
    now.heading_error_rad = wrapped(car_.heading_rad - lane_.heading(near_));
    now.arc_m = lane_.arc_m(near_);
    note(now);
    if (lane::distance(at, road_.middle.back()) < settings_.goal_m) {
      result_.end = DriveEnd::arrived;
      return true;
    }
    if (lane::distance(at, moved_at_) > 1) {
      moved_at_ = at;
      moved_s_ = time_;
    } else if (time_ - moved_s_ > settings_.stuck_s) {
      result_.end = DriveEnd::stuck;
      return true;
    }
    if (now.out_of_bounds <= settings_.tolerance) return false;
    result_.end = DriveEnd::out_of_bounds;
    return true;
  }

  void note(const DriveSample& now) {
    DriveResult& r = result_;
    if (now.out_of_bounds > r.max_out_of_bounds) {
      r.max_out_of_bounds = now.out_of_bounds;
      r.worst_arc_m = now.arc_m;
    }
    r.min_oob_distance_m = std::min(r.min_oob_distance_m, kLaneWidth / 2 - now.lateral_error_m);
    r.max_lateral_error_m = std::max(r.max_lateral_error_m, now.lateral_error_m);
    r.max_heading_error_rad = std::max(r.max_heading_error_rad, std::fabs(now.heading_error_rad));
    r.max_speed_mps = std::max(r.max_speed_mps, car_.speed_mps);
    r.samples.push_back(now);
  }

  const Road& road_;
  const DriveSettings& settings_;
  Path lane_;
  std::unique_ptr<Controller> controller_;
  Actuator actuator_;
  DelayLine delay_;
  VehicleState car_;
  Command command_;
  std::size_t near_ = 0;
  double time_ = 0;
  Point moved_at_;
  double moved_s_ = 0;
  DriveResult result_;
};

}  // namespace

DriveSettings drive_settings(const ControllerKind& controller) {
  DriveSettings settings;
  settings.controller = &controller;
  for (const NumberParameter& parameter : controller.parameters) {
    settings.values.push_back(parameter.value);
  }
  return settings;
}

DriveResult drive(const Road& road, const DriveSettings& settings) {
  return Drive(road, settings).run();
}

}  // namespace jaywalk::lane
