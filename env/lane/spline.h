// SPDX-License-Identifier: Apache-2.0
#pragma once

// The curve through a road's points as the SBST/SBFT CPS competition draws it: SciPy's
// splprep(s=0). Read road.h next.

#include <optional>
#include <span>
#include <vector>

#include "env/scene.h"

namespace jaywalk::lane {

/// The interpolating spline over the points' relative chord length u: a straight line for two
/// points, a parabola for three, else the cubic spline whose third derivative is continuous at the
/// second and the last but one point ("not-a-knot").
class Spline {
 public:
  /// One stretch between two points: position = c0 + c1 t + c2 t^2 + c3 t^3, t from 0 to `length`.
  struct Piece {
    double length = 0;
    Point c0, c1, c2, c3;
  };

  /// None if there are fewer than two points or two neighbours coincide.
  [[nodiscard]] static std::optional<Spline> through(std::span<const Point> points);

  /// The point at u, 0 at the first and 1 at the last one; beyond them the outer pieces go on.
  [[nodiscard]] Point at(double u) const;

  /// The pieces in order; one between each two points, or one in all for three points.
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  Spline() = default;

  std::vector<double> knots_;  // where each piece begins
  std::vector<Piece> pieces_;
};

}  // namespace jaywalk::lane
