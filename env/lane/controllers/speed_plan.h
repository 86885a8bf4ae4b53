#pragma once

// A speed for every point of a path: what its curvature allows, reached by braking in time. Shared
// by controllers that follow a path. Read path.h first.

#include <vector>

#include "env/lane/path.h"

namespace jaywalk::lane {

struct SpeedPlanParameters {
  double speed_limit_mps = 0;
  /// In curves, and when braking for them, m/s2.
  double lateral_acceleration = 4.6;
  double braking = 5.6;
  double preview_m = 22.5;
  double latency_s = 0;
  /// Acceleration per difference of speed, 1/s, and its bounds, m/s2.
  double gain = 2.7;
  double most_acceleration = 6.5;
  double most_braking = 8;
};

class SpeedPlan {
 public:
  SpeedPlan(const Path& path, const SpeedPlanParameters& parameters);

  /// For a car beside point `near` of the path.
  [[nodiscard]] double acceleration(const Path& path, std::size_t near, double speed_mps) const;

 private:
  SpeedPlanParameters parameters_;
  std::vector<double> squares_;  // of each point's speed
};

}  // namespace jaywalk::lane
