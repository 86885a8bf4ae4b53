// Whether a careful and competent driver in the AV's place would have hit a road user. The driver
// follows the AV's recorded way at its recorded speed until the risk is perceived, then brakes to a
// stop. The road user moves as recorded, and after the record ends goes on as it did last.

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiment/signals/boxes.h"
#include "experiment/signals/signals.h"

namespace jaywalk::signal {
namespace {

/// Motion within such a time counts as straight.
constexpr double kStepS = 0.05;

/// An actor's recorded motion at any time, straight between two ticks and after the last.
class Track {
 public:
  Track(const TestView& view, ActorIndex actor) : view_(view), actor_(actor) {}

  [[nodiscard]] ActorState at(double time_s) const {
    const double ticks = time_s / view_.tick_s();
    const std::size_t last = view_.ticks() - 1;
    if (ticks >= static_cast<double>(last)) {
      ActorState state = view_.state(actor_, last);
      const Vector way = velocity(state);
      const double beyond = time_s - static_cast<double>(last) * view_.tick_s();
      state.x_m += way.x * beyond;
      state.y_m += way.y * beyond;
      return state;
    }
    const auto before = static_cast<std::size_t>(ticks);
    const double part = ticks - static_cast<double>(before);
    const ActorState& from = view_.state(actor_, before);
    ActorState state = view_.state(actor_, before + 1);
    state.x_m = from.x_m + part * (state.x_m - from.x_m);
    state.y_m = from.y_m + part * (state.y_m - from.y_m);
    state.speed_mps = from.speed_mps + part * (state.speed_mps - from.speed_mps);
    return state;
  }

  /// When it has gone so far from where it was at `from_s`. Its speed must not be 0 for ever.
  [[nodiscard]] ActorState after(double from_s, double way_m) const {
    const std::size_t last = view_.ticks() - 1;
    ActorState state = at(from_s);
    auto next = static_cast<std::size_t>(from_s / view_.tick_s()) + 1;
    for (; next <= last; ++next) {
      const ActorState& later = view_.state(actor_, next);
      const Vector step = displacement(state, later);
      const double length = std::hypot(step.x, step.y);
      if (length >= way_m) return moved(later, state, way_m / std::max(length, 1e-12));
      way_m -= length;
      state = later;
    }
    const Vector ahead = heading(state);
    state.x_m += ahead.x * way_m;
    state.y_m += ahead.y * way_m;
    return state;
  }

 private:
  static ActorState moved(ActorState later, const ActorState& from, double part) {
    later.x_m = from.x_m + part * (later.x_m - from.x_m);
    later.y_m = from.y_m + part * (later.y_m - from.y_m);
    return later;
  }

  const TestView& view_;
  ActorIndex actor_;
};

/// When its middle gets into the AV's lane: the moment between two ticks.
std::optional<double> risk_begins(const TestView& view, ActorIndex actor) {
  const auto inside = view.values(SignalId::in_lane, actor);
  const auto found = std::ranges::find_if(inside, [](double value) { return value != 0; });
  if (found == inside.end()) return std::nullopt;
  const auto tick = static_cast<std::size_t>(found - inside.begin());
  if (tick == 0) return 0;
  const ActorState& from = view.state(actor, tick - 1);
  const Point start{from.x_m, from.y_m};
  const auto entry = contact(view.ground().av_lane()->corners, {&start, 1},
                             displacement(from, view.state(actor, tick)), {0, 1});
  return (static_cast<double>(tick - 1) + (entry ? entry->from : 1)) * view.tick_s();
}

/// Follows the driver from when the risk begins until the car stands.
bool driver_hits(const TestView& view, ActorIndex actor, double risk_s) {
  const Track car(view, kAv);
  const Track other(view, actor);
  const auto actors = view.recording().actors();
  const double brakes_s = risk_s + kRiskPerceptionS;
  const double speed = car.at(brakes_s).speed_mps;
  const double stands_s = brakes_s + speed / kBrakingMps2;
  const auto driven = [&](double time_s) {
    const double braking = time_s - brakes_s;
    if (braking <= 0) return car.at(time_s);
    return car.after(brakes_s, speed * braking - kBrakingMps2 / 2 * braking * braking);
  };
  ActorState car_before = car.at(risk_s);
  ActorState other_before = other.at(risk_s);
  for (double time = risk_s; time < stands_s;) {
    // Steps end where the record has a tick, so that nobody turns within one.
    const double tick_end = (std::floor(time / view.tick_s() + 1e-9) + 1) * view.tick_s();
    const double step_end = std::min({time + kStepS, stands_s, std::max(tick_end, time + 1e-6)});
    const ActorState car_now = driven(step_end);
    const ActorState other_now = other.at(step_end);
    car_before.heading_rad = car_now.heading_rad;
    other_before.heading_rad = other_now.heading_rad;
    const Vector relative =
        displacement(other_before, other_now) - displacement(car_before, car_now);
    if (contact(box(actors[kAv], car_before), box(actors[actor], other_before), relative, {0, 1})) {
      return true;
    }
    car_before = car_now;
    other_before = other_now;
    time = step_end;
  }
  return false;
}

}  // namespace

void avoidable(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto risk = risk_begins(view, actor);
  std::ranges::fill(values, !risk || !driver_hits(view, actor, *risk) ? 1 : 0);
}

}  // namespace jaywalk::signal
