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
};

[[nodiscard]] std::vector<JudgedRoad> judged_roads();
[[nodiscard]] std::vector<ExecutedRoad> executed_roads();

}  // namespace jaywalk::lane
