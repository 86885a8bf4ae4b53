#include "env/simulator/sumo/road_frame.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace jaywalk {
namespace {

// Shorter pieces have no direction to speak of.
constexpr double kShortestM = 1e-3;
constexpr double kAhead = std::numbers::pi / 2;

}  // namespace

RoadFrame::RoadFrame(const std::vector<TraciPoint>& line, double begin_m, double line_x_m)
    : begin_m_(begin_m), line_x_m_(line_x_m) {
  double end_m = 0;
  TraciPoint from = line.front();
  for (const TraciPoint& to : line) {
    const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    if (length_m < kShortestM) continue;
    segments_.push_back({from, std::atan2(to.y_m - from.y_m, to.x_m - from.x_m), length_m});
    end_m += length_m;
    ends_m_.push_back(end_m);
    from = to;
  }
  assert(!segments_.empty() && "a line has a direction");
}

std::size_t RoadFrame::segment_at(double along_m) const {
  const auto found = std::ranges::upper_bound(ends_m_, along_m);
  return std::min(static_cast<std::size_t>(found - ends_m_.begin()), segments_.size() - 1);
}

RoadFrame::Pose RoadFrame::to_map(Pose world) const {
  if (segments_.empty()) return world;
  const double along_m = world.y_m + begin_m_;
  const std::size_t index = segment_at(along_m);
  const Segment& segment = segments_[index];
  const double on_m = along_m - (ends_m_[index] - segment.length_m);
  const double right_m = world.x_m - line_x_m_;
  const double cosine = std::cos(segment.heading_rad);
  const double sine = std::sin(segment.heading_rad);
  return {segment.from.x_m + on_m * cosine + right_m * sine,
          segment.from.y_m + on_m * sine - right_m * cosine,
          world.heading_rad + segment.heading_rad - kAhead};
}

RoadFrame::Pose RoadFrame::to_world(Pose map) const {
  if (segments_.empty()) return map;
  Pose nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& segment = segments_[i];
    const double x_m = map.x_m - segment.from.x_m;
    const double y_m = map.y_m - segment.from.y_m;
    const double cosine = std::cos(segment.heading_rad);
    const double sine = std::sin(segment.heading_rad);
    const double on_m = x_m * cosine + y_m * sine;
    const double right_m = x_m * sine - y_m * cosine;
    // The first and the last segment go on.
    const double before_m = i == 0 ? 0 : std::max(0.0, -on_m);
    const double behind_m = i + 1 == segments_.size() ? 0 : std::max(0.0, on_m - segment.length_m);
    const double off_m = std::hypot(right_m, before_m + behind_m);
    if (off_m >= least_m) continue;
    least_m = off_m;
    const double kept_m = on_m + before_m - behind_m;
    nearest = {line_x_m_ + right_m, ends_m_[i] - segment.length_m + kept_m - begin_m_,
               map.heading_rad - segment.heading_rad + kAhead};
  }
  return nearest;
}

}  // namespace jaywalk
