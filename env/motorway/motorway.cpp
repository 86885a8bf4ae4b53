// SPDX-License-Identifier: Apache-2.0
#include "env/motorway/motorway.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "env/vehicle/sight.h"

namespace jaywalk {
namespace {

/// No vehicle drives further at a time.
constexpr double kLongestStepS = 0.1;

double lateral_mps(const MotorwayParameters& parameters) {
  return parameters.lane_m / parameters.drivers.change_s;
}

}  // namespace

MotorwayVocabulary::MotorwayVocabulary(SymbolTable& symbols)
    : left_(Value::atom(symbols.predicate("left", 0))),
      right_(Value::atom(symbols.predicate("right", 0))) {
  const auto intern = [&symbols](const EnvironmentWord& word) {
    return symbols.predicate(functor(word), static_cast<std::uint16_t>(arity(word)));
  };
  for (std::size_t i = 0; i < percepts_.size(); ++i) percepts_[i] = intern(kMotorwayPercepts[i]);
  for (std::size_t i = 0; i < actions_.size(); ++i) actions_[i] = intern(kMotorwayActions[i]);
}

Motorway::Motorway(const MotorwayParameters& parameters, const MotorwayVocabulary& vocabulary,
                   std::vector<MotorwayVehicle> vehicles)
    : parameters_(parameters),
      vocabulary_(vocabulary),
      vehicles_(std::move(vehicles)),
      controller_(make_controller(parameters.av.vehicle)),
      av_front_m_(parameters.av.start_m),
      av_speed_mps_(parameters.av.speed_mps) {
  for (int lane = 0; lane < parameters_.lanes; ++lane) {
    lanes_.push_back({lane * parameters_.lane_m, (lane + 1) * parameters_.lane_m, false});
  }
  result_.agents.resize(vehicles_.size());
}

void Motorway::begin(DriveBriefing briefing) {
  if (!controller_) return;
  briefing.road_m = parameters_.length_m;
  briefing.cruise_mps = parameters_.av.speed_mps;
  controller_->begin(briefing);
}

void Motorway::end() {
  if (!controller_) return;
  DriveEnd end{.why = result_.end, .impact_mps = {}};
  if (!result_.collisions.empty()) end.impact_mps = result_.collisions.front().impact_mps;
  controller_->end(end);
}

void Motorway::perceive(AgentId agent, Percepts& percepts) const {
  using enum MotorwayPercept;
  const auto index = static_cast<std::size_t>(agent);
  assert(index < vehicles_.size() && "every agent has a vehicle");
  const MotorwayVehicle& self = vehicles_[index];
  const auto add = [&](MotorwayPercept percept, auto... args) {
    percepts.add(vocabulary_.percept(percept), {Value::number(static_cast<double>(args))...});
  };
  add(tick, ticks_ + 1);
  add(lane, lane_of(self));
  if (self.changing) add(changing, self.lane);
  add(front, self.front_m);
  add(speed, self.speed_mps);
  add(av, parameters_.av.lane, av_front_m_ - self.front_m, av_speed_mps_);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const MotorwayVehicle& other = vehicles_[i];
    const double ahead = other.front_m - self.front_m;
    if (i == index || std::fabs(ahead) > parameters_.drivers.sight_m) continue;
    add(vehicle, i + 1, lane_of(other), ahead, other.speed_mps);
  }
  for (const std::size_t each : result_.met_by) add(precondition_met, each + 1);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const bool seen = std::fabs(vehicles_[i].front_m - self.front_m) <= parameters_.drivers.sight_m;
    if (vehicles_[i].crashed && seen) add(crashed, i + 1);
  }
  add(id, index + 1);
  constants(percepts);
}

void Motorway::constants(Percepts& percepts) const {
  using enum MotorwayPercept;
  const auto add = [&](MotorwayPercept percept, double number) {
    percepts.add(vocabulary_.percept(percept), {Value::number(number)});
  };
  add(lanes, parameters_.lanes);
  add(road_length, parameters_.length_m);
  add(vehicle_length, size_of(ActorKind::vehicle).length_m);
  add(greatest_speed, parameters_.drivers.greatest_speed_mps);
  add(tick_length, parameters_.tick_s);
  add(headway, parameters_.headway_s);
}

void Motorway::execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) {
  assert(actions.size() == results.size());
  for (MotorwayVehicle& each : vehicles_) {
    // A vehicle that does not act in a tick keeps its speed; a wreck goes on braking.
    each.acceleration_mps2 = each.crashed ? -parameters_.drivers.braking_mps2 : 0;
    each.failed = false;
  }
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const auto agent = static_cast<std::size_t>(actions[i].agent);
    results[i].reason = act(actions[i], vehicles_[agent]);
    results[i].succeeded = results[i].reason.empty();
    vehicles_[agent].failed = !results[i].succeeded;
    if (results[i].succeeded) ++result_.agents[agent].actions;
  }
}

