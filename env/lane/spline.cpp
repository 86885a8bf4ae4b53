// SPDX-License-Identifier: Apache-2.0
#include "env/lane/spline.h"

#include <algorithm>
#include <cmath>

namespace jaywalk::lane {
namespace {

using Numbers = std::vector<double>;

/// Slopes of the not-a-knot cubic spline at its knots: a tridiagonal system, solved by Thomas's
/// algorithm (de Boor 1978, "A Practical Guide to Splines", chapter IV). REQUIRES: four knots.
Numbers slopes(const Numbers& x, const Numbers& y) {
  const std::size_t n = x.size();
  Numbers h(n - 1);
  Numbers d(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x[i + 1] - x[i];
    d[i] = (y[i + 1] - y[i]) / h[i];
  }
  Numbers lower(n);
  Numbers diagonal(n);
  Numbers upper(n);
  Numbers right(n);
  double width = x[2] - x[0];
  // Not-a-knot: the third derivative is continuous at the second knot and at the last but one.
  diagonal[0] = h[1];
  upper[0] = width;
  right[0] = ((h[0] + 2 * width) * h[1] * d[0] + h[0] * h[0] * d[1]) / width;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    lower[i] = h[i];
    diagonal[i] = 2 * (h[i - 1] + h[i]);
    upper[i] = h[i - 1];
    right[i] = 3 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
  }
  width = x[n - 1] - x[n - 3];
  lower[n - 1] = width;
  diagonal[n - 1] = h[n - 3];
  right[n - 1] =
      (h[n - 2] * h[n - 2] * d[n - 3] + (2 * width + h[n - 2]) * h[n - 3] * d[n - 2]) / width;
  for (std::size_t i = 1; i < n; ++i) {
    // Forward elimination, then back substitution.
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  Numbers result(n);
  result[n - 1] = right[n - 1] / diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) {
    result[i] = (right[i] - upper[i] * result[i + 1]) / diagonal[i];
  }
  return result;
}

/// The coefficients of one coordinate of a cubic piece.
struct Cubic {
  double c1, c2, c3;
};
Cubic hermite(double h, double from, double to, double slope_from, double slope_to) {
  const double d = (to - from) / h;
  const double c = (slope_from + slope_to - 2 * d) / h;
  return {slope_from, (d - slope_from) / h - c, c / h};
}

std::vector<Spline::Piece> cubic_pieces(std::span<const Point> points, const Numbers& u) {
  Numbers xs;
  Numbers ys;
  for (const Point& point : points) {
    xs.push_back(point.x_m);
    ys.push_back(point.y_m);
  }
  const Numbers dx = slopes(u, xs);
  const Numbers dy = slopes(u, ys);
  std::vector<Spline::Piece> pieces;
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    const double h = u[i + 1] - u[i];
    const Cubic x = hermite(h, xs[i], xs[i + 1], dx[i], dx[i + 1]);
    const Cubic y = hermite(h, ys[i], ys[i + 1], dy[i], dy[i + 1]);
    pieces.push_back({h, points[i], {x.c1, y.c1}, {x.c2, y.c2}, {x.c3, y.c3}});
  }
  return pieces;
}

/// Newton's form of the parabola through three points, expanded.
Spline::Piece parabola(std::span<const Point> p, double middle) {
  const auto coefficients = [&](double a, double b, double c) {
    const double first = (b - a) / middle;
    const double second = (c - b) / (1 - middle);
    const double bend = second - first;
    return Cubic{first - middle * bend, bend, 0};
  };
  const Cubic x = coefficients(p[0].x_m, p[1].x_m, p[2].x_m);
  const Cubic y = coefficients(p[0].y_m, p[1].y_m, p[2].y_m);
  return {1, p[0], {x.c1, y.c1}, {x.c2, y.c2}, {0, 0}};
}

/// Relative chord lengths; empty if two neighbours coincide or a number is not finite.
Numbers chord_lengths(std::span<const Point> points) {
  Numbers u{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double dx = points[i].x_m - points[i - 1].x_m;
    const double dy = points[i].y_m - points[i - 1].y_m;
    // Not std::hypot: its last bit differs, and the number of interpolated points depends on it.
    u.push_back(u.back() + std::sqrt(dx * dx + dy * dy));
    if (!(u[i] > u[i - 1]) || !std::isfinite(u[i])) return {};
  }
  const double length = u.back();
  for (double& each : u) each /= length;
  return u;
}

}  // namespace

std::optional<Spline> Spline::through(std::span<const Point> points) {
  if (points.size() < 2) return std::nullopt;
  Numbers u = chord_lengths(points);
  if (u.empty()) return std::nullopt;
  Spline spline;
  if (points.size() == 2) {
    const Point along{points[1].x_m - points[0].x_m, points[1].y_m - points[0].y_m};
    spline.pieces_ = {{1, points[0], along, {}, {}}};
  } else if (points.size() == 3) {
    spline.pieces_ = {parabola(points, u[1])};
  } else {
    spline.pieces_ = cubic_pieces(points, u);
  }
  // Only the knots at which pieces begin are kept.
  u.resize(spline.pieces_.size());
  spline.knots_ = std::move(u);
  return spline;
}

Point Spline::at(double u) const {
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), u);
  const auto index = static_cast<std::size_t>(above - knots_.begin());
  const std::size_t i = index == 0 ? 0 : index - 1;
  const Piece& p = pieces_[i];
  const double t = u - knots_[i];
  const auto value = [t](double c0, double c1, double c2, double c3) {
    return c0 + t * (c1 + t * (c2 + t * c3));
  };
  return {value(p.c0.x_m, p.c1.x_m, p.c2.x_m, p.c3.x_m),
          value(p.c0.y_m, p.c1.y_m, p.c2.y_m, p.c3.y_m)};
}

}  // namespace jaywalk::lane
