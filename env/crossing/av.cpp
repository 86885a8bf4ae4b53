// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/av.h"

#include <algorithm>
#include <cmath>

#include "env/crossing/layout.h"

namespace jaywalk {

struct Av::Surroundings {
  int tick = 0;
  std::span<const RoadUser> bodies;
  std::span<const SignalColour> signals;
  const Layout& layout;
};

namespace {

std::vector<SeenLane> lanes_of(const CrossingParameters& parameters) {
  std::vector<SeenLane> lanes;
  // A drawn ground has no bands from which lanes could be read.
  if (!parameters.map.empty()) return lanes;
  const std::vector<Interval> rows = band_rows(parameters);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (parameters.bands[i].kind != BandKind::lane) continue;
    lanes.push_back({rows[i].first * parameters.cell_m, (rows[i].last + 1) * parameters.cell_m,
                     parameters.bands[i].direction == Direction::back});
  }
  return lanes;
}

}  // namespace

Av::Av(const CrossingParameters& parameters, int head_start)
    : parameters_(parameters),
      controller_(make_controller(parameters.av.vehicle)),
      simulated_(parameters.simulator.name.empty() ? nullptr
                                                   : std::make_unique<SimulatedDrive>(parameters)),
      obstacles_(obstacles(parameters)),
      lanes_(controller_ ? lanes_of(parameters) : std::vector<SeenLane>()),
      cell_mps_(parameters.cell_m / parameters.tick_s),
      driven_(head_start),
      speed_(parameters.av.speed) {}

void Av::begin(DriveBriefing briefing, const std::vector<Actor>& actors, const Scene& scene) {
  if (simulated_) {
    simulated_->begin(briefing, actors, scene);
    follow_simulator();
  }
  if (!controller_) return;
  briefing.road_m = grid(parameters_).cells * parameters_.cell_m;
  briefing.cruise_mps = parameters_.av.speed * cell_mps_;
  controller_->begin(briefing);
}

void Av::end(const DriveEnd& end) {
  if (simulated_) simulated_->end(end);
  if (controller_) controller_->end(end);
}

std::vector<std::string> Av::take_notes() {
  if (simulated_) return simulated_->take_notes();
  return controller_ ? controller_->take_notes() : std::vector<std::string>();
}

std::string Av::failure() const {
  if (simulated_) return simulated_->failure();
  return controller_ ? controller_->failure() : "";
}

Actor Av::actor() const {
  const double cell = parameters_.cell_m;
  return {"av", ActorKind::vehicle, parameters_.av.length * cell,
          parameters_.av.rows.size() * cell};
}

ActorState Av::state() const {
  if (simulated_ && begun_) return simulated_->av().state;
  const AvParameters& av = parameters_.av;
  const double cell = parameters_.cell_m;
  return {(av.rows.first + av.rows.last + 1) / 2.0 * cell, front_m() - av.length * cell / 2,
          speed_mps(), heading_rad(Direction::forward)};
}

void Av::follow_simulator() {
  begun_ = true;
  // A drive of whole cells comes to whole cells, even where it is reckoned in single precision.
  constexpr double kParts = 1e5;
  const double half_m = parameters_.av.length * parameters_.cell_m / 2;
  const ActorState& at = simulated_->av().state;
  const double front = (at.y_m + std::sin(at.heading_rad) * half_m) / parameters_.cell_m;
  driven_ = std::round((front - parameters_.av.start - 1) * kParts) / kParts;
  speed_ = std::round(at.speed_mps / cell_mps_ * kParts) / kParts;
}

double Av::front_m() const { return (parameters_.av.start + driven_ + 1) * parameters_.cell_m; }

std::vector<SeenActor> Av::look(const Surroundings& around) const {
  const double cell = parameters_.cell_m;
  const AvParameters& av = parameters_.av;
  const Sight sight{.body = {av.rows.first * cell, (av.rows.last + 1) * cell},
                    .front_m = front_m(),
                    .length_m = av.length * cell,
                    .range_m = av.vehicle.range_m,
                    .obstacles = obstacles_};
  std::vector<SeenActor> seen;
  for (std::size_t i = 0; i < around.bodies.size(); ++i) {
    const RoadUser& body = around.bodies[i];
    if (body.kind == ActorKind::signal) continue;
    const auto actor =
        see(sight, {static_cast<std::uint32_t>(i + 1), body.kind, box_of(body, cell),
                    body.step_in(around.tick) * cell_mps_, heading_rad(body.facing)});
    if (actor) seen.push_back(*actor);
  }
  return seen;
}

