#pragma once

// Whom a vehicle has to mind: what its models share.

#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// The free way to something and the speed at which that goes ahead.
struct Hazard {
  double gap_m = std::numeric_limits<double>::infinity();
  double speed_mps = 0;
};

/// A strip of the road as its sides in metres from the world's left.
struct Strip {
  double left_m = 0;
  double right_m = 0;
};

[[nodiscard]] inline Strip lane_of(const VehicleView& view) {
  return {view.lane_left_m, view.lane_right_m};
}
[[nodiscard]] inline Strip body(const VehicleView& view) { return {view.left_m, view.right_m}; }

/// The actor's box is over the strip, `after_s` seconds from now if it keeps its speed.
[[nodiscard]] bool is_over(const SeenActor& actor, const Strip& strip, double after_s = 0);

/// The nearest of the closed stop lines ahead.
[[nodiscard]] std::optional<Hazard> closed_line(const VehicleView& view);

/// Whoever has been over a strip and ahead of the vehicle for at least the reaction time: nobody
/// brakes for what they have not yet perceived.
class Perception {
 public:
  explicit Perception(double reaction_s) : reaction_s_(reaction_s) {}

  /// To be called once in every period. The nearest of those perceived; closed stop lines count.
  std::optional<Hazard> perceive(const VehicleView& view, const Strip& strip);

 private:
  double reaction_s_;
  std::map<std::uint32_t, double> since_s_;  // when somebody was first over the strip
};

/// The braking with which a vehicle stops `standoff_m` before the hazard, positive; infinite if
/// that cannot be done any more.
[[nodiscard]] double required_deceleration(const VehicleView& view, const Hazard& hazard,
                                           double standoff_m);

}  // namespace jaywalk
