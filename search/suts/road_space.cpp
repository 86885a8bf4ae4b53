// SPDX-License-Identifier: Apache-2.0
#include "search/suts/road_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace jaywalk::search {
namespace {

/// Frenetic's first heading, and the margin that it leaves at the map's edge.
constexpr double kSequenceHeading = 1.57;
constexpr double kMapMargin = 10;
constexpr std::size_t kDirections = 74;
/// Inputs longer than this are refused before anything is computed.
constexpr std::size_t kMostValues = 2000;

/// Whether the line through the points crosses the map's boundary for certain, as some of them are
/// clearly inside and others clearly outside. Most invalid candidates are found by it, in a
/// fraction of the time.
bool clearly_leaves_map(const lane::Polyline& points, double map_m) {
  constexpr double kClearly_m = 1;
  bool inside = false;
  bool outside = false;
  for (const Point& point : points) {
    const double within = std::min({point.x_m, map_m - point.x_m, point.y_m, map_m - point.y_m});
    inside = inside || within > kClearly_m;
    outside = outside || within < -kClearly_m;
  }
  return inside && outside;
}

}  // namespace

std::optional<SequenceBounds> RoadSpace::sequences() const {
  return SequenceBounds{3, settings_.sequence_length, settings_.sequence_spread,
                        settings_.sequence_step_m};
}

lane::Polyline RoadSpace::road_points(const TestInput& input) const {
  lane::Polyline points;
  if (input.form == Form::points) {
    for (std::size_t i = 0; i + 1 < input.values.size(); i += 2) {
      points.push_back({input.values[i], input.values[i + 1]});
    }
    return points;
  }
  std::vector<double> curvatures = input.values;
  for (double& each : curvatures) each *= settings_.most_curvature;
  const Point start{settings_.rules.map_m / 2, kMapMargin};
  if (input.form == Form::vector) {
    return lane::integrate(curvatures, {.step_m = settings_.step_m, .start = start});
  }
  // Frenetic makes one point less than it has curvatures.
  if (curvatures.size() < 3) return {};
  curvatures.resize(curvatures.size() - 2);
  points = lane::integrate(curvatures, {settings_.sequence_step_m, start, kSequenceHeading});
  return lane::fit_into_map(std::move(points), settings_.rules.map_m, kMapMargin)
      .value_or(lane::Polyline{});
}

Validity RoadSpace::check(const TestInput& input) const {
  if (input.values.size() > kMostValues) {
    return {"The road definition contains too many points"};
  }
  lane::Polyline points = road_points(input);
  if (input.form == Form::vector && clearly_leaves_map(points, settings_.rules.map_m)) {
    return {std::string(lane::kLeavesMap)};
  }
  const lane::RoadVerdict verdict = lane::validate(std::move(points), settings_.rules);
  return {std::string(verdict.message)};
}

bool RoadSpace::contains(const TestInput& input) const {
  if (input.values.size() > kMostValues) return false;
  lane::Polyline points = road_points(input);
  if (input.form == Form::vector && clearly_leaves_map(points, settings_.rules.map_m)) return false;
  return lane::is_valid(std::move(points), settings_.rules);
}

TestInput RoadSpace::draw_initial(Random& random) const {
  TestInput input;
  const double difference = settings_.most_difference / settings_.most_curvature;
  for (std::size_t i = 0; i < dimension(); ++i) {
    input.values.push_back(i == 0 ? random.uniform(-1, 1)
                                  : input.values.back() + random.uniform(-difference, difference));
  }
  return input;
}

TestInput RoadSpace::as_points(const TestInput& input) const {
  TestInput result{Form::points, {}};
  for (const Point& point : road_points(input)) {
    result.values.push_back(point.x_m);
    result.values.push_back(point.y_m);
  }
  return result;
}

// Peltomäki et al. 2022, section 3.3; the code neither unwraps the angles nor scales them.
std::vector<double> RoadSpace::signature(const TestInput& input) const {
  const auto line = lane::interpolate(road_points(input));
  if (!line) return std::vector<double>(kDirections);
  lane::Polyline points;
  const auto last = static_cast<double>(line->size() - 1);
  for (std::size_t i = 0; i <= kDirections; ++i) {
    const double place = std::nearbyint(static_cast<double>(i) * last / kDirections);
    points.push_back((*line)[static_cast<std::size_t>(place)]);
  }
  std::vector<double> directions;
  double turn = 0;
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double angle =
        std::atan2(points[i + 1].y_m - points[i].y_m, points[i + 1].x_m - points[i].x_m);
    if (i == 0) turn = std::numbers::pi / 2 - angle;
    directions.push_back(std::remainder(angle + turn, 2 * std::numbers::pi));
  }
  return directions;
}

std::vector<double> RoadSpace::unwrapped_signature(const TestInput& input) const {
  std::vector<double> directions = signature(input);
  for (std::size_t i = 1; i < directions.size(); ++i) {
    directions[i] =
        directions[i - 1] + std::remainder(directions[i] - directions[i - 1], 2 * std::numbers::pi);
  }
  return directions;
}

void read_road_space(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                     RoadSpaceSettings& space) {
  const std::vector<ConfigKey> keys{
      {"curvatures", integer_into(space.curvatures, reader, {1, 100})},
      {"step_m", number_into(space.step_m, reader, {1, 100})},
      {"most_curvature", number_into(space.most_curvature, reader, {0.001, 1})},
      {"most_difference", number_into(space.most_difference, reader, {0, 1})},
      {"sequence_step_m", number_into(space.sequence_step_m, reader, {1, 100})},
      {"sequence_length", integer_into(space.sequence_length, reader, {3, 200})},
      {"sequence_spread", integer_into(space.sequence_spread, reader, {0, 100})},
      {"map_m", number_into(space.rules.map_m, reader, {50, 10'000})},
      {"least_length_m", number_into(space.rules.least_length_m, reader, {0, 10'000})},
      {"least_radius_ft", number_into(space.rules.least_radius_ft, reader, {0, 10'000})},
  };
  reader.read_map(node, path, keys);
  if (space.sequence_spread + 3 > space.sequence_length) {
    reader.error(node.origin, "sequence_spread leaves sequences of fewer than 3 values");
  }
}

SutSetting road_setting(const RoadSpaceSettings& space) {
  return {
      "roads",
      fmt::format("vectors of {} curvatures {:.6g} m apart, sequences of {} to {} values {:.6g} m "
                  "apart, up to {:.6g} 1/m; a map of {:.6g} m × {:.6g} m",
                  space.curvatures, space.step_m, space.sequence_length - space.sequence_spread,
                  space.sequence_length + space.sequence_spread, space.sequence_step_m,
                  space.most_curvature, space.rules.map_m, space.rules.map_m)};
}

}  // namespace jaywalk::search
