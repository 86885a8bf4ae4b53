// SPDX-License-Identifier: Apache-2.0
#include "search/failing_stretch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "env/lane/path.h"
#include "search/run_summary.h"
#include "search/sut.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {
namespace {

constexpr double kStep_m = 2.5;
constexpr double kSameTurn_deg = 0.3;
constexpr double kSameLength_m = 0.2;
/// More than what sums of costs in different orders differ by.
constexpr double kRounding = 1e-9;

/// A line by its arc length, straight on beyond its ends.
class ArcLine {
 public:
  explicit ArcLine(lane::Polyline points) : path_(std::move(points)) {}

  [[nodiscard]] const lane::Path& path() const { return path_; }

  [[nodiscard]] Point at(double arc_m) const {
    const std::size_t i = piece(arc_m);
    const double along = arc_m - path_.arc_m(i);
    return {path_.point(i).x_m + along * std::cos(path_.heading(i)),
            path_.point(i).y_m + along * std::sin(path_.heading(i))};
  }

  /// Between the middles of two pieces it changes evenly, so that it does not depend on where the
  /// line's points happen to lie.
  [[nodiscard]] double heading(double arc_m) const {
    const std::size_t i = piece(arc_m);
    const std::size_t last = path_.size() - 2;
    const double middle = (path_.arc_m(i) + path_.arc_m(i + 1)) / 2;
    if ((arc_m < middle && i == 0) || (arc_m >= middle && i == last)) return path_.heading(i);
    // The two pieces between whose middles the place lies.
    const std::size_t from = arc_m < middle ? i - 1 : i;
    const double begin = (path_.arc_m(from) + path_.arc_m(from + 1)) / 2;
    const double end = (path_.arc_m(from + 1) + path_.arc_m(from + 2)) / 2;
    return path_.heading(from) + lane::wrapped(path_.heading(from + 1) - path_.heading(from)) *
                                     (arc_m - begin) / (end - begin);
  }

 private:
  /// The piece that begins at or before that place; the first or the last one beyond the ends.
  [[nodiscard]] std::size_t piece(double arc_m) const {
    std::size_t low = 0;
    std::size_t high = path_.size() - 2;
    while (low < high) {
      const std::size_t middle = (low + high + 1) / 2;
      if (path_.arc_m(middle) <= arc_m) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  lane::Path path_;
};

lane::Polyline aligned(const ArcLine& line, double worst_m) {
  const Point origin = line.at(worst_m);
  const double c = std::cos(line.heading(worst_m));
  const double s = std::sin(line.heading(worst_m));
  lane::Polyline points;
  for (int i = 0; i <= static_cast<int>((kStretchBefore_m + kStretchAfter_m) / kStep_m); ++i) {
    const Point point = line.at(worst_m - kStretchBefore_m + i * kStep_m);
    const double dx = point.x_m - origin.x_m;
    const double dy = point.y_m - origin.y_m;
    // Turned so that the road runs along +x at the worst place, whatever its direction was.
    points.push_back({c * dx + s * dy, c * dy - s * dx});
  }
  return points;
}

std::vector<RoadPiece> pieces_near(const lane::Path& path, double worst_m) {
  std::vector<RoadPiece> pieces;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.arc_m(i) < worst_m - kPieces_m || path.arc_m(i + 1) > worst_m + kPieces_m) continue;
    const double turn = pieces.empty() ? 0 : lane::wrapped(path.heading(i) - path.heading(i - 1));
    pieces.push_back({turn * 180 / std::numbers::pi, path.arc_m(i + 1) - path.arc_m(i)});
  }
  return pieces;
}

double replacement_cost(const RoadPiece& a, const RoadPiece& b) {
  const double turn = std::fabs(a.turn_deg - b.turn_deg);
  const double length = std::fabs(a.length_m - b.length_m);
  // The tool competition's measure: each part of the cost saturates at 1.
  if (turn < kSameTurn_deg && length < kSameLength_m) return 0;
  return (turn / (1 + turn) + length / (1 + length)) / 2;
}

}  // namespace

bool measures_stretches(const SutModel& model) {
  return model.road_space() != nullptr && find_measure(model.measures(), "worst_arc_m").has_value();
}

