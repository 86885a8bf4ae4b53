// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "env/vehicle/careful_driver.h"
#include "env/vehicle/sight.h"
#include "experiment/judge/signals/boxes.h"
#include "experiment/judge/signals/signals.h"

namespace jaywalk {
namespace {

/// How long the drive goes on after the record's end. A car that still drives then never stops.
constexpr double kAfterTheEndS = 60;

/// The AV's way as recorded, by metres driven; straight on after its end.
class RecordedWay {
 public:
  explicit RecordedWay(const TestView& view) {
    double driven = 0;
    for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
      const ActorState& state = view.state(kAv, tick);
      if (tick > 0) {
        const Vector step = displacement(states_.back(), state);
        driven += std::hypot(step.x, step.y);
      }
      states_.push_back(state);
      driven_.push_back(driven);
    }
  }

  [[nodiscard]] double driven_at(std::size_t tick) const { return driven_[tick]; }

  [[nodiscard]] ActorState after(double way_m) const {
    const auto next = std::ranges::upper_bound(driven_, way_m);
    if (next == driven_.end() || next == driven_.begin()) {
      ActorState state = states_.back();
      const Vector ahead = heading(state);
      state.x_m += ahead.x * (way_m - driven_.back());
      state.y_m += ahead.y * (way_m - driven_.back());
      return state;
    }
    const auto index = static_cast<std::size_t>(next - driven_.begin());
    const ActorState& from = states_[index - 1];
    ActorState state = states_[index];
    // driven_[index] is greater than way_m, and so than driven_[index - 1].
    const double part = (way_m - driven_[index - 1]) / (driven_[index] - driven_[index - 1]);
    state.x_m = from.x_m + part * (state.x_m - from.x_m);
    state.y_m = from.y_m + part * (state.y_m - from.y_m);
    return state;
  }

 private:
  std::vector<ActorState> states_;
  std::vector<double> driven_;
};

/// The view of a driver at places where the AV could be.
class Surroundings {
 public:
  explicit Surroundings(const TestView& view) : view_(view), lane_(risk_strip(view)) {}

  /// Call this when a tick begins. Where road users move evenly, call it at any share of the tick,
  /// from 0 to 1, its end.
  void set_time(std::size_t tick, double share) {
    others_.clear();
    for (const ActorIndex user : view_.road_users()) {
      const Actor& actor = view_.recording().actors()[user];
      ActorState state = state_beyond(view_, user, tick);
      // `share` of the step from the tick before to this one.
      if (view_.ground().moves_evenly) {
        const ActorState from = state_beyond(view_, user, tick - 1);
        state.x_m = from.x_m + share * (state.x_m - from.x_m);
        state.y_m = from.y_m + share * (state.y_m - from.y_m);
      }
      others_.push_back(
          {user, actor.kind, surrounding(box(actor, state)), state.speed_mps, state.heading_rad});
    }
    closed_.clear();
    for (const GroundCrosswalk& each : view_.ground().crosswalks) {
      closed_.push_back(each.zebra ? is_occupied(each) : is_red(each, tick));
    }
  }

  /// The view from the car in this state; valid until the next call.
  VehicleView look(const ActorState& car, double time_s, double period_s, double cruise_mps) {
    const Actor& size = view_.recording().actors()[kAv];
    const Strip body{car.x_m - size.width_m / 2, car.x_m + size.width_m / 2};
    const double front = car.y_m + size.length_m / 2;
    const Sight sight{body, front, size.length_m, VehicleParameters{}.range_m,
                      view_.ground().obstacles};
    seen_.clear();
    for (const RoadUserBox& other : others_) {
      if (const auto actor = see(sight, other)) seen_.push_back(*actor);
    }
    lines_.clear();
    for (std::size_t i = 0; i < closed_.size(); ++i) {
      lines_.push_back({view_.ground().crosswalks[i].begins_m - front, closed_[i]});
    }
    return {.time_s = time_s,
            .period_s = period_s,
            .speed_mps = car.speed_mps,
            .cruise_mps = cruise_mps,
            .left_m = body.left_m,
            .right_m = body.right_m,
            .lane_left_m = lane_.left_m,
            .lane_right_m = lane_.right_m,
            .actors = seen_,
            .stop_lines = lines_,
            .front_m = front,
            .length_m = size.length_m};
  }

 private:
  [[nodiscard]] bool is_occupied(const GroundCrosswalk& crosswalk) const {
    return std::ranges::any_of(others_, [&](const RoadUserBox& other) {
      return other.kind == ActorKind::pedestrian &&
             std::ranges::any_of(crosswalk.parts, [&](const Rectangle& part) {
               return part.contains(other.box.middle());
             });
    });
  }

