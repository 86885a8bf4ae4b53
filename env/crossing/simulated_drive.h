// SPDX-License-Identifier: Apache-2.0
#pragma once

// The crossing's side of a simulator (env/simulator/simulator.h): it reports to the simulator where
// the world's bodies go, checks its answers and finds the bodies that the automated vehicle (AV)
// touches. Without a simulator a body is at its new place during the whole tick; here it goes there
// evenly.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "env/crossing/road_user.h"
#include "env/simulator/simulator.h"

namespace jaywalk {

struct Collision;

/// The site that the simulator checks before any test. REQUIRES: parameters without problems().
[[nodiscard]] SimulatedSite simulated_site(const CrossingParameters& parameters);

class SimulatedDrive {
 public:
  /// The parameters must outlive it.
  explicit SimulatedDrive(const CrossingParameters& parameters);

  /// REQUIRES: the first of the actors is the AV; the briefing has simulators.
  void begin(const DriveBriefing& briefing, std::vector<Actor> actors, Scene starts);
  /// As Av::drive. The first of the bodies are the actors of `begin` after the AV, in their order.
  std::vector<Collision> drive(int tick, std::span<const RoadUser> bodies,
                               std::span<const SignalColour> signals,
                               std::span<const Collision> hit);
  void end(const DriveEnd& end);

  [[nodiscard]] const SimulatedVehicle& av() const { return now_.av; }
  /// The simulator's own vehicles; they do not change during the test.
  [[nodiscard]] std::span<const Actor> traffic() const { return traffic_; }
  /// The state of one of them. One that is not in the simulation is put out of the AV's sight.
  [[nodiscard]] ActorState traffic_state(std::size_t index) const;
  [[nodiscard]] bool is_present(std::size_t index) const { return now_.traffic[index].present; }
  [[nodiscard]] const std::string& failure() const { return failure_; }
  [[nodiscard]] std::vector<std::string> take_notes() {
    return simulator_ ? simulator_->take_notes() : std::vector<std::string>();
  }

 private:
  void fail(std::string_view why);
  [[nodiscard]] std::string wrong_start(const SimulatedStart& start) const;
  [[nodiscard]] std::string wrong(const SimulatedScene& scene) const;
  [[nodiscard]] std::string wrong(const std::vector<SimulatedScene>& scenes,
                                  const SimulatedTick& tick) const;
  [[nodiscard]] std::vector<SimulatedBody> bodies_in(int tick,
                                                     std::span<const RoadUser> bodies) const;
  [[nodiscard]] std::vector<ShownSignal> shown(std::span<const SignalColour> signals) const;
  /// Whether the AV touches the body number `body` between the scene before and `scene`.
  [[nodiscard]] bool touches(const SimulatedScene& scene, std::size_t body,
                             const std::vector<SimulatedBody>& bodies, double share) const;

  const CrossingParameters& parameters_;
  SimulatedRoad road_;
  Simulator* simulator_ = nullptr;
  Actor body_;                 // the AV's
  std::vector<Actor> actors_;  // the world's, without the AV
  Scene starts_;
  std::vector<Actor> traffic_;
  SimulatedScene now_;
  std::string failure_;
};

}  // namespace jaywalk
