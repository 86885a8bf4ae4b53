// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/simulated_drive.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "env/crossing/av.h"
#include "env/crossing/layout.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

/// How far the simulator may put the AV from its start, in metres, and its clock from ours.
constexpr double kNearStartM = 0.5;
constexpr double kSameTimeS = 1e-6;
/// No road is as long, and no vehicle as fast.
constexpr double kMostM = 1e6;
constexpr double kMostMps = 1000;
/// Boxes that touch without overlapping do not collide.
constexpr double kSkinM = 1e-9;

SimulatedRoad road_of(const CrossingParameters& parameters) {
  const double cell = parameters.cell_m;
  SimulatedRoad road{
      .length_m = grid(parameters).cells * cell, .bands = {}, .ground = ground(parameters)};
  if (!parameters.map.empty()) return road;
  const std::vector<Interval> rows = band_rows(parameters);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Band& band = parameters.bands[i];
    const bool lane = band.kind == BandKind::lane;
    road.bands.push_back({.kind = lane ? AreaKind::lane : AreaKind::pavement,
                          .left_m = rows[i].first * cell,
                          .right_m = (rows[i].last + 1) * cell,
                          .oncoming = lane && band.direction == Direction::back});
  }
  return road;
}

std::string wrong_state(std::string_view who, const SimulatedVehicle& vehicle) {
  const ActorState& state = vehicle.state;
  const auto problem = [who](std::string_view what, double value) {
    return fmt::format("the {} of '{}' is {:g}", what, who, value);
  };
  if (!vehicle.present) return {};
  // Written so that a NaN is wrong, too.
  if (!(std::fabs(state.x_m) <= kMostM)) return problem("x", state.x_m);
  if (!(std::fabs(state.y_m) <= kMostM)) return problem("y", state.y_m);
  if (!(state.speed_mps >= 0 && state.speed_mps <= kMostMps)) {
    return problem("speed", state.speed_mps);
  }
  if (!std::isfinite(state.heading_rad)) return problem("heading", state.heading_rad);
  if (!std::isfinite(vehicle.acceleration_mps2)) {
    return problem("acceleration", vehicle.acceleration_mps2);
  }
  return {};
}

ActorState state_at(GridPoint place, double speed_mps, Direction facing, double cell_m) {
  return {(place.x + 0.5) * cell_m, (place.y + 0.5) * cell_m, speed_mps, heading_rad(facing)};
}

double front_y(const ActorState& state, double length_m) {
  return state.y_m + std::sin(state.heading_rad) * length_m / 2;
}

}  // namespace

SimulatedSite simulated_site(const CrossingParameters& parameters) {
  const Av av(parameters, 0);
  return {.road = road_of(parameters),
          .av = av.actor(),
          .av_start = av.state(),
          .vehicle = parameters.av.vehicle,
          .tick_s = parameters.tick_s};
}

SimulatedDrive::SimulatedDrive(const CrossingParameters& parameters)
    : parameters_(parameters), road_(road_of(parameters)) {}

void SimulatedDrive::fail(std::string_view why) {
  failure_ = fmt::format("the simulator '{}': {}", parameters_.simulator.name, why);
}

void SimulatedDrive::begin(const DriveBriefing& briefing, std::vector<Actor> actors, Scene starts) {
  body_ = actors.front();
  now_.av.state = starts.front();
  actors_.assign(actors.begin() + 1, actors.end());
  starts_.assign(starts.begin() + 1, starts.end());
  simulator_ = &briefing.simulators->of(parameters_.simulator);
  const SimulatedTest test{.test = briefing.test,
                           .seed = briefing.seed,
                           .behaviour = briefing.behaviour,
                           .agents = briefing.agents,
                           .tick_s = parameters_.tick_s,
                           .road = road_,
                           .av = body_,
                           .av_start = now_.av.state,
                           .cruise_mps = now_.av.state.speed_mps,
                           .vehicle = parameters_.av.vehicle,
                           .actors = actors_,
                           .starts = starts_};
  SimulatedStart start;
  std::string why = simulator_->begin(test, start);
  if (why.empty()) why = wrong_start(start);
  if (!why.empty()) return fail(why);
  traffic_ = std::move(start.traffic);
  now_ = std::move(start.scene);
}

std::string SimulatedDrive::wrong_start(const SimulatedStart& start) const {
  std::set<std::string_view> names{body_.name};
  for (const Actor& each : actors_) names.insert(each.name);
  for (const Actor& each : start.traffic) {
    if (each.name.empty()) return "a vehicle of its traffic has no name";
    if (!is_label(each.name)) return fmt::format("'{}' cannot be the name of an actor", each.name);
    if (!names.insert(each.name).second) return fmt::format("a second actor '{}'", each.name);
    if (each.kind == ActorKind::signal) return fmt::format("'{}' is a signal", each.name);
    if (!(each.length_m > 0 && each.width_m > 0 && each.length_m < 100 && each.width_m < 100)) {
      return fmt::format("'{}' is {:g} m long and {:g} m wide", each.name, each.length_m,
                         each.width_m);
    }
  }
  if (start.scene.traffic.size() != start.traffic.size()) return "not every vehicle has a state";
  if (std::string why = wrong(start.scene); !why.empty()) return why;
  const double wanted = front_y(now_.av.state, body_.length_m);
  const double found = front_y(start.scene.av.state, body_.length_m);
  if (std::fabs(found - wanted) <= kNearStartM) return {};
  return fmt::format("the front of the AV begins at y = {:g} m, expected {:g} m", found, wanted);
}

