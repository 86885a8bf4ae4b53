#include "env/crossing/av.h"

#include <algorithm>
#include <cmath>

namespace jaywalk {

struct Av::Surroundings {
  int tick = 0;
  std::span<const RoadUser> bodies;
  std::span<const SignalColour> signals;
  const Layout& layout;
};

namespace {

/// A rectangle with its sides along the axes, in metres.
struct Rectangle {
  double left = 0;
  double right = 0;
  double near = 0;
  double far = 0;

  [[nodiscard]] bool overlaps(const Rectangle& other) const {
    return left < other.right && other.left < right && near < other.far && other.near < far;
  }
};

Rectangle rows_and_cells(Interval rows, Interval cells, double cell_m) {
  return {rows.first * cell_m, (rows.last + 1) * cell_m, cells.first * cell_m,
          (cells.last + 1) * cell_m};
}

Rectangle rectangle(const RoadUser& body, double cell_m) {
  const BoxSize half = half_extent(body);
  const double x = (body.place.x + 0.5) * cell_m;
  const double y = (body.place.y + 0.5) * cell_m;
  return {x - half.width_m, x + half.width_m, y - half.length_m, y + half.length_m};
}

// The line from one point to another passes through the rectangle (Liang and Barsky).
bool passes(Point from, Point to, const Rectangle& through) {
  double enters = 0;
  double leaves = 1;
  const auto clip = [&](double distance, double towards) {
    if (towards == 0) return distance >= 0;
    const double at = distance / towards;
    if (towards > 0) leaves = std::min(leaves, at);
    if (towards < 0) enters = std::max(enters, at);
    return true;
  };
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  return clip(from.x_m - through.left, -dx) && clip(through.right - from.x_m, dx) &&
         clip(from.y_m - through.near, -dy) && clip(through.far - from.y_m, dy) && enters < leaves;
}

}  // namespace

Av::Av(const CrossingParameters& parameters, int head_start)
    : parameters_(parameters),
      controller_(make_controller(parameters.av.vehicle)),
      cell_mps_(parameters.cell_m / parameters.tick_s),
      driven_(head_start),
      speed_(parameters.av.speed) {}

double Av::front_m() const { return (parameters_.av.start + driven_ + 1) * parameters_.cell_m; }

bool Av::is_hidden(const RoadUser& body) const {
  const double cell = parameters_.cell_m;
  const AvParameters& av = parameters_.av;
  const Point eye{(av.rows.first + av.rows.last + 1) / 2.0 * cell, front_m()};
  const Point target{(body.place.x + 0.5) * cell, (body.place.y + 0.5) * cell};
  return std::ranges::any_of(parameters_.obstacles, [&](const Obstacle& each) {
    return passes(eye, target, rows_and_cells(each.rows, each.cells, cell));
  });
}

std::vector<SeenActor> Av::see(const Surroundings& around) const {
  const double cell = parameters_.cell_m;
  std::vector<SeenActor> seen;
  for (std::size_t i = 0; i < around.bodies.size(); ++i) {
    const RoadUser& body = around.bodies[i];
    if (body.kind == ActorKind::signal) continue;
    const Rectangle box = rectangle(body, cell);
    const double gap = box.near - front_m();
    const bool in_range =
        gap <= parameters_.av.vehicle.range_m && box.far > front_m() - parameters_.av.length * cell;
    if (!in_range || is_hidden(body)) continue;
    const double speed = body.step_in(around.tick) * cell_mps_;
    const double heading = heading_rad(body.facing);
    seen.push_back({static_cast<std::uint32_t>(i + 1), body.kind, gap, box.left, box.right,
                    speed * std::sin(heading), speed * std::cos(heading)});
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

double Av::decide(double time_s, double period_s, const Surroundings& around) {
  if (!controller_) return 0;
  const double cell = parameters_.cell_m;
  const Interval lane = av_lane(parameters_).empty() ? parameters_.av.rows : av_lane(parameters_);
  const std::vector<SeenActor> actors = see(around);
  const std::vector<StopLine> lines = stop_lines(around);
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
                .stop_lines = lines})
      .acceleration_mps2;
}

std::vector<Collision> Av::drive(int tick, std::span<const RoadUser> bodies,
                                 std::span<const SignalColour> signals, const Layout& layout,
                                 std::span<const Collision> hit) {
  const Surroundings around{tick, bodies, signals, layout};
  const double wanted = parameters_.av.vehicle.period_s;
  const int periods = controller_ && wanted > 0
                          ? std::max(1, static_cast<int>(std::lround(parameters_.tick_s / wanted)))
                          : 1;
  const double period_s = parameters_.tick_s / periods;
  std::vector<Collision> collisions;
  const auto touched = [&](std::size_t body) {
    return std::ranges::any_of(hit, [&](const Collision& c) { return c.body == body; }) ||
           std::ranges::any_of(collisions, [&](const Collision& c) { return c.body == body; });
  };
  for (int period = 0; period < periods; ++period) {
    const double acceleration =
        decide((tick - 1) * parameters_.tick_s + period * period_s, period_s, around);
    const double before = speed_;
    // In cells per tick; a vehicle that comes to a stand within the period stays there.
    const double change = acceleration / cell_mps_ * period_s;
    speed_ = std::clamp(speed_ + change, 0.0, parameters_.av.speed);
    double share = 1.0 / periods;
    if (speed_ == 0 && change < 0) share *= std::min(1.0, before / -change);
    const double rear_m = front_m() - parameters_.av.length * parameters_.cell_m;
    driven_ += (before + speed_) / 2 * share;
    const Interval rows = parameters_.av.rows;
    const Rectangle swept{rows.first * parameters_.cell_m, (rows.last + 1) * parameters_.cell_m,
                          rear_m, front_m()};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].kind == ActorKind::signal || touched(i)) continue;
      if (!swept.overlaps(rectangle(bodies[i], parameters_.cell_m))) continue;
      collisions.push_back({i, tick, speed_mps()});
    }
  }
  return collisions;
}

}  // namespace jaywalk
