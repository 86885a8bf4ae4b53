// SPDX-License-Identifier: Apache-2.0
// Signals of a collision if both kept their velocities, and of the braking that would avoid it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "env/vehicle/careful_driver.h"
#include "experiment/judge/signals/boxes.h"
#include "experiment/judge/signals/signals.h"

namespace jaywalk::signal {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The place of the road user's box relative to the middle of the AV's front, in metres.
struct Bearing {
  Span1D ahead;
  Span1D left;
};

Bearing bearing(const TestView& view, ActorIndex actor, std::size_t tick) {
  const ActorState& av = view.state(kAv, tick);
  const Vector forward = heading(av);
  const double half = view.recording().actors()[kAv].length_m / 2;
  Bearing result{{kInf, -kInf}, {kInf, -kInf}};
  for (const Point& corner : view.box_at(actor, tick)) {
    const Vector away{corner.x_m - av.x_m, corner.y_m - av.y_m};
    const double ahead = dot(forward, away) - half;
    const double left = cross(forward, away);
    result.ahead = {std::min(result.ahead.from, ahead), std::max(result.ahead.to, ahead)};
    result.left = {std::min(result.left.from, left), std::max(result.left.to, left)};
  }
  return result;
}

/// How fast the AV approaches along its heading, in m/s.
double closing_speed(const TestView& view, ActorIndex actor, std::size_t tick) {
  const ActorState& av = view.state(kAv, tick);
  return av.speed_mps - dot(heading(av), velocity(view.state(actor, tick)));
}

/// They point the same way or opposite ways, but for rounding; a vector of length 0 points every
/// way.
bool parallel(Vector a, Vector b) {
  constexpr double kRounding = 1e-9;
  return std::abs(cross(a, b)) <= kRounding * std::sqrt(dot(a, a) * dot(b, b));
}

bool concerns(const TestView& view, ActorIndex actor, std::size_t tick) {
  return std::isfinite(view.values(SignalId::ttc, actor)[tick]) ||
         view.values(SignalId::in_path, actor)[tick] != 0;
}

}  // namespace

void gap(const TestView& view, ActorIndex actor, std::span<double> values) {
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const Span1D ahead = bearing(view, actor, tick).ahead;
    values[tick] = ahead.to < 0 ? kInf : std::max(0.0, ahead.from);
  }
}

void in_path(const TestView& view, ActorIndex actor, std::span<double> values) {
  const double half = view.recording().actors()[kAv].width_m / 2;
  const auto gaps = view.values(SignalId::gap, actor);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const Span1D left = bearing(view, actor, tick).left;
    values[tick] = std::isfinite(gaps[tick]) && left.from <= half && left.to >= -half;
  }
}

void ttc(const TestView& view, ActorIndex actor, std::span<double> values) {
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const Vector relative = velocity(view.state(actor, tick)) - velocity(view.state(kAv, tick));
    const auto when =
        contact(view.box_at(kAv, tick), view.box_at(actor, tick), relative, {0, kInf});
    values[tick] = when ? when->from : kInf;
  }
}

void drac(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto gaps = view.values(SignalId::gap, actor);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const double closing = closing_speed(view, actor, tick);
    values[tick] = 0;
    if (closing <= 0 || !std::isfinite(gaps[tick]) || !concerns(view, actor, tick)) continue;
    values[tick] = gaps[tick] > 0 ? closing * closing / (2 * gaps[tick]) : kInf;
  }
}

void btn(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto required = view.values(SignalId::drac, actor);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick)
    values[tick] = required[tick] / kCompetentBrakingMps2;
}

void ttb(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto gaps = view.values(SignalId::gap, actor);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const double closing = closing_speed(view, actor, tick);
    values[tick] = kInf;
    if (closing <= 0 || !std::isfinite(gaps[tick]) || !concerns(view, actor, tick)) continue;
    values[tick] = gaps[tick] / closing - closing / (2 * kCompetentBrakingMps2);
  }
}

void pret(const TestView& view, ActorIndex actor, std::span<double> values) {
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    values[tick] = kInf;
    const Vector away = displacement(view.state(kAv, tick), view.state(actor, tick));
    const Vector av = velocity(view.state(kAv, tick));
    const Vector other = velocity(view.state(actor, tick));
    // av * t1 = away + other * t2
    if (!parallel(av, other)) {
      const double determinant = cross(av, other);
      const double t1 = cross(away, other) / determinant;
      const double t2 = cross(away, av) / determinant;
      if (t1 >= 0 && t2 >= 0) values[tick] = std::abs(t1 - t2);
      continue;
    }
    // On parallel ways they meet only on one line; then the faster one catches up, or reaches the
    // standing one.
    if (!parallel(av, away) || !parallel(other, away)) continue;
    const double av_speed2 = dot(av, av);
    const double other_speed2 = dot(other, other);
    const Vector closing = av - other;
    if (dot(closing, away) > 0) {
      values[tick] = 0;
    } else if (dot(av, away) >= 0 && av_speed2 > 0) {
      values[tick] = dot(av, away) / av_speed2;
    } else if (dot(other, away) <= 0 && other_speed2 > 0) {
      values[tick] = -dot(other, away) / other_speed2;
    }
  }
}

void appearance_ttc(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto times = view.values(SignalId::ttc, actor);
  const auto first = std::ranges::find_if(times, [](double time) { return std::isfinite(time); });
  std::ranges::fill(values, first == times.end() ? kInf : *first);
}

}  // namespace jaywalk::signal
