// SPDX-License-Identifier: Apache-2.0
#pragma once

// The world of the motorway: agents drive vehicles beside an automated vehicle (AV) that keeps its
// lane. A test asks whether some agent cuts in before it. Read parameters.h before; words.def lists
// what agents perceive and do.
//
// Tick t: all agents perceive what tick t - 1 left; their actions take effect at once; then all
// vehicles drive for a tick in steps of at most 0.1 s, the AV deciding as often as its model wants.
//
// Agents' vehicles that touch have crashed: both brake to a stand as hard as they can, change lanes
// no further and ignore their agents; they stay where they stand. The test goes on.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/environments.h"
#include "env/motorway/parameters.h"
#include "env/scene.h"
#include "env/world/world.h"
#include "interpreter/term/symbol.h"
#include "interpreter/term/value.h"

namespace jaywalk {

#define JAYWALK_PERCEPT(id, form, meaning) id,
#define JAYWALK_ACTION(id, ...)
enum class MotorwayPercept : std::size_t {
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning)
#define JAYWALK_ACTION(id, ...) id,
enum class MotorwayAction : std::size_t {
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning) EnvironmentWord{form, meaning},
#define JAYWALK_ACTION(id, ...)
inline constexpr std::array kMotorwayPercepts{
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

#define JAYWALK_PERCEPT(id, form, meaning)
#define JAYWALK_ACTION(id, ...) EnvironmentWord{__VA_ARGS__},
inline constexpr std::array kMotorwayActions{
#include "env/motorway/words.def"
};
#undef JAYWALK_PERCEPT
#undef JAYWALK_ACTION

/// The words interned in one symbol table; made once, before the table is shared.
class MotorwayVocabulary {
 public:
  explicit MotorwayVocabulary(SymbolTable& symbols);

  [[nodiscard]] Predicate percept(MotorwayPercept percept) const {
    return percepts_[static_cast<std::size_t>(percept)];
  }
  [[nodiscard]] Predicate action(MotorwayAction action) const {
    return actions_[static_cast<std::size_t>(action)];
  }
  [[nodiscard]] Value left() const { return left_; }
  [[nodiscard]] Value right() const { return right_; }

 private:
  std::array<Predicate, kMotorwayPercepts.size()> percepts_{};
  std::array<Predicate, kMotorwayActions.size()> actions_{};
  Value left_;
  Value right_;
};

/// The world's name.
inline constexpr std::string_view kMotorway = "motorway";

/// A vehicle that an agent drives.
struct MotorwayVehicle {
  /// Its middle from the left, its front along the road.
  double x_m = 0;
  double front_m = 0;
  double speed_mps = 0;
  double acceleration_mps2 = 0;
  /// The lane that it keeps or is on its way to.
  int lane = 1;
  bool changing = false;
  /// It has touched another agent's vehicle.
  bool crashed = false;
  /// Its agent's last action could not be done.
  bool failed = false;
};

class Motorway final : public World {
 public:
  /// One agent for each vehicle. REQUIRES: parameters without problems(); they and the vocabulary
  /// outlive the world.
  Motorway(const MotorwayParameters& parameters, const MotorwayVocabulary& vocabulary,
           std::vector<MotorwayVehicle> vehicles);

  void perceive(AgentId agent, Percepts& percepts) const override;
  void constants(Percepts& percepts) const override;
  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override;
  void advance() override;
  [[nodiscard]] bool finished() const override { return !result_.end.empty(); }

  [[nodiscard]] std::string_view kind() const override { return kMotorway; }
  [[nodiscard]] double tick_s() const override { return parameters_.tick_s; }
  [[nodiscard]] int ticks() const override { return ticks_; }
  void begin(DriveBriefing briefing) override;
  void end() override;
  [[nodiscard]] std::vector<std::string> take_notes() override {
    return controller_ ? controller_->take_notes() : std::vector<std::string>();
  }
  [[nodiscard]] std::string failure() const override {
    return controller_ ? controller_->failure() : "";
  }
  /// The AV, named `av`, then v1, v2, … in the agents' order.
  [[nodiscard]] std::vector<Actor> actors() const override;
  [[nodiscard]] Scene scene() const override;
  /// Changes of lanes, as they begin (`lane_change`), and crashes (`crash`).
  [[nodiscard]] std::vector<WorldEvent> events() const override { return events_; }
  [[nodiscard]] const WorldResult& result() const override { return result_; }
  [[nodiscard]] bool last_action_failed(std::size_t agent) const override {
    return agent < vehicles_.size() && vehicles_[agent].failed;
  }

  [[nodiscard]] std::span<const MotorwayVehicle> vehicles() const { return vehicles_; }
  [[nodiscard]] double av_front_m() const { return av_front_m_; }
  [[nodiscard]] double av_speed_mps() const { return av_speed_mps_; }

 private:
  std::string act(const ActionRequest& action, MotorwayVehicle& vehicle);
  std::string change_lane(Value way, MotorwayVehicle& vehicle);
  [[nodiscard]] double decide(double time_s, double period_s);
  void drive(double step_s, double av_acceleration_mps2);
  void drive(double step_s, MotorwayVehicle& vehicle) const;
  void crash();
  void wreck(std::size_t index, std::size_t other);
  void touch();
  void look_for_precondition();
  void settle();
  [[nodiscard]] int lane_of(const MotorwayVehicle& vehicle) const;
  [[nodiscard]] double heading_rad(const MotorwayVehicle& vehicle) const;
  [[nodiscard]] Rectangle box_of(const MotorwayVehicle& vehicle) const;
  [[nodiscard]] Rectangle av_box() const;

  const MotorwayParameters& parameters_;
  const MotorwayVocabulary& vocabulary_;
  std::vector<MotorwayVehicle> vehicles_;
  std::unique_ptr<VehicleController> controller_;
  std::vector<SeenLane> lanes_;
  double av_front_m_;
  double av_speed_mps_;
  int ticks_ = 0;
  bool scored_ = false;  // nothing costs any more
  std::vector<WorldEvent> events_;
  WorldResult result_;
};

}  // namespace jaywalk
