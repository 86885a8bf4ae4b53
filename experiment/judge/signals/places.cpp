// SPDX-License-Identifier: Apache-2.0
// Signals of being in a lane, and in the paper's precondition zone.

#include <algorithm>
#include <limits>

#include "env/vehicle/hazards.h"
#include "experiment/judge/signals/boxes.h"
#include "experiment/judge/signals/signals.h"

namespace jaywalk::signal {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// The time to collision (TTC) that the paper's precondition zone covers.
constexpr double kZoneS = 1;

}  // namespace

void av_lateral_offset(const TestView& view, ActorIndex, std::span<double> values) {
  const Area* const lane = view.ground().av_lane();
  std::ranges::fill(values, 0);
  if (lane == nullptr) return;
  const auto [left, right] = std::ranges::minmax(lane->corners, {}, &Point::x_m);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    values[tick] = view.state(kAv, tick).x_m - (left.x_m + right.x_m) / 2;
  }
}

void av_in_lane(const TestView& view, ActorIndex, std::span<double> values) {
  const Area* const lane = view.ground().av_lane();
  const auto [left, right] = lane == nullptr ? std::pair(kUnbounded, -kUnbounded) : [&] {
    const auto ends = std::ranges::minmax(lane->corners, {}, &Point::x_m);
    return std::pair(ends.min.x_m, ends.max.x_m);
  }();
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    // The lane is as long as the drive: only its sides matter.
    values[tick] =
        std::ranges::all_of(view.box_at(kAv, tick), [left = left, right = right](Point corner) {
          constexpr double kRounding = 1e-9;
          return corner.x_m >= left - kRounding && corner.x_m <= right + kRounding;
        });
  }
}

void in_lane(const TestView& view, ActorIndex actor, std::span<double> values) {
  const Area* const lane = view.ground().av_lane();
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const ActorState& state = view.state(actor, tick);
    values[tick] = lane != nullptr && contains(*lane, {state.x_m, state.y_m});
  }
}

void over_lane(const TestView& view, ActorIndex actor, std::span<double> values) {
  const Strip lane = risk_strip(view);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const Rectangle sides = surrounding(view.box_at(actor, tick));
    values[tick] = is_over(sides.left, sides.right, lane);
  }
}

void in_road(const TestView& view, ActorIndex actor, std::span<double> values) {
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const ActorState& state = view.state(actor, tick);
    values[tick] = std::ranges::any_of(view.ground().areas, [&](const Area& area) {
      return area.kind == AreaKind::lane && contains(area, {state.x_m, state.y_m});
    });
  }
}

void time_gap(const TestView& view, ActorIndex actor, std::span<double> values) {
  const double half_length = view.recording().actors()[kAv].length_m / 2;
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    const ActorState& av = view.state(kAv, tick == 0 ? 0 : tick - 1);
    const double ahead = dot(displacement(av, view.state(actor, tick)), heading(av)) - half_length;
    values[tick] = ahead > 0 && av.speed_mps > 0 ? ahead / av.speed_mps : kUnbounded;
  }
}

void in_zone(const TestView& view, ActorIndex actor, std::span<double> values) {
  const auto gaps = view.values(SignalId::time_gap, actor);
  const auto lane = view.values(SignalId::in_lane, actor);
  for (std::size_t tick = 0; tick < view.ticks(); ++tick) {
    values[tick] = lane[tick] != 0 && gaps[tick] <= kZoneS;
  }
}

}  // namespace jaywalk::signal
