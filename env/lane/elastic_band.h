// SPDX-License-Identifier: Apache-2.0
#pragma once

// The line of a driver that cuts corners: an elastic band along the lane's middle. Read road.h
// first.

#include "env/lane/road.h"

namespace jaywalk::lane {

struct BandParameters {
  /// Distance of the nodes, the length over which a shift to the side is regretted as much as the
  /// bending that it saves, and the most that it may be to either side.
  double node_m = 2;
  double stiffness_m = 21;
  double most_left_m = 1.2;
  double most_right_m = 1.6;
  /// The line stays in the middle up to here.
  double start_m = 2.5;
  int sweeps = 150;
};

/// A band that is drawn to the least of bending and lateral spring energy, by Gauss-Seidel with
/// over-relaxation over the nodes' lateral offsets; then about a point each metre (Catmull-Rom).
/// After 150 sweeps it is not at rest: around a corner it may lie a metre from where more would
/// bring it. The cars are calibrated with that many.
[[nodiscard]] Polyline elastic_band(const Polyline& centre, const BandParameters& parameters);

}  // namespace jaywalk::lane
