#include "env/lane/controllers/speed_plan.h"

#include <algorithm>
#include <cmath>

namespace jaywalk::lane {

SpeedPlan::SpeedPlan(const Path& path, const SpeedPlanParameters& parameters)
    : parameters_(parameters) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    squares_.push_back(parameters.lateral_acceleration /
                       std::max(1e-5, std::fabs(path.curvature(i))));
  }
}

double SpeedPlan::acceleration(const Path& path, std::size_t near, double speed_mps) const {
  const SpeedPlanParameters& p = parameters_;
  const double reaction = speed_mps * p.latency_s;
  double wanted2 = p.speed_limit_mps * p.speed_limit_mps;
  double distance = 0;  // to the point that asks for the least speed
  for (std::size_t i = near; i < path.size(); ++i) {
    const double arc = path.arc_m(i) - path.arc_m(near);
    if (arc > p.preview_m) break;
    const double ahead = std::max(0.0, arc - reaction);
    const double allowed2 = squares_[i] + 2 * p.braking * ahead;
    if (allowed2 >= wanted2) continue;
    wanted2 = allowed2;
    distance = ahead;
  }
  const double wanted = std::sqrt(wanted2);
  const double used = std::min(
      1.0, std::fabs(path.curvature(near)) * speed_mps * speed_mps / p.lateral_acceleration);
  const bool brakes = distance > 0 && speed_mps > wanted - 0.5;
  return std::clamp(p.gain * (wanted - speed_mps) - (brakes ? p.braking : 0), -p.most_braking,
                    p.most_acceleration * std::sqrt(1 - used * used));
}

}  // namespace jaywalk::lane
