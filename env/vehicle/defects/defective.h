// SPDX-License-Identifier: Apache-2.0
#pragma once

// The base of all defects: a controller around another one that changes the view of the inner one
// or how its answers are carried out.

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "env/vehicle/defects.h"
#include "env/vehicle/hazards.h"

namespace jaywalk {

/// The parts of a view that a defect can change.
struct Sensed {
  std::vector<SeenActor> actors;
  std::vector<StopLine> stop_lines;
};

class Defective : public VehicleController {
 public:
  void put_on(std::unique_ptr<VehicleController> inner, double severity) {
    inner_ = std::move(inner);
    severity_ = severity;
  }

  VehicleDecision decide(const VehicleView& view) final {
    Sensed sensed{{view.actors.begin(), view.actors.end()},
                  {view.stop_lines.begin(), view.stop_lines.end()}};
    look(view, sensed);
    VehicleView seen = view;
    seen.actors = sensed.actors;
    seen.stop_lines = sensed.stop_lines;
    return {act(view, inner_->decide(seen).acceleration_mps2)};
  }
  void begin(const DriveBriefing& briefing) override { inner_->begin(briefing); }
  void end(const DriveEnd& end) override { inner_->end(end); }
  [[nodiscard]] std::vector<std::string> take_notes() override { return inner_->take_notes(); }
  [[nodiscard]] double longest_period_s() const override { return inner_->longest_period_s(); }
  [[nodiscard]] std::string failure() const override { return inner_->failure(); }

 protected:
  /// Changes the view of the inner controller.
  virtual void look(const VehicleView& /*view*/, Sensed& /*sensed*/) {}
  /// Turns the acceleration that the inner controller wants into that of the vehicle.
  virtual double act(const VehicleView& /*view*/, double wanted_mps2) { return wanted_mps2; }

  double severity_ = 0;  // in the row's unit

 private:
  std::unique_ptr<VehicleController> inner_;
};

/// Does not see actors for which the predicate of view, actor and severity is true.
template <bool (*is_missed)(const VehicleView&, const SeenActor&, double)>
class Unseeing final : public Defective {
  void look(const VehicleView& view, Sensed& sensed) override {
    std::erase_if(sensed.actors,
                  [&](const SeenActor& each) { return is_missed(view, each, severity_); });
  }
};

using DefectMaker = decltype(DefectModel::make);

/// Puts a defect on a controller.
template <class Defect>
std::unique_ptr<VehicleController> put(std::unique_ptr<VehicleController> inner, double severity) {
  auto defect = std::make_unique<Defect>();
  defect->put_on(std::move(inner), severity);
  return defect;
}

// Each row's maker, which is in the file of its family.
#define JAYWALK_DEFECT(name, family, unit, maker, summary, source, ...) \
  extern const DefectMaker maker;
#include "env/vehicle/defects.def"
#undef JAYWALK_DEFECT

/// Times are sums of periods; those that differ by less are equal but for rounding.
inline constexpr double kTimeRoundingS = 1e-9;
/// Slower actors count as standing.
inline constexpr double kStandingMps = 0.1;
/// Weaker braking than this is coasting.
inline constexpr double kCoastingMps2 = 0.1;

[[nodiscard]] inline bool brakes(double acceleration_mps2) {
  return acceleration_mps2 < -kCoastingMps2;
}
[[nodiscard]] inline double middle_of(const SeenActor& actor) {
  return (actor.left_m + actor.right_m) / 2;
}
[[nodiscard]] inline double speed_of(const SeenActor& actor) {
  return std::hypot(actor.speed_ahead_mps, actor.speed_right_mps);
}

/// How far the vehicle has come since the first view, so that places can be remembered.
class Odometer {
 public:
  /// Call this once in every period.
  double driven_m(const VehicleView& view) {
    if (time_s_) driven_m_ += (speed_mps_ + view.speed_mps) / 2 * (view.time_s - *time_s_);
    time_s_ = view.time_s;
    speed_mps_ = view.speed_mps;
    return driven_m_;
  }

 private:
  std::optional<double> time_s_;
  double speed_mps_ = 0;
  double driven_m_ = 0;
};

}  // namespace jaywalk
