#include "search/generators/turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "search/failing_stretch.h"

namespace jaywalk::search {
namespace {

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