// Why it cannot be done; empty if it is.
std::string Motorway::act(const ActionRequest& action, MotorwayVehicle& vehicle) {
  using enum MotorwayAction;
  if (vehicle.crashed) return "it has crashed";
  if (action.predicate == vocabulary_.action(keep)) return {};
  if (action.predicate == vocabulary_.action(MotorwayAction::change_lane)) {
    return this->change_lane(action.args[0], vehicle);
  }
  const bool gathers = action.predicate == vocabulary_.action(accelerate);
  if (!gathers && action.predicate != vocabulary_.action(brake)) {
    return "unknown action, expected accelerate(A), brake(A), change_lane(Way) or keep";
  }
  if (!action.args[0].is_number() || !(action.args[0].as_number() >= 0)) {
    return "an acceleration is a number, at least 0";
  }
  const double most =
      gathers ? parameters_.drivers.acceleration_mps2 : parameters_.drivers.braking_mps2;
  const double by = std::min(action.args[0].as_number(), most);
  vehicle.acceleration_mps2 = gathers ? by : -by;
  return {};
}

std::string Motorway::change_lane(Value way, MotorwayVehicle& vehicle) {
  const bool to_left = way.same_as(vocabulary_.left());
  if (!to_left && !way.same_as(vocabulary_.right())) {
    return "unknown way to change lanes, expected left or right";
  }
  if (vehicle.changing) return fmt::format("it is changing to lane {} already", vehicle.lane);
  const int lane = vehicle.lane + (to_left ? -1 : 1);
  if (lane < 1 || lane > parameters_.lanes) {
    return fmt::format("there is no lane to the {} of lane {}", to_left ? "left" : "right",
                       vehicle.lane);
  }
  vehicle.lane = lane;
  vehicle.changing = true;
  const auto agent = static_cast<std::size_t>(&vehicle - vehicles_.data());
  events_.push_back({ticks_ + 1, agent + 1, "lane_change", fmt::format("to lane {}", lane)});
  return {};
}

void Motorway::advance() {
  ++ticks_;
  const double tick_s = parameters_.tick_s;
  // The AV decides once in each period; all vehicles then drive in steps short enough that none
  // jumps over another.
  const double wanted_s = parameters_.av.vehicle.period_s;
  int periods = wanted_s > 0 ? std::max(1, static_cast<int>(std::lround(tick_s / wanted_s))) : 1;
  if (controller_) periods = std::max(periods, periods_of(*controller_, tick_s));
  const double period_s = tick_s / periods;
  const int steps = std::max(1, static_cast<int>(std::ceil(period_s / kLongestStepS)));
  for (int period = 0; period < periods; ++period) {
    const double braking = decide((ticks_ - 1) * tick_s + period * period_s, period_s);
    for (int step = 0; step < steps; ++step) drive(period_s / steps, braking);
  }
  settle();
}

double Motorway::decide(double time_s, double period_s) {
  if (!controller_) return 0;
  const Rectangle own = av_box();
  const Sight sight{.body = {own.left, own.right},
                    .front_m = av_front_m_,
                    .length_m = parameters_.av.length_m,
                    .range_m = parameters_.av.vehicle.range_m,
                    .obstacles = {}};
  std::vector<SeenActor> seen;
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const MotorwayVehicle& each = vehicles_[i];
    const auto actor = see(sight, {static_cast<std::uint32_t>(i + 1), ActorKind::vehicle,
                                   box_of(each), each.speed_mps, heading_rad(each)});
    if (actor) seen.push_back(*actor);
  }
  const SeenLane& lane = lanes_[static_cast<std::size_t>(parameters_.av.lane - 1)];
  return controller_
      ->decide({.time_s = time_s,
                .period_s = period_s,
                .speed_mps = av_speed_mps_,
                .cruise_mps = parameters_.av.speed_mps,
                .left_m = own.left,
                .right_m = own.right,
                .lane_left_m = lane.left_m,
                .lane_right_m = lane.right_m,
                .actors = seen,
                .stop_lines = {},
                .obstacles = {},
                .front_m = av_front_m_,
                .length_m = parameters_.av.length_m,
                .range_m = parameters_.av.vehicle.range_m,
                .lanes = lanes_})
      .acceleration_mps2;
}

void Motorway::drive(double step_s, double av_acceleration_mps2) {
  const Motion motion =
      drive_on(av_speed_mps_, av_acceleration_mps2 * step_s, parameters_.av.speed_mps, step_s);
  av_speed_mps_ = motion.speed;
  av_front_m_ += motion.way;
  for (MotorwayVehicle& each : vehicles_) drive(step_s, each);
  crash();
  touch();
  if (!result_.success) look_for_precondition();
}

void Motorway::drive(double step_s, MotorwayVehicle& vehicle) const {
  const Motion motion = drive_on(vehicle.speed_mps, vehicle.acceleration_mps2 * step_s,
                                 parameters_.drivers.greatest_speed_mps, step_s);
  vehicle.speed_mps = motion.speed;
  vehicle.front_m += motion.way;
  // A standing vehicle does not change lanes.
  if (!vehicle.changing || motion.way <= 0) return;
  const double target = middle_of_lane(parameters_, vehicle.lane);
  const double step = lateral_mps(parameters_) * step_s;
  if (std::fabs(target - vehicle.x_m) <= step + 1e-9) {
    vehicle.x_m = target;
    vehicle.changing = false;
  } else {
    vehicle.x_m += std::copysign(step, target - vehicle.x_m);
  }
}

