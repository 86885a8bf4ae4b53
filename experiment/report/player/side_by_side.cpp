// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "experiment/report/player/player.h"

namespace jaywalk {
namespace {

/// As many as fit a line.
constexpr std::size_t kMostShown = 2;

bool is_same(const ActorState& left, const ActorState& right) {
  return left.x_m == right.x_m && left.y_m == right.y_m && left.speed_mps == right.speed_mps;
}

/// Actors with a collision, then others, without the AV; at most kMostShown.
std::vector<std::uint32_t> shown_actors(const Recording& healthy, const Recording& defective) {
  std::vector<std::uint32_t> shown;
  const auto add = [&](std::uint32_t actor) {
    const bool known = std::ranges::find(shown, actor) != shown.end();
    if (actor > 0 && !known && shown.size() < kMostShown) shown.push_back(actor);
  };
  for (const Recording* each : {&defective, &healthy}) {
    for (const RecordedEvent& event : each->events()) {
      if (event.kind == "collision" && event.actor) add(*event.actor);
    }
  }
  for (std::uint32_t actor = 1; actor < healthy.actors().size(); ++actor) add(actor);
  return shown;
}

std::string heading_of(const Recording& recording, const std::vector<std::uint32_t>& shown) {
  std::string text = fmt::format("{:>7}  {:>5}", "AV m", "m/s");
  for (const std::uint32_t actor : shown) {
    text += fmt::format("  {:>13}", recording.actors()[actor].name);
  }
  return text;
}

std::string scene_text(const Recording& recording, std::size_t tick,
                       const std::vector<std::uint32_t>& shown) {
  if (tick >= recording.scenes()) return std::string(14 + 15 * shown.size(), ' ');
  const auto scene = recording.scene(tick);
  std::string text = fmt::format("{:>7.2f}  {:>5.2f}", scene[0].y_m, scene[0].speed_mps);
  for (const std::uint32_t actor : shown) {
    text += fmt::format("  {:>5.1f}, {:>6.1f}", scene[actor].x_m, scene[actor].y_m);
  }
  return text;
}

std::string events_of(const Recording& recording, std::size_t tick, std::string_view whose) {
  std::string text;
  for (const RecordedEvent& event : recording.events()) {
    if (event.tick != tick) continue;
    text += fmt::format("  {}: {}", whose, event.kind);
    if (event.actor) text += fmt::format(" of {}", recording.actors()[*event.actor].name);
    if (!event.text.empty()) text += fmt::format(" ({})", event.text);
  }
  return text;
}

}  // namespace

std::optional<std::size_t> parting(const Recording& left, const Recording& right) {
  const std::size_t both = std::min(left.scenes(), right.scenes());
  for (std::size_t tick = 0; tick < both; ++tick) {
    if (!std::ranges::equal(left.scene(tick), right.scene(tick), is_same)) return tick;
  }
  return std::nullopt;
}

std::string side_by_side(const Recording& healthy, const Recording& defective,
                         std::string_view name) {
  const auto parted = parting(healthy, defective);
  if (!parted) return "both AVs drive alike\n";
  const std::vector<std::uint32_t> shown = shown_actors(healthy, defective);
  const std::string heading = heading_of(healthy, shown);
  std::string text = fmt::format("they part in tick {} ({:.1f} s)\n\n", *parted,
                                 static_cast<double>(*parted) * healthy.tick_s());
  text += fmt::format("{:>5}  {:<{}} | {}\n", "", "healthy", heading.size(), name);
  text += fmt::format("{:>5}  {} | {}\n", "tick", heading, heading);
  const std::size_t end = std::max(healthy.scenes(), defective.scenes());
  for (std::size_t tick = *parted == 0 ? 0 : *parted - 1; tick < end; ++tick) {
    text += fmt::format("{:>5}  {} | {}{}{}\n", tick, scene_text(healthy, tick, shown),
                        scene_text(defective, tick, shown), events_of(healthy, tick, "healthy"),
                        events_of(defective, tick, name));
  }
  return text;
}

}  // namespace jaywalk