std::string SimulatedDrive::wrong(const SimulatedScene& scene) const {
  if (!scene.av.present) return "the AV has left the simulation";
  if (std::string why = wrong_state("av", scene.av); !why.empty()) return why;
  for (const SimulatedVehicle& each : scene.traffic) {
    if (std::string why = wrong_state("traffic", each); !why.empty()) return why;
  }
  return {};
}

std::string SimulatedDrive::wrong(const std::vector<SimulatedScene>& scenes,
                                  const SimulatedTick& tick) const {
  double time_s = tick.begin_s;
  for (const SimulatedScene& each : scenes) {
    if (std::string why = wrong(each); !why.empty()) {
      return fmt::format("{} at {:g} s", why, each.time_s);
    }
    if (each.traffic.size() != traffic_.size()) return "its traffic has changed within the test";
    if (!(each.time_s > time_s)) {
      return fmt::format("its time goes from {:g} s to {:g} s", time_s, each.time_s);
    }
    time_s = each.time_s;
  }
  const double wanted = tick.begin_s + tick.length_s;
  if (std::fabs(time_s - wanted) <= kSameTimeS) return {};
  return fmt::format("it is at {:g} s, expected {:g} s", time_s, wanted);
}

std::vector<SimulatedBody> SimulatedDrive::bodies_in(int tick,
                                                     std::span<const RoadUser> bodies) const {
  const double cell = parameters_.cell_m;
  std::vector<SimulatedBody> moved;
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    const RoadUser& body = bodies[i];
    const double step = body.step_in(tick);
    const double speed = step * cell / parameters_.tick_s;
    // A body makes at most one step in a tick.
    const GridPoint before = ahead_of(body.place, body.facing, -step);
    moved.push_back({.actor = i,
                     .before = state_at(before, speed, body.facing, cell),
                     .after = state_at(body.place, speed, body.facing, cell)});
  }
  return moved;
}

std::vector<ShownSignal> SimulatedDrive::shown(std::span<const SignalColour> signals) const {
  std::vector<ShownSignal> shown;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (parameters_.crosswalks[i].kind != CrosswalkKind::signalled) continue;
    shown.push_back({.crosswalk = i, .colour = name(signals[i])});
  }
  return shown;
}

ActorState SimulatedDrive::traffic_state(std::size_t index) const {
  if (now_.traffic[index].present) return now_.traffic[index].state;
  // Beside the road, and further away than the AV's sensors see.
  return {-parameters_.av.vehicle.range_m - 10, 0, 0, heading_rad(Direction::forward)};
}

bool SimulatedDrive::touches(const SimulatedScene& scene, std::size_t body,
                             const std::vector<SimulatedBody>& bodies, double share) const {
  // A simulator that reports contacts knows the shapes better than boxes do.
  if (scene.contacts) return std::ranges::find(*scene.contacts, body) != scene.contacts->end();
  const bool ours = body < actors_.size();
  if (!ours && !scene.traffic[body - actors_.size()].present) return false;
  const Actor& other = ours ? actors_[body] : traffic_[body - actors_.size()];
  const ActorState at =
      ours ? body_at(bodies[body], share) : scene.traffic[body - actors_.size()].state;
  // The area that the AV's box has swept since the scene before.
  const ActorState& from = now_.av.state;
  const ActorState& to = scene.av.state;
  Actor swept = body_;
  swept.length_m += std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) - kSkinM;
  swept.width_m -= kSkinM;
  const ActorState middle{(from.x_m + to.x_m) / 2, (from.y_m + to.y_m) / 2, to.speed_mps,
                          to.heading_rad};
  const double reach =
      std::hypot(swept.length_m, swept.width_m) / 2 + std::hypot(other.length_m, other.width_m) / 2;
  if (std::hypot(at.x_m - middle.x_m, at.y_m - middle.y_m) > reach) return false;
  return distance_m(box(swept, middle), box(other, at)) <= 0;
}

std::vector<Collision> SimulatedDrive::drive(int tick, std::span<const RoadUser> bodies,
                                             std::span<const SignalColour> signals,
                                             std::span<const Collision> hit) {
  std::vector<Collision> collisions;
  if (!failure_.empty()) return collisions;
  const std::vector<SimulatedBody> moved = bodies_in(tick, bodies);
  const std::vector<ShownSignal> colours = shown(signals);
  const SimulatedTick asked{.tick = static_cast<std::uint64_t>(tick),
                            .begin_s = (tick - 1) * parameters_.tick_s,
                            .length_s = parameters_.tick_s,
                            .bodies = moved,
                            .signals = colours};
  std::vector<SimulatedScene> scenes;
  std::string why = simulator_->advance(asked, scenes);
  if (why.empty()) why = wrong(scenes, asked);
  if (!why.empty()) {
    fail(why);
    return collisions;
  }
  const auto is_hit = [&](std::size_t body) {
    return std::ranges::find(hit, body, &Collision::body) != hit.end() ||
           std::ranges::find(collisions, body, &Collision::body) != collisions.end();
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    // Scenes are at equal distances in time, the last one at the end of the tick.
    const double share = static_cast<double>(i + 1) / static_cast<double>(scenes.size());
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      if (bodies[body].kind == ActorKind::signal || is_hit(body)) continue;
      if (!touches(scenes[i], body, moved, share)) continue;
      collisions.push_back({body, tick, scenes[i].av.state.speed_mps});
    }
    // The next scene's sweep begins here.
    now_ = std::move(scenes[i]);
  }
  return collisions;
}

void SimulatedDrive::end(const DriveEnd& end) {
  if (!failure_.empty()) return;
  if (const std::string why = simulator_->end(end); !why.empty()) fail(why);
}

}  // namespace jaywalk
