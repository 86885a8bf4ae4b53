// SPDX-License-Identifier: Apache-2.0
#include "env/lane/elastic_band.h"

#include <algorithm>
#include <cmath>

namespace jaywalk::lane {
namespace {

constexpr double kOverRelaxation = 1.5;
constexpr std::size_t kLeastNodes = 5;
/// Sweeps that are computed together.
constexpr int kTogether = 4;

Point between(const Point& a, const Point& b, double share) {
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
}

/// Nodes at equal distances along the line, and the vector of a shift by one metre to the left.
class Band {
 public:
  Band(const Polyline& centre, double node_m) {
    std::vector<double> arcs(centre.size());
    for (std::size_t i = 1; i < centre.size(); ++i) {
      arcs[i] = arcs[i - 1] + distance(centre[i - 1], centre[i]);
    }
    const auto nodes = std::max(kLeastNodes, static_cast<std::size_t>(arcs.back() / node_m) + 1);
    step_ = arcs.back() / static_cast<double>(nodes - 1);
    std::size_t j = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      const double arc = static_cast<double>(i) * step_;
      while (j + 2 < centre.size() && arcs[j + 1] < arc) ++j;
      const double share = std::min(1.0, (arc - arcs[j]) / (arcs[j + 1] - arcs[j]));
      nodes_.push_back(between(centre[j], centre[j + 1], share));
    }
    for (std::size_t i = 0; i < nodes; ++i) {
      const Point& a = nodes_[i > 0 ? i - 1 : 0];
      const Point& b = nodes_[std::min(nodes - 1, i + 1)];
      const double norm = distance(a, b);
      normals_.push_back({-(b.y_m - a.y_m) / norm, (b.x_m - a.x_m) / norm});
    }
    line_ = nodes_;
    offsets_.resize(nodes);
  }

  void relax(const BandParameters& p) {
    // Bending energy goes with the fourth power of the distance of nodes: so the line does not
    // depend on it.
    const double spring = std::pow(step_ / p.stiffness_m, 4);
    // The car starts in the middle of its lane and straight on.
    const std::size_t fixed = static_cast<std::size_t>(p.start_m / step_) + 2;
    for (int sweep = 0; sweep < p.sweeps; sweep += kTogether) {
      relax_together(fixed, std::min(kTogether, p.sweeps - sweep),
                     [&](std::size_t i) { shift(i, spring, -p.most_right_m, p.most_left_m); });
    }
  }

  [[nodiscard]] Polyline smooth() const {
    Polyline line;
    const auto parts = std::max(1L, std::lround(step_));
    for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
      const Point& a = line_[i > 0 ? i - 1 : 0];
      const Point& b = line_[i];
      const Point& c = line_[i + 1];
      const Point& d = line_[std::min(line_.size() - 1, i + 2)];
      for (long k = 0; k < parts; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(parts);
        line.push_back({catmull_rom(a.x_m, b.x_m, c.x_m, d.x_m, t),
                        catmull_rom(a.y_m, b.y_m, c.y_m, d.y_m, t)});
      }
    }
    line.push_back(line_.back());
    return line;
  }

 private:
  static double catmull_rom(double a, double b, double c, double d, double t) {
    return 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                  (3 * b - a - 3 * c + d) * t * t * t);
  }

  /// Some sweeps, each three nodes behind the one before: a node's shift depends on two to either
  /// side, so all is as in one sweep after another, but the processor can compute several at once.
  template <class Shift>
  void relax_together(std::size_t fixed, int sweeps, Shift shift) const {
    constexpr std::size_t kBehind = 3;
    const auto count = static_cast<std::size_t>(sweeps);
    for (std::size_t first = fixed; first < nodes_.size() + kBehind * (count - 1); ++first) {
      for (std::size_t sweep = 0; sweep < count; ++sweep) {
        if (first < fixed + kBehind * sweep) break;
        const std::size_t i = first - kBehind * sweep;
        if (i < nodes_.size()) shift(i);
      }
    }
  }

  /// One step of Newton's method in the offset of one node: the bending at it and its neighbours.
  void shift(std::size_t i, double spring, double least, double most) {
    double gradient = spring * offsets_[i];
    double curvature = spring;
    for (std::size_t k = i - 1; k <= i + 1; ++k) {
      if (k < 1 || k + 2 > line_.size()) continue;
      const Point& u = line_[k - 1];
      const Point& v = line_[k];
      const Point& w = line_[k + 1];
      // The second difference at k, by the offset of node i.
      const double weight = k == i ? -2 : 1;
      gradient += weight * ((u.x_m - 2 * v.x_m + w.x_m) * normals_[i].x_m +
                            (u.y_m - 2 * v.y_m + w.y_m) * normals_[i].y_m);
      curvature += weight * weight;
    }
    offsets_[i] = std::clamp(offsets_[i] - kOverRelaxation * gradient / curvature, least, most);
    line_[i] = {nodes_[i].x_m + offsets_[i] * normals_[i].x_m,
                nodes_[i].y_m + offsets_[i] * normals_[i].y_m};
  }

  double step_ = 1;
  Polyline nodes_;
  Polyline normals_;
  Polyline line_;  // the nodes, shifted
  std::vector<double> offsets_;
};

}  // namespace

Polyline elastic_band(const Polyline& centre, const BandParameters& parameters) {
  Band band(centre, parameters.node_m);
  band.relax(parameters);
  return band.smooth();
}

}  // namespace jaywalk::lane