std::vector<StopLine> Av::stop_lines(const Surroundings& around) const {
  std::vector<StopLine> lines;
  for (std::size_t i = 0; i < parameters_.crosswalks.size(); ++i) {
    const Crosswalk& crosswalk = parameters_.crosswalks[i];
    const bool occupied = std::ranges::any_of(around.bodies, [&](const RoadUser& body) {
      const Position at = cell(body.place);
      return body.kind == ActorKind::pedestrian && crosswalk.cells.contains(at.y) &&
             around.layout.at(at) == Surface::crosswalk;
    });
    const bool closed = crosswalk.kind == CrosswalkKind::zebra
                            ? occupied
                            : around.signals[i] != SignalColour::green;
    lines.push_back({crosswalk.cells.first * parameters_.cell_m - front_m(), closed});
  }
  return lines;
}

std::vector<SeenObstacle> Av::seen_obstacles() const {
  std::vector<SeenObstacle> seen;
  for (const Rectangle& each : obstacles_) {
    seen.push_back({each.near - front_m(), each.far - front_m(), each.left, each.right});
  }
  return seen;
}

double Av::decide(double time_s, double period_s, const Surroundings& around) {
  if (!controller_) return 0;
  const double cell = parameters_.cell_m;
  // An AV that drives off the lanes has its own rows as its lane.
  const Interval lane = av_lane(parameters_).empty() ? parameters_.av.rows : av_lane(parameters_);
  const std::vector<SeenActor> actors = look(around);
  const std::vector<StopLine> lines = stop_lines(around);
  const std::vector<SeenObstacle> obstacles = seen_obstacles();
  return controller_
      ->decide({.time_s = time_s,
                .period_s = period_s,
                .speed_mps = speed_mps(),
                .cruise_mps = parameters_.av.speed * cell_mps_,
                .left_m = parameters_.av.rows.first * cell,
                .right_m = (parameters_.av.rows.last + 1) * cell,
                .lane_left_m = lane.first * cell,
                .lane_right_m = (lane.last + 1) * cell,
                .actors = actors,
                .stop_lines = lines,
                .obstacles = obstacles,
                .front_m = front_m(),
                .length_m = parameters_.av.length * cell,
                .range_m = parameters_.av.vehicle.range_m,
                .lanes = lanes_})
      .acceleration_mps2;
}

int Av::periods() const {
  if (!controller_) return 1;
  const double wanted = parameters_.av.vehicle.period_s;
  const int as_wanted =
      wanted > 0 ? std::max(1, static_cast<int>(std::lround(parameters_.tick_s / wanted))) : 1;
  // A model that needs to decide oftener does, whatever the scenario says.
  return std::max(as_wanted, periods_of(*controller_, parameters_.tick_s));
}

std::vector<Collision> Av::drive(int tick, std::span<const RoadUser> bodies,
                                 std::span<const SignalColour> signals, const Layout& layout,
                                 std::span<const Collision> hit) {
  if (simulated_) {
    std::vector<Collision> collisions = simulated_->drive(tick, bodies, signals, hit);
    follow_simulator();
    return collisions;
  }
  const Surroundings around{tick, bodies, signals, layout};
  const int periods = this->periods();
  const double period_s = parameters_.tick_s / periods;
  std::vector<Collision> collisions;
  const auto touched = [&](std::size_t body) {
    return std::ranges::any_of(hit, [&](const Collision& c) { return c.body == body; }) ||
           std::ranges::any_of(collisions, [&](const Collision& c) { return c.body == body; });
  };
  for (int period = 0; period < periods; ++period) {
    const double acceleration =
        decide((tick - 1) * parameters_.tick_s + period * period_s, period_s, around);
    // The rear before it drives and the front after it: all that its box sweeps in this period.
    const double rear_m = front_m() - parameters_.av.length * parameters_.cell_m;
    // In cells per tick, and in cells.
    const Motion next =
        drive_on(speed_, acceleration / cell_mps_ * period_s, parameters_.av.speed, 1.0 / periods);
    speed_ = next.speed;
    driven_ += next.way;
    const Interval rows = parameters_.av.rows;
    const Rectangle swept{rows.first * parameters_.cell_m, (rows.last + 1) * parameters_.cell_m,
                          rear_m, front_m()};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].kind == ActorKind::signal || touched(i)) continue;
      if (!swept.overlaps(box_of(bodies[i], parameters_.cell_m))) continue;
      collisions.push_back({i, tick, speed_mps()});
    }
  }
  return collisions;
}

}  // namespace jaywalk
