// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "env/vehicle/careful_driver.h"
#include "env/vehicle/hazards.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {
namespace {

class Braking final : public VehicleController {
 public:
  explicit Braking(const VehicleParameters& parameters)
      : perception_(parameters.reaction_s.value_or(0.5)),
        deceleration_(parameters.deceleration_mps2.value_or(6)),
        acceleration_(parameters.acceleration_mps2),
        standoff_m_(parameters.standoff_m) {}

  VehicleDecision decide(const VehicleView& view) override {
    const std::optional<Hazard> hazard = perception_.perceive(view, lane_of(view));
    if (!hazard) return {resume(view, acceleration_)};
    const double needed = required_deceleration(view, *hazard, standoff_m_);
    if (needed >= kComfortableMps2) braking_ = true;
    if (needed < kComfortableMps2 / 2) braking_ = false;
    if (braking_) return {-std::min(needed, deceleration_)};
    // Far away: roll on, but do not accelerate towards an actor.
    return {std::min(resume(view, acceleration_), 0.0)};
  }

 private:
  Perception perception_;
  double deceleration_;
  double acceleration_;
  double standoff_m_;
  bool braking_ = false;
};

class EmergencyBraking final : public VehicleController {
 public:
  explicit EmergencyBraking(const VehicleParameters& parameters)
      : reaction_s_(parameters.reaction_s.value_or(0)),
        deceleration_(parameters.deceleration_mps2.value_or(9)),
        acceleration_(parameters.acceleration_mps2) {}

  VehicleDecision decide(const VehicleView& view) override {
    const bool threat = std::ranges::any_of(
        view.actors, [&](const SeenActor& actor) { return is_threat(view, actor); });
    if (!threat) threat_since_s_.reset();
    if (threat && !threat_since_s_) threat_since_s_ = view.time_s;
    const bool acts = threat && view.time_s - *threat_since_s_ + 1e-9 >= reaction_s_;
    if (acts) return {-deceleration_};
    // For a closed line it stops as any driver would, not in an emergency.
    if (const auto braking = line_stop_.braking(view, deceleration_)) return {-*braking};
    return {threat ? 0 : resume(view, acceleration_)};
  }

 private:
  static constexpr double kTriggerS = 1.1;
  static constexpr double kMarginM = 0.3;

  // Once it stands, it stays for as long as an actor is right in front of it.
  static bool is_threat(const VehicleView& view, const SeenActor& actor) {
    const Strip path{view.left_m - kMarginM, view.right_m + kMarginM};
    if (actor.gap_m < 0) return false;
    const double closing = view.speed_mps - actor.speed_ahead_mps;
    if (view.speed_mps <= 0) return actor.gap_m < view.cruise_mps && is_over(actor, path);
    if (closing <= 0) return false;
    const double ttc = actor.gap_m / closing;
    return ttc < kTriggerS && (is_over(actor, path) || is_over(actor, path, ttc));
  }

  double reaction_s_;
  double deceleration_;
  double acceleration_;
  std::optional<double> threat_since_s_;
  LineStop line_stop_;
};

class IntelligentDriver final : public VehicleController {
 public:
  explicit IntelligentDriver(const VehicleParameters& parameters)
      : perception_(parameters.reaction_s.value_or(0)),
        deceleration_(parameters.deceleration_mps2.value_or(8)),
        acceleration_(parameters.acceleration_mps2),
        standoff_m_(parameters.standoff_m) {}

  VehicleDecision decide(const VehicleView& view) override {
    const double free = 1 - std::pow(view.speed_mps / view.cruise_mps, 4);
    const std::optional<Hazard> leader = perception_.perceive(view, lane_of(view));
    if (!leader) return {acceleration_ * free};
    const double closing = view.speed_mps - leader->speed_mps;
    const double wanted =
        standoff_m_ + std::max(0.0, view.speed_mps * kHeadwayS +
                                        view.speed_mps * closing /
                                            (2 * std::sqrt(acceleration_ * kComfortableMps2)));
    const double gap = std::max(leader->gap_m, 0.01);
    const double interaction = wanted / gap;
    return {std::max(acceleration_ * (free - interaction * interaction), -deceleration_)};
  }

 private:
  static constexpr double kHeadwayS = 1.5;

  Perception perception_;
  double deceleration_;
  double acceleration_;
  double standoff_m_;
};

}  // namespace

std::unique_ptr<VehicleController> make_constant(const VehicleParameters&) { return nullptr; }

std::unique_ptr<VehicleController> make_braking(const VehicleParameters& parameters) {
  return std::make_unique<Braking>(parameters);
}

std::unique_ptr<VehicleController> make_careful_competent(const VehicleParameters& parameters) {
  return std::make_unique<CarefulDriver>(parameters);
}

std::unique_ptr<VehicleController> make_aeb(const VehicleParameters& parameters) {
  return std::make_unique<EmergencyBraking>(parameters);
}

std::unique_ptr<VehicleController> make_idm(const VehicleParameters& parameters) {
  return std::make_unique<IntelligentDriver>(parameters);
}

}  // namespace jaywalk