  [[nodiscard]] bool is_red(const GroundCrosswalk& crosswalk, std::size_t tick) const {
    const auto actors = view_.recording().actors();
    bool closed = false;
    for (const RecordedEvent& event : view_.recording().events()) {
      if (event.kind != "signal" || !event.actor || event.tick > tick) continue;
      if (std::ranges::find(crosswalk.signals, actors[*event.actor].name) ==
          crosswalk.signals.end()) {
        continue;
      }
      // Events are in the order of ticks: the last one until `tick` counts.
      closed = event.text != "green";
    }
    return closed;
  }

  const TestView& view_;
  Strip lane_;
  std::vector<RoadUserBox> others_;
  std::vector<bool> closed_;
  std::vector<SeenActor> seen_;
  std::vector<StopLine> lines_;
};

/// Whether there is something ahead for which a driver brakes.
bool has_reason(const VehicleView& view) {
  return closed_line(view) || std::ranges::any_of(view.actors, [&](const SeenActor& actor) {
           return is_risk(actor, lane_of(view));
         });
}

/// The first tick that the driver drives: before, it is where the AV was.
std::size_t first_tick(const TestView& view, Surroundings& around) {
  // With a known cruising speed the driver replaces the AV from the start. Without, the driver has
  // to follow the AV until the first risk, since the speed that the AV wanted is unknown.
  if (view.ground().cruise_mps) return 1;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    around.set_time(tick, 1);
    if (has_reason(around.look(view.state(kAv, tick - 1), 0, view.tick_s(), 0))) return tick;
  }
  return view.ticks();
}

}  // namespace

Strip risk_strip(const TestView& view) {
  const Area* const lane = view.ground().av_lane();
  const Rectangle sides = surrounding(lane == nullptr ? view.box_at(kAv, 0) : lane->corners);
  return {sides.left, sides.right};
}

ActorState state_beyond(const TestView& view, ActorIndex actor, std::size_t tick) {
  const std::size_t last = view.ticks() - 1;
  if (tick <= last) return view.state(actor, tick);
  ActorState state = view.state(actor, last);
  const double seconds = static_cast<double>(tick - last) * view.tick_s();
  const Vector way = velocity(state);
  state.x_m += way.x * seconds;
  state.y_m += way.y * seconds;
  return state;
}

std::vector<ActorState> careful_drive(const TestView& view) {
  Surroundings around(view);
  const RecordedWay way(view);
  std::vector<ActorState> states;
  const std::size_t first = first_tick(view, around);
  for (std::size_t tick = 0; tick < first; ++tick) states.push_back(view.state(kAv, tick));
  if (first == view.ticks()) return states;

  CarefulDriver driver;
  const int periods = periods_of(driver, view.tick_s());
  const double period_s = view.tick_s() / periods;
  const double cruise = view.ground().cruise_mps.value_or(states.back().speed_mps);
  const auto end = view.ticks() + static_cast<std::size_t>(kAfterTheEndS / view.tick_s());
  double driven = way.driven_at(first - 1);
  bool is_over = false;
  for (std::size_t tick = first; tick < view.ticks() || (tick < end && !is_over); ++tick) {
    ActorState car = states.back();
    for (int period = 0; period < periods; ++period) {
      // In a world of steps others stand still within a tick.
      const bool moved = period == 0 || view.ground().moves_evenly;
      if (moved) around.set_time(tick, static_cast<double>(period) / periods);
      const double time_s = static_cast<double>(tick - 1) * view.tick_s() + period * period_s;
      const VehicleView seen = around.look(car, time_s, period_s, cruise);
      const double change = driver.decide(seen).acceleration_mps2 * period_s;
      const Motion next = drive_on(car.speed_mps, change, cruise, period_s);
      // Behind the record's end the drive goes on only while something can still happen.
      is_over = next.speed == 0 || !has_reason(seen);
      driven += next.way;
      car = way.after(driven);
      car.speed_mps = next.speed;
    }
    states.push_back(car);
  }
  return states;
}

namespace signal {

void avoidable(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto actors = view.recording().actors();
  const std::span<const ActorState> car = view.careful_drive();
  bool met = distance_m(view.box_at(kAv, 0), view.box_at(actor, 0)) <= 0;
  for (std::size_t tick = 1; tick < car.size() && !met; ++tick) {
    met = touch(actors[kAv], {car[tick - 1], car[tick]}, actors[actor],
                {state_beyond(view, actor, tick - 1), state_beyond(view, actor, tick)});
  }
  std::ranges::fill(values, met ? 0 : 1);
}

}  // namespace signal
}  // namespace jaywalk
