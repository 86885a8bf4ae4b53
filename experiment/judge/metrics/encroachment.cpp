// SPDX-License-Identifier: Apache-2.0
// Encroachment and post-encroachment time. The conflict area is where the ways of both cross: for
// the road user the area that the AV's box covers during the test (its swath), for the AV the area
// that the road user's box covers while it touches that swath. Each such visit counts by itself.
// Times of entry and exit lie between ticks, as both move along straight lines.

#include <cmath>

#include "experiment/judge/metrics/extremes.h"
#include "experiment/judge/signals/boxes.h"

namespace jaywalk::metric {
namespace {

using Polygon = std::vector<Point>;

/// A stay of the road user in the AV's swath; times in ticks, which need not be whole numbers.
struct Visit {
  double entry = 0;
  double exit = 0;
  /// The area that the road user's box covers between entry and exit.
  std::vector<Polygon> covered;
};

Polygon moved(Polygon polygon, Vector way, double part) {
  for (Point& corner : polygon) {
    corner.x_m += way.x * part;
    corner.y_m += way.y * part;
  }
  return polygon;
}

Vector way_to(const TestView& view, ActorIndex actor, std::size_t tick) {
  return displacement(view.state(actor, tick - 1), view.state(actor, tick));
}

/// Both ways are parts of one straight drive with one heading.
bool continues(const TestView& view, ActorIndex actor, std::size_t tick) {
  const Vector before = way_to(view, actor, tick - 1);
  const Vector now = way_to(view, actor, tick);
  const double size = std::hypot(before.x, before.y) * std::hypot(now.x, now.y);
  return view.state(actor, tick).heading_rad == view.state(actor, tick - 1).heading_rad &&
         std::abs(cross(before, now)) <= 1e-12 * size && dot(before, now) >= 0;
}

/// The area that an actor's box covers during the test, a convex polygon for each straight stretch.
std::vector<Polygon> swath(const TestView& view, ActorIndex actor) {
  std::vector<Polygon> result;
  std::size_t begin = 0;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    const bool ends = tick + 1 == view.ticks() || !continues(view, actor, tick + 1);
    if (!ends) continue;
    Polygon corners = view.box_before(actor, begin + 1);
    const Polygon last = view.box_at(actor, tick);
    corners.insert(corners.end(), last.begin(), last.end());
    result.push_back(convex_hull(std::move(corners)));
    begin = tick;
  }
  return result;
}

/// The parts of the motion to `tick` in which the actor's box touches any of the polygons, from the
/// first to the last of them.
std::optional<Span1D> touching(const TestView& view, ActorIndex actor, std::size_t tick,
                               const std::vector<Polygon>& polygons) {
  std::optional<Span1D> result;
  const Polygon box = view.box_before(actor, tick);
  const Vector way = way_to(view, actor, tick);
  for (const Polygon& polygon : polygons) {
    const auto part = contact(polygon, box, way, {0, 1});
    if (!part) continue;
    if (!result) result = part;
    result->from = std::min(result->from, part->from);
    result->to = std::max(result->to, part->to);
  }
  return result;
}

std::vector<Visit> visits(const TestView& view, ActorIndex actor) {
  const std::vector<Polygon> av_swath = swath(view, kAv);
  std::vector<Visit> result;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    const auto part = touching(view, actor, tick, av_swath);
    if (!part) continue;
    const auto begin = static_cast<double>(tick - 1);
    if (result.empty() || result.back().exit < begin || part->from > 0) {
      result.push_back({.entry = begin + part->from});
    }
    const Vector way = way_to(view, actor, tick);
    result.back().exit = begin + part->to;
    result.back().covered.push_back(
        swept(moved(view.box_before(actor, tick), way, part->from),
              {way.x * (part->to - part->from), way.y * (part->to - part->from)}));
  }
  return result;
}

/// The time in which the AV touches the area that the road user covers in that visit.
std::optional<Span1D> av_passage(const TestView& view, const Visit& visit) {
  std::optional<Span1D> result;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    const auto part = touching(view, kAv, tick, visit.covered);
    if (!part) continue;
    const auto begin = static_cast<double>(tick - 1);
    if (!result) result = Span1D{begin + part->from, 0};
    result->to = begin + part->to;
  }
  return result;
}

}  // namespace

std::optional<MetricValue> encroachment_time(const TestView& view, ActorIndex actor) {
  std::optional<MetricValue> longest;
  for (const Visit& visit : visits(view, actor)) {
    // A road user that is still inside when the record ends has no exit.
    if (visit.exit >= static_cast<double>(view.ticks() - 1)) continue;
    const double time = (visit.exit - visit.entry) * view.tick_s();
    if (longest && time <= longest->value) continue;
    longest = {time, static_cast<std::uint32_t>(visit.entry), actor};
  }
  return longest;
}

std::optional<MetricValue> pet(const TestView& view, ActorIndex actor) {
  std::optional<MetricValue> least;
  for (const Visit& visit : visits(view, actor)) {
    const auto av = av_passage(view, visit);
    if (!av) continue;
    const double first_exit = std::min(visit.exit, av->to);
    const double second_entry = std::max(visit.entry, av->from);
    if (second_entry <= first_exit) continue;  // both inside together
    const double time = (second_entry - first_exit) * view.tick_s();
    if (least && time >= least->value) continue;
    least = {time, static_cast<std::uint32_t>(std::ceil(second_entry)), actor};
  }
  return least;
}

}  // namespace jaywalk::metric