namespace {

struct WorstPlace {
  ArcLine line;
  double arc_m;
};

std::optional<WorstPlace> find_worst(const ExecutedTest& test, const SutModel& model) {
  const auto measure = find_measure(model.measures(), "worst_arc_m");
  if (!measures_stretches(model) || *measure >= test.outcome.measures.size()) return std::nullopt;
  auto middle = lane::interpolate(model.road_space()->road_points(test.input));
  if (!middle) return std::nullopt;
  return WorstPlace{ArcLine(std::move(*middle)), test.outcome.measures[*measure]};
}

}  // namespace

std::optional<FailingStretch> failing_stretch(const ExecutedTest& test, const SutModel& model) {
  const auto worst = find_worst(test, model);
  if (!worst) return std::nullopt;
  return FailingStretch{aligned(worst->line, worst->arc_m),
                        pieces_near(worst->line.path(), worst->arc_m)};
}

std::optional<Point> worst_place(const ExecutedTest& test, const SutModel& model) {
  const auto worst = find_worst(test, model);
  if (!worst) return std::nullopt;
  return worst->line.at(worst->arc_m);
}

double separation_m(const lane::Polyline& a, const lane::Polyline& b) {
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double dx = a[i].x_m - b[i].x_m;
    const double dy = a[i].y_m - b[i].y_m;
    most = std::max(most, dx * dx + dy * dy);
  }
  return std::sqrt(most);
}

std::size_t distinct(std::span<const FailingStretch> stretches, double reach_m) {
  const auto same = [&](std::size_t a, std::size_t b) {
    return separation_m(stretches[a], stretches[b]) <= reach_m;
  };
  return cluster(stretches.size(), same).size();
}

double twin_share(std::span<const FailingStretch> stretches, double reach_m) {
  if (stretches.empty()) return 0;
  double twins = 0;
  for (const FailingStretch& each : stretches) {
    twins += std::ranges::any_of(stretches, [&](const FailingStretch& other) {
      return &other != &each && separation_m(each, other) <= reach_m;
    });
  }
  return twins / static_cast<double>(stretches.size());
}

double edit_distance(std::span<const RoadPiece> a, std::span<const RoadPiece> b) {
  // One row of the usual table, overwritten from left to right; `diagonal` is the former value.
  std::vector<double> costs(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) costs[j] = static_cast<double>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    double diagonal = costs[0];
    costs[0] = static_cast<double>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const double replaced = diagonal + replacement_cost(a[i - 1], b[j - 1]);
      diagonal = costs[j];
      costs[j] = std::min({costs[j] + 1, costs[j - 1] + 1, replaced});
    }
  }
  return costs.back();
}

namespace {

/// An upper bound on the edit distance: each piece is replaced by the other sequence's piece of the
/// same number, counted from the beginning or from the end, and the rest is inserted.
double most_edit_distance(std::span<const RoadPiece> a, std::span<const RoadPiece> b) {
  if (a.size() > b.size()) std::swap(a, b);
  const std::size_t more = b.size() - a.size();
  double from_beginning = 0;
  double from_end = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    from_beginning += replacement_cost(a[i], b[i]);
    from_end += replacement_cost(a[i], b[i + more]);
  }
  return std::min(from_beginning, from_end) + static_cast<double>(more);
}

}  // namespace

double sparseness(std::span<const FailingStretch> stretches) {
  const std::size_t count = std::min(stretches.size(), kMostCompared);
  if (count < 2) return 0;
  const auto pieces = [&](std::size_t i) -> const std::vector<RoadPiece>& {
    // If there are more stretches than are compared, take evenly spaced ones.
    return stretches[i * stretches.size() / count].pieces;
  };
  std::vector<double> farthest(count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // Only those that may be farther than the farthest so far are compared, what may be the
    // farthest first.
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t j = 0; j < count; ++j) {
      if (j != i) others.emplace_back(most_edit_distance(pieces(i), pieces(j)) + kRounding, j);
    }
    std::ranges::sort(others, std::greater<>{});
    for (const auto& [most, j] : others) {
      if (most <= farthest[i]) break;
      // Always in the same order: the sums of the other one may differ by rounding.
      const double distance = edit_distance(pieces(std::min(i, j)), pieces(std::max(i, j)));
      farthest[i] = std::max(farthest[i], distance);
      farthest[j] = std::max(farthest[j], distance);
    }
    sum += farthest[i];
  }
  return sum / static_cast<double>(count);
}

}  // namespace jaywalk::search
