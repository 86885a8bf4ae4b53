// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/hazards.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jaywalk {
namespace {

// An actor beside the front is no longer in the way.
constexpr double kBesideM = -0.01;
// A vehicle that has come to its stop line may stand a little beyond it.
constexpr double kPastLineM = -1;
// Boxes that only touch the lane do not become a risk by rounding.
constexpr double kTouchM = 1e-6;
// Times are sums of periods.
constexpr double kRoundingS = 1e-9;
// With a late sensor the seen place of a line moves a little.
constexpr double kSameLineM = 1;

bool is_closed_ahead(const StopLine& line) { return line.closed && line.gap_m >= kPastLineM; }

void keep_nearest(std::optional<Hazard>& nearest, const Hazard& hazard) {
  if (!nearest || hazard.gap_m < nearest->gap_m) nearest = hazard;
}

}  // namespace

bool is_over(double left_m, double right_m, const Strip& strip) {
  return right_m > strip.left_m + kTouchM && left_m < strip.right_m - kTouchM;
}

bool is_over(const SeenActor& actor, const Strip& strip, double after_s) {
  const double shift = actor.speed_right_mps * after_s;
  return is_over(actor.left_m + shift, actor.right_m + shift, strip);
}

bool is_risk(const SeenActor& actor, const Strip& lane) {
  return actor.gap_m >= kBesideM && is_over(actor, lane);
}

std::optional<Hazard> closed_line(const VehicleView& view) {
  std::optional<Hazard> nearest;
  for (const StopLine& line : view.stop_lines) {
    if (is_closed_ahead(line)) keep_nearest(nearest, {line.gap_m, 0});
  }
  return nearest;
}

void Risks::look(const VehicleView& view, const Strip& lane) {
  std::map<std::uint32_t, Risk> risks;
  for (const SeenActor& actor : view.actors) {
    if (!is_risk(actor, lane)) continue;
    const auto known = risks_.find(actor.id);
    risks[actor.id] = {known == risks_.end() ? view.time_s : known->second.since_s,
                       {actor.gap_m, std::max(actor.speed_ahead_mps, 0.0)}};
  }
  risks_ = std::move(risks);
}

std::optional<double> Risks::first_s() const {
  std::optional<double> first;
  for (const auto& [id, risk] : risks_)
    first = std::min(first.value_or(risk.since_s), risk.since_s);
  return first;
}

std::optional<Hazard> Perception::perceive(const VehicleView& view, const Strip& lane) {
  risks_.look(view, lane);
  std::optional<Hazard> nearest = closed_line(view);
  for (const auto& [id, risk] : risks_.all()) {
    if (view.time_s - risk.since_s + kRoundingS >= reaction_s_) keep_nearest(nearest, risk.hazard);
  }
  return nearest;
}

double required_deceleration(const VehicleView& view, const Hazard& hazard, double standoff_m) {
  const double closing = view.speed_mps - hazard.speed_mps;
  if (closing <= 0) return 0;
  const double room = hazard.gap_m - standoff_m;
  if (room <= 0) return std::numeric_limits<double>::infinity();
  return closing * closing / (2 * room);
}

const LineStop::Line* LineStop::known(double place_m) const {
  const auto line = std::ranges::find_if(
      closed_, [&](const Line& one) { return std::abs(one.place_m - place_m) < kSameLineM; });
  return line == closed_.end() ? nullptr : &*line;
}

void LineStop::look(const VehicleView& view) {
  std::vector<Line> closed;
  for (const StopLine& line : view.stop_lines) {
    if (!is_closed_ahead(line)) continue;
    const double place = view.front_m + line.gap_m;
    const Line* before = known(place);
    closed.push_back({place, line.gap_m, before ? before->closed_s : view.time_s});
  }
  closed_ = std::move(closed);
}

const LineStop::Line* LineStop::nearest(const VehicleView& view) const {
  const Line* nearest = nullptr;
  for (const Line& line : closed_) {
    if (view.time_s + kRoundingS < line.closed_s + reacts_s_) continue;
    if (!nearest || line.gap_m < nearest->gap_m) nearest = &line;
  }
  return nearest;
}

std::optional<double> LineStop::braking(const VehicleView& view, double strongest_mps2) {
  look(view);
  const Line* line = nearest(view);
  const bool goes_on = line && stops_at_m_ && std::abs(*stops_at_m_ - line->place_m) < kSameLineM;
  stops_at_m_.reset();
  if (!line) return std::nullopt;
  const double needed = required_deceleration(view, {line->gap_m, 0}, 0);
  if (!goes_on && needed < kComfortableMps2) return std::nullopt;
  stops_at_m_ = line->place_m;
  return std::min(needed, strongest_mps2);
}

double resume(const VehicleView& view, double acceleration_mps2) {
  return std::clamp((view.cruise_mps - view.speed_mps) / view.period_s, -acceleration_mps2,
                    acceleration_mps2);
}

}  // namespace jaywalk