void Motorway::crash() {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    for (std::size_t j = i + 1; j < vehicles_.size(); ++j) {
      // One of a pair may have crashed before; the other one crashes now.
      if (vehicles_[i].crashed && vehicles_[j].crashed) continue;
      if (!box_of(vehicles_[i]).overlaps(box_of(vehicles_[j]))) continue;
      wreck(i, j);
      wreck(j, i);
    }
  }
}

void Motorway::wreck(std::size_t index, std::size_t other) {
  MotorwayVehicle& vehicle = vehicles_[index];
  if (vehicle.crashed) return;
  vehicle.crashed = true;
  vehicle.changing = false;
  vehicle.acceleration_mps2 = -parameters_.drivers.braking_mps2;
  events_.push_back({ticks_, index + 1, "crash", fmt::format("with v{}", other + 1)});
}

void Motorway::touch() {
  const Rectangle own = av_box();
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const bool known = std::ranges::any_of(result_.collisions,
                                           [i](const Collision& each) { return each.body == i; });
    if (known || !own.overlaps(box_of(vehicles_[i]))) continue;
    result_.collisions.push_back({i, ticks_, std::fabs(av_speed_mps_ - vehicles_[i].speed_mps)});
  }
}

void Motorway::look_for_precondition() {
  const SeenLane& lane = lanes_[static_cast<std::size_t>(parameters_.av.lane - 1)];
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const Rectangle box = box_of(vehicles_[i]);
    // Some part of the vehicle in the AV's lane is enough: cutting in begins at the lane's edge.
    const double gap_m = box.near - av_front_m_;
    if (box.right <= lane.left_m || box.left >= lane.right_m) continue;
    if (gap_m < 0 || gap_m > parameters_.headway_s * av_speed_mps_) continue;
    result_.success = true;
    result_.met_by.push_back(i);
    result_.agents[i].reward = parameters_.reward;
  }
}

void Motorway::settle() {
  // Until the tick of the precondition, itself included, time costs.
  if (!scored_) {
    result_.ticks = ticks_;
    for (AgentOutcome& each : result_.agents) each.cost += parameters_.cost;
    scored_ = result_.success;
  }
  result_.all_ticks = ticks_;
  if (result_.success && ticks_ >= result_.ticks + parameters_.aftermath) {
    result_.end = "precondition";
  } else if (!result_.collisions.empty()) {
    result_.end = "collision";
  } else if (av_front_m_ >= parameters_.length_m) {
    result_.end = "road_end";
  } else if (ticks_ * parameters_.tick_s >= parameters_.time_limit_s) {
    result_.end = "time_limit";
  }
}

int Motorway::lane_of(const MotorwayVehicle& vehicle) const {
  const int lane = 1 + static_cast<int>(std::floor(vehicle.x_m / parameters_.lane_m));
  return std::clamp(lane, 1, parameters_.lanes);
}

double Motorway::heading_rad(const MotorwayVehicle& vehicle) const {
  constexpr double kAhead = std::numbers::pi / 2;
  if (!vehicle.changing || vehicle.speed_mps <= 0) return kAhead;
  const double to_right = middle_of_lane(parameters_, vehicle.lane) - vehicle.x_m;
  return kAhead - std::copysign(std::atan2(lateral_mps(parameters_), vehicle.speed_mps), to_right);
}

Rectangle Motorway::box_of(const MotorwayVehicle& vehicle) const {
  const BoxSize size = size_of(ActorKind::vehicle);
  return {vehicle.x_m - size.width_m / 2, vehicle.x_m + size.width_m / 2,
          vehicle.front_m - size.length_m, vehicle.front_m};
}

Rectangle Motorway::av_box() const {
  const double x = middle_of_lane(parameters_, parameters_.av.lane);
  const double half = parameters_.av.width_m / 2;
  return {x - half, x + half, av_front_m_ - parameters_.av.length_m, av_front_m_};
}

std::vector<Actor> Motorway::actors() const {
  std::vector<Actor> all{
      {"av", ActorKind::vehicle, parameters_.av.length_m, parameters_.av.width_m}};
  const BoxSize size = size_of(ActorKind::vehicle);
  for (std::size_t i = 1; i <= vehicles_.size(); ++i) {
    all.push_back({fmt::format("v{}", i), ActorKind::vehicle, size.length_m, size.width_m});
  }
  return all;
}

Scene Motorway::scene() const {
  const Point middle = av_box().middle();
  Scene scene{{middle.x_m, middle.y_m, av_speed_mps_, std::numbers::pi / 2}};
  for (const MotorwayVehicle& each : vehicles_) {
    const Point at = box_of(each).middle();
    scene.push_back({at.x_m, at.y_m, each.speed_mps, heading_rad(each)});
  }
  return scene;
}

}  // namespace jaywalk
