// SPDX-License-Identifier: Apache-2.0
// The functions that compute the items of situations.def.

#include <algorithm>
#include <cmath>

#include "experiment/judge/situations/situations.h"

namespace jaywalk::situation {
namespace {

/// Steps shorter than this count as standing.
constexpr double kStillM = 1e-6;

const ActorState& now(const Situation& situation) {
  return situation.view.state(situation.pedestrian, situation.tick);
}
const ActorState& before(const Situation& situation, ActorIndex actor) {
  return situation.view.state(actor, situation.tick - 1);
}

/// The bin of `value` among bins of `width` from 0; the last of `count` has no end.
std::uint32_t bin_of(double value, double width, std::uint32_t count) {
  const double bin = std::floor(std::max(value, 0.0) / width + 1e-9);
  return bin >= count ? count - 1 : static_cast<std::uint32_t>(bin);
}

}  // namespace

std::optional<std::uint32_t> start_side(const Situation& situation) {
  const bool is_left =
      situation.view.state(situation.pedestrian, 0).x_m < situation.view.state(kAv, 0).x_m;
  return is_left ? 0U : 1U;
}

std::optional<std::uint32_t> start_band(const Situation& situation) {
  double length = 0;
  for (const Area& area : situation.view.ground().areas) {
    for (const Point& corner : area.corners) length = std::max(length, corner.y_m);
  }
  if (length <= 0) return std::nullopt;
  return bin_of(situation.view.state(situation.pedestrian, 0).y_m, length / 6, 6);
}

std::optional<std::uint32_t> approach(const Situation& situation) {
  const ActorState& last = before(situation, situation.pedestrian);
  const double across = now(situation).x_m - last.x_m;
  const double along = now(situation).y_m - last.y_m;
  if (std::max(std::fabs(across), std::fabs(along)) < kStillM) return 3U;
  if (std::fabs(across) < std::fabs(along)) return 2U;
  return across > 0 ? 0U : 1U;
}

// Pedestrians move first, then the AV: its leading edge was still where the last tick left it.
std::optional<std::uint32_t> entry_ttc(const Situation& situation) {
  const ActorState& av = before(situation, kAv);
  if (av.speed_mps <= 0) return std::nullopt;
  const double edge = av.y_m + situation.view.recording().actors()[kAv].length_m / 2;
  return bin_of((now(situation).y_m - edge) / av.speed_mps, 0.2, 5);
}

std::optional<std::uint32_t> impact_point(const Situation& situation) {
  const double width = situation.view.recording().actors()[kAv].width_m;
  const double left = situation.view.state(kAv, situation.tick).x_m - width / 2;
  const double share = (now(situation).x_m - left) / width;
  if (share < 0) return 0U;
  if (share > 1) return 4U;
  return share < 0.375 ? 1U : share < 0.625 ? 2U : 3U;
}

std::optional<std::uint32_t> entry_time(const Situation& situation) {
  return bin_of(static_cast<double>(situation.tick) * situation.view.tick_s(), kLate_s / 3, 4);
}

std::optional<std::uint32_t> av_speed(const Situation& situation) {
  return bin_of(before(situation, kAv).speed_mps, 3, 4);
}

std::optional<std::uint32_t> others(const Situation& situation) {
  std::uint32_t count = 0;
  const TestView& view = situation.view;
  for (const ActorIndex user : view.road_users()) {
    const bool is_pedestrian = view.recording().actors()[user].kind == ActorKind::pedestrian;
    if (user == situation.pedestrian || !is_pedestrian) continue;
    if (view.values(SignalId::in_road, user)[situation.tick] != 0) ++count;
  }
  return std::min(count, 3U);
}

}  // namespace jaywalk::situation
