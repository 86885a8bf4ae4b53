// SPDX-License-Identifier: Apache-2.0
#pragma once

// The actors that a vehicle has to brake for. This is the one definition of when a risk begins: all
// models brake by it, and tests are judged by it (experiment/judge/signals).

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "env/vehicle/sight.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// The free way to something and the speed at which that goes ahead.
struct Hazard {
  double gap_m = std::numeric_limits<double>::infinity();
  double speed_mps = 0;
};

[[nodiscard]] inline Strip lane_of(const VehicleView& view) {
  return {view.lane_left_m, view.lane_right_m};
}

/// Some part of a box with these sides is over the strip; touching its edge is not enough.
[[nodiscard]] bool is_over(double left_m, double right_m, const Strip& strip);
/// The actor's box is over the strip, `after_s` seconds from now if it keeps its speed.
[[nodiscard]] bool is_over(const SeenActor& actor, const Strip& strip, double after_s = 0);

/// Whether a seen actor is a risk: some part of its box is over the vehicle's lane and ahead of the
/// vehicle's front. The risk begins when that becomes true.
[[nodiscard]] bool is_risk(const SeenActor& actor, const Strip& lane);

/// The nearest of the closed stop lines ahead.
[[nodiscard]] std::optional<Hazard> closed_line(const VehicleView& view);

/// The actors that are a risk, and since when.
class Risks {
 public:
  struct Risk {
    double since_s = 0;
    Hazard hazard;
  };

  /// Call this once in every period.
  void look(const VehicleView& view, const Strip& lane);

  [[nodiscard]] const std::map<std::uint32_t, Risk>& all() const { return risks_; }
  /// When the first of the present risks became one; empty if there is no risk.
  [[nodiscard]] std::optional<double> first_s() const;

 private:
  std::map<std::uint32_t, Risk> risks_;
};

/// The risks that have lasted for at least the reaction time: a driver brakes only for what it
/// has perceived.
class Perception {
 public:
  explicit Perception(double reaction_s) : reaction_s_(reaction_s) {}

  /// Call this once in every period. The nearest perceived risk; closed stop lines count.
  std::optional<Hazard> perceive(const VehicleView& view, const Strip& lane);

 private:
  double reaction_s_;
  Risks risks_;
};

/// The braking with which a vehicle stops `standoff_m` before the hazard, positive; infinite if
/// that cannot be done any more.
[[nodiscard]] double required_deceleration(const VehicleView& view, const Hazard& hazard,
                                           double standoff_m);

/// Braking that passengers do not mind, m/s^2; also the least at which it makes sense to begin.
inline constexpr double kComfortableMps2 = 2;

/// Stops at closed lines as any driver would: it begins when comfortable braking is needed, and
/// goes on until the line opens. The closing of each line is perceived after the reaction time,
/// like a risk, independently of other lines.
class LineStop {
 public:
  /// Seconds from the closing of a line until braking may begin.
  explicit LineStop(double reacts_s = 0) : reacts_s_(reacts_s) {}

  /// Call this once in every period. The braking for the nearest line, positive; empty if none is
  /// needed.
  std::optional<double> braking(const VehicleView& view, double strongest_mps2);

 private:
  struct Line {
    double place_m = 0;
    double gap_m = 0;
    double closed_s = 0;
  };

  void look(const VehicleView& view);
  [[nodiscard]] const Line* known(double place_m) const;
  [[nodiscard]] const Line* nearest(const VehicleView& view) const;

  double reacts_s_;
  std::vector<Line> closed_;
  std::optional<double> stops_at_m_;
};

/// Back to the cruising speed without overshooting it.
[[nodiscard]] double resume(const VehicleView& view, double acceleration_mps2);

}  // namespace jaywalk
