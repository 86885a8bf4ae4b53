// SPDX-License-Identifier: Apache-2.0
#include "search/generators/sites.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "search/failing_stretch.h"

namespace jaywalk::search {
namespace {

constexpr int kValuesBefore = 8;
constexpr int kValuesAfter = 1;
/// Ends farther away than this no longer matter; their distances are in these units of values.
constexpr int kFarBeginning = 8;
constexpr double kBeginningUnit = 4;
constexpr int kFarEnd = 6;
constexpr double kEndUnit = 2;

/// Coarser than a failing stretch, as many shapes are compared for each test.
constexpr double kShapeStep_m = 5;

/// A point of the chain of straight pieces, which go on beyond its ends.
Point along(std::span<const double> xy, double steps) {
  const auto last = static_cast<double>(xy.size() / 2 - 2);
  const double piece = std::clamp(std::floor(steps), 0.0, last);
  const double share = steps - piece;
  const std::size_t i = 2 * static_cast<std::size_t>(piece);
  return {xy[i] + share * (xy[i + 2] - xy[i]), xy[i + 1] + share * (xy[i + 3] - xy[i + 1])};
}

double least_separation(const std::vector<lane::Polyline>& known, const lane::Polyline& shape) {
  double least = std::numeric_limits<double>::infinity();
  for (const lane::Polyline& each : known) least = std::min(least, separation_m(each, shape));
  return least;
}

/// 0 up to `from`, 1 from `to` on, even in between.
double ramp(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

/// Known failures that a candidate is compared with.
constexpr std::size_t kCompared = 48;
constexpr std::size_t kMostPieces = static_cast<std::size_t>(2 * kPieces_m / kTurnPiece_m);

double replacement_cost(double a, double b) {
  const double turn = std::fabs(a - b);
  return kTurnPiece_m * turn / (1 + turn) / 2;
}

/// At a point between the ends, in degrees for each metre.
double turn_at(std::span<const double> xy, std::size_t point, double point_m) {
  const std::size_t i = 2 * std::clamp<std::size_t>(point, 1, xy.size() / 2 - 2);
  const double before = std::atan2(xy[i + 1] - xy[i - 1], xy[i] - xy[i - 2]);
  const double after = std::atan2(xy[i + 3] - xy[i + 1], xy[i + 2] - xy[i]);
  return std::remainder(after - before, 2 * std::numbers::pi) * 180 / std::numbers::pi / point_m;
}

}  // namespace

std::vector<double> SiteView::features(const Site& site) const {
  const std::vector<double>& values = site.input.values;
  if (!sequences_) return values;
  std::vector<double> features;
  const int size = static_cast<int>(values.size());
  for (int i = site.at() - kValuesBefore; i <= site.at() + kValuesAfter; ++i) {
    features.push_back(i >= 0 && i < size ? values[static_cast<std::size_t>(i)] : 0);
  }
  features.push_back(std::min(size - site.at(), kFarEnd) / kEndUnit);
  features.push_back(std::min(site.at(), kFarBeginning) / kBeginningUnit);
  return features;
}

std::vector<learn::FeatureLength> SiteView::lengths() const {
  if (!sequences_) return std::vector<learn::FeatureLength>(space_.dimension());
  std::vector<learn::FeatureLength> lengths;
  for (int i = -kValuesBefore; i <= 0; ++i) {
    lengths.push_back({1, std::max(0.0, static_cast<double>(-i - 1))});
  }
  lengths.push_back({1.5, 0});
  lengths.push_back({3, 0});
  lengths.push_back({3, 0});
  return lengths;
}

lane::Polyline SiteView::shape(const Site& site, const TestInput& points, double shift_m) const {
  lane::Polyline shape;
  if (!sequences_) {
    for (const double value : site.input.values) shape.push_back({value * kVectorMetres, 0});
    return shape;
  }
  const double step = sequences_->element_m;
  const double place = site.place + shift_m / step;
  const Point origin = along(points.values, place);
  const Point before = along(points.values, place - kShapeStep_m / step);
  const Point after = along(points.values, place + kShapeStep_m / step);
  const double length = lane::distance(before, after);
  const double c = (after.x_m - before.x_m) / length;
  const double s = (after.y_m - before.y_m) / length;
  for (double at = -kStretchBefore_m; at <= kStretchAfter_m; at += kShapeStep_m) {
    const Point point = along(points.values, place + at / step);
    const double dx = point.x_m - origin.x_m;
    const double dy = point.y_m - origin.y_m;
    shape.push_back({c * dx + s * dy, c * dy - s * dx});
  }
  return shape;
}

double SiteView::surroundings_m(const Site& site) const {
  if (!sequences_) return 0;
  const double step = sequences_->element_m;
  const double length = static_cast<double>(site.input.values.size()) - 2;
  return std::min(kPieces_m, step * site.place) +
         std::clamp(step * (length - site.place), 0.0, kPieces_m);
}

void KnownFailures::add(const lane::Polyline& shape, double surroundings_m) {
  if (least_separation(fine_, shape) > reach_m_ / 2) fine_.push_back(shape);
  if (least_separation(coarse_, shape) > reach_m_) coarse_.push_back(shape);
  surroundings_.push_back(surroundings_m);
}

double KnownFailures::novelty(const lane::Polyline& shape) const {
  return (ramp(least_separation(fine_, shape), reach_m_ / 4, reach_m_ * 3 / 4) +
          ramp(least_separation(coarse_, shape), reach_m_ / 2, reach_m_ * 5 / 4)) /
         2;
}

double KnownFailures::surroundings_novelty_m(double surroundings_m) const {
  double least = kMostDifference_m;
  for (const double each : surroundings_) least = std::min(least, std::fabs(each - surroundings_m));
  return least;
}

Turns turns_near(const Site& site, const TestInput& points, double point_m) {
  const std::span<const double> xy = points.values;
  Turns turns;
  if (xy.size() < 6) return turns;
  const double length = static_cast<double>(xy.size() / 2 - 1) * point_m;
  const double worst = site.place * point_m;
  for (double at = worst - kPieces_m + kTurnPiece_m / 2; at < worst + kPieces_m;
       at += kTurnPiece_m) {
    if (at < 0 || at > length) continue;
    const double step = std::floor(at / point_m);
    const double share = at / point_m - step;
    const auto point = static_cast<std::size_t>(step);
    turns.push_back((1 - share) * turn_at(xy, point, point_m) +
                    share * turn_at(xy, point + 1, point_m));
  }
  return turns;
}

double turns_distance(const Turns& a, const Turns& b) {
  std::array<double, kMostPieces + 2> costs{};
  for (std::size_t j = 0; j <= b.size(); ++j) costs[j] = static_cast<double>(j) * kTurnPiece_m;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    double diagonal = costs[0];
    costs[0] = static_cast<double>(i) * kTurnPiece_m;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const double replaced = diagonal + replacement_cost(a[i - 1], b[j - 1]);
      diagonal = costs[j];
      costs[j] = std::min({costs[j] + kTurnPiece_m, costs[j - 1] + kTurnPiece_m, replaced});
    }
  }
  return costs[b.size()];
}

void KnownTurns::add(const Turns& turns) {
  double farthest = 0;
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const double distance = turns_distance(known_[i], turns);
    farthest = std::max(farthest, distance);
    sum_ += std::max(0.0, distance - farthest_[i]);
    farthest_[i] = std::max(farthest_[i], distance);
  }
  known_.push_back(turns);
  farthest_.push_back(farthest);
  sum_ += farthest;
}

double KnownTurns::gain(const Turns& turns) const {
  if (known_.empty()) return 0;
  const std::size_t count = std::min(known_.size(), kCompared);
  const auto all = static_cast<double>(known_.size());
  double own = 0;
  double more = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * known_.size() / count;
    const double distance = turns_distance(known_[at], turns);
    own = std::max(own, distance);
    more += std::max(0.0, distance - farthest_[at]);
  }
  return more * all / static_cast<double>(count) + own - sum_ / all;
}

}  // namespace jaywalk::search
