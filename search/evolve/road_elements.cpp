// SPDX-License-Identifier: Apache-2.0
#include "search/evolve/road_elements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "env/lane/path.h"

namespace jaywalk::search {
namespace {

using Kind = RoadElement::Kind;

constexpr int kLeastLength_m = 5;
constexpr int kMostLength_m = 30;
constexpr int kLeastAngle_deg = 10;
constexpr int kMostAngle_deg = 85;
constexpr double kTurnRadius_m = 20;
/// Half of the road's width and of what is left to the map's edge.
constexpr double kEdge_m = 9;
constexpr double kAlike = 10;

// AmbieGen's simplified car.
constexpr double kFirstSpeed = 9;
constexpr double kLeastSpeed = 1;
constexpr double kFaster = 0.3;
constexpr double kSlower = 0.2;
constexpr double kStraightSteps = 2.3;
constexpr double kTurningSteps = 3;
constexpr double kOnTheLine_m = 1;
constexpr double kProbe_rad = std::numbers::pi / 180;
constexpr int kMostSteps = 1000;

class SimplifiedCar {
 public:
  explicit SimplifiedCar(const lane::Path& line) : line_(line) {}

  /// Drives from one of the line's points until it has gone as far as to the other; the largest
  /// distance.
  double drive(std::size_t from, std::size_t to) {
    near_ = from;
    place_ = line_.point(from);
    heading_ = line_.heading(from);
    const double length = line_.arc_m(to) - line_.arc_m(from);
    double gone = 0;
    double most = 0;
    for (int i = 0; i < kMostSteps && gone < length; ++i) {
      const double distance = away(place_);
      most = std::max(most, distance);
      gone += step(distance);
    }
    return most;
  }

 private:
  /// How far it goes.
  double step(double distance) {
    double way = speed_ / kStraightSteps;
    if (distance > kOnTheLine_m) {
      const double angle = std::atan(2 * distance / speed_);
      const bool left = away(ahead(kProbe_rad)) <= away(ahead(-kProbe_rad));
      heading_ += left ? angle : -angle;
      way = speed_ / kTurningSteps;
      speed_ = std::max(kLeastSpeed, speed_ - kSlower);
    } else {
      speed_ += kFaster;
    }
    place_ = {place_.x_m + way * std::cos(heading_), place_.y_m + way * std::sin(heading_)};
    return way;
  }

  [[nodiscard]] Point ahead(double turn) const {
    return {place_.x_m + speed_ * std::cos(heading_ + turn),
            place_.y_m + speed_ * std::sin(heading_ + turn)};
  }

  double away(const Point& point) {
    near_ = line_.nearest(point, near_);
    return line_.distance_m(point, near_);
  }

  const lane::Path& line_;
  std::size_t near_ = 0;
  Point place_;
  double heading_ = 0;
  double speed_ = kFirstSpeed;
};

double draw_value(Kind kind, Random& random) {
  return kind == Kind::straight ? random.between(kLeastLength_m, kMostLength_m)
                                : random.between(kLeastAngle_deg, kMostAngle_deg);
}

}  // namespace

RoadElement draw_element(Random& random) {
  const auto kind = static_cast<Kind>(random.below(3));
  return {kind, draw_value(kind, random)};
}

RoadElement draw_other(const RoadElement& element, Random& random) {
  const auto kind =
      static_cast<Kind>((static_cast<std::size_t>(element.kind) + 1 + random.below(2)) % 3);
  return {kind, draw_value(kind, random)};
}

lane::Polyline element_points(std::span<const RoadElement> elements, double map_m) {
  lane::Polyline points{{map_m / 2, map_m / 2}};
  double heading = std::numbers::pi / 2;
  for (const RoadElement& each : elements) {
    double turn = 0;
    double way = each.value;
    if (each.kind != Kind::straight) {
      turn = each.value * std::numbers::pi / 180 * (each.kind == Kind::left ? 1 : -1);
      way = 2 * kTurnRadius_m * std::sin(std::fabs(turn) / 2);  // the chord
    }
    const Point next{points.back().x_m + way * std::cos(heading + turn / 2),
                     points.back().y_m + way * std::sin(heading + turn / 2)};
    heading += turn;
    if (std::min({next.x_m, next.y_m, map_m - next.x_m, map_m - next.y_m}) < kEdge_m) break;
    points.push_back(next);
  }
  return points;
}

double simplified_deviation_m(std::span<const Point> points) {
  auto middle = lane::interpolate(points);
  if (!middle) return 0;
  const lane::Path line(std::move(*middle));
  SimplifiedCar car(line);
  const double first = car.drive(0, line.size() / 2);
  return std::max(first, car.drive(line.size() / 2, line.size() - 1));
}

double difference(std::span<const RoadElement> a, std::span<const RoadElement> b) {
  const std::size_t count = std::min(a.size(), b.size());
  if (count == 0) return 1;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (a[i].kind != b[i].kind) {
      sum += 1;
    } else if (std::fabs(a[i].value - b[i].value) > kAlike) {
      sum += 0.5;
    }
  }
  return sum / static_cast<double>(count);
}

}  // namespace jaywalk::search
