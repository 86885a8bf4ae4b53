// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rows of the reference data beside this file; data/README.md names their sources.

#include <string>
#include <vector>

#include "env/lane/road.h"

namespace jaywalk::lane {

/// A road and what the competition's validator says of it.
struct JudgedRoad {
  std::string family;
  std::size_t interpolated = 0;
  std::string message;
  Polyline points;
};

/// A road that was executed in BeamNG.tech.
struct ExecutedRoad {
  double max_oob = 0;
  std::vector<double> curvatures;

  /// As its source makes them, a point for each curvature: the heading begins with 1.57 and turns
  /// by 10 m times the curvature from point to point; a step is 10 m times the mean of the
  /// directions before and after it.
  [[nodiscard]] Polyline points() const;
};

[[nodiscard]] std::vector<JudgedRoad> judged_roads();
/// Those beside this file or, if the environment variable JAYWALK_EXECUTED_ROADS names another file
/// whose last two columns are the same, its roads.
[[nodiscard]] std::vector<ExecutedRoad> executed_roads();

}  // namespace jaywalk::lane
