#include "env/vehicle/hazards.h"

#include <algorithm>

namespace jaywalk {
namespace {

// What is beside the front is no longer in the way.
constexpr double kBesideM = -0.01;
// A vehicle that has come to its stop line may stand a little beyond it.
constexpr double kPastLineM = -1;

void keep_nearest(std::optional<Hazard>& nearest, const Hazard& hazard) {
  if (!nearest || hazard.gap_m < nearest->gap_m) nearest = hazard;
}

}  // namespace

bool is_over(const SeenActor& actor, const Strip& strip, double after_s) {
  const double shift = actor.speed_right_mps * after_s;
  return actor.right_m + shift > strip.left_m && actor.left_m + shift < strip.right_m;
}

std::optional<Hazard> closed_line(const VehicleView& view) {
  std::optional<Hazard> nearest;
  for (const StopLine& line : view.stop_lines) {
    if (line.closed && line.gap_m >= kPastLineM) keep_nearest(nearest, {line.gap_m, 0});
  }
  return nearest;
}

std::optional<Hazard> Perception::perceive(const VehicleView& view, const Strip& strip) {
  std::optional<Hazard> nearest = closed_line(view);
  std::map<std::uint32_t, double> since_s;
  for (const SeenActor& actor : view.actors) {
    if (actor.gap_m < kBesideM || !is_over(actor, strip)) continue;
    const auto known = since_s_.find(actor.id);
    const double since = known == since_s_.end() ? view.time_s : known->second;
    since_s.emplace(actor.id, since);
    if (view.time_s - since + 1e-9 < reaction_s_) continue;
    keep_nearest(nearest, {actor.gap_m, std::max(actor.speed_ahead_mps, 0.0)});
  }
  since_s_ = std::move(since_s);
  return nearest;
}

double required_deceleration(const VehicleView& view, const Hazard& hazard, double standoff_m) {
  const double closing = view.speed_mps - hazard.speed_mps;
  if (closing <= 0) return 0;
  const double room = hazard.gap_m - standoff_m;
  if (room <= 0) return std::numeric_limits<double>::infinity();
  return closing * closing / (2 * room);
}

}  // namespace jaywalk
