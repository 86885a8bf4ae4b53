// SPDX-License-Identifier: Apache-2.0
#pragma once

// An automated vehicle (AV) of your own, instead of the scenario's: a class that is given what the
// vehicle's sensors see, once every control period, and answers with an acceleration. It keeps its
// lane: it does not steer. Give it to a scenario by ScenarioChoice::vehicle (scenario.h).

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace jaywalk {

enum class ActorKind { vehicle, pedestrian, cyclist, signal };

/// `vehicle`, `pedestrian`, …: the word that stores and exports use.
[[nodiscard]] std::string_view name(ActorKind kind);

/// A road user in the way, or that could get there, as the sensors see it.
struct SeenActor {
  /// The actor's number in the world, the same in every view.
  std::uint32_t id = 0;
  ActorKind kind = ActorKind::pedestrian;
  /// From the vehicle's front to the near side of the actor's box, along the way; negative beside
  /// the vehicle and behind its front.
  double gap_m = 0;
  /// The sides of the box, as the vehicle's own `left_m` and `right_m`.
  double left_m = 0;
  double right_m = 0;
  /// Along the vehicle's way, and to its right.
  double speed_ahead_mps = 0;
  double speed_right_mps = 0;
  /// The box's length along the way: its far side is at gap_m + length_m.
  double length_m = 0;
  /// Its heading, clockwise from the vehicle's way.
  double heading_rad = 0;
};

/// A lane of the road, by its sides; its traffic goes the vehicle's way or comes towards it.
struct SeenLane {
  double left_m = 0;
  double right_m = 0;
  bool oncoming = false;
};

/// A place where the vehicle has to stop while `closed`: a red signal, or a pedestrian on a zebra.
struct StopLine {
  double gap_m = 0;
  bool closed = false;
};

/// An obstacle to movement and sight: a parked car.
struct SeenObstacle {
  /// From the vehicle's front to its near and its far side.
  double gap_m = 0;
  double far_m = 0;
  /// Its sides, as the vehicle's own.
  double left_m = 0;
  double right_m = 0;
};

/// The controller's input, once every control period.
struct VehicleView {
  double time_s = 0;
  double period_s = 0;
  double speed_mps = 0;
  /// The speed at which it would drive if nothing were in its way.
  double cruise_mps = 0;
  /// The sides of its body and of its lane, counted from the world's left.
  double left_m = 0;
  double right_m = 0;
  double lane_left_m = 0;
  double lane_right_m = 0;
  /// The seen actors in the order of their numbers, without those that are hidden or out of range.
  std::span<const SeenActor> actors;
  std::span<const StopLine> stop_lines;
  /// The map's obstacles, ahead and behind.
  std::span<const SeenObstacle> obstacles{};
  /// From the road's begin to its front, and of its body.
  double front_m = 0;
  double length_m = 0;
  /// How far its sensors see ahead of the front.
  double range_m = 0;
  /// All lanes, its own too; none where the ground is drawn as a map.
  std::span<const SeenLane> lanes{};
};

/// Drives in one test.
class VehicleDriver {
 public:
  virtual ~VehicleDriver() = default;
  /// An acceleration in m/s^2, negative to brake. The world limits it to what a vehicle can do,
  /// -9.80665 to 5, and the speed to 0 and more. The view is good until it returns.
  [[nodiscard]] virtual double decide(const VehicleView& view) = 0;
  /// Why it can go on no longer, which ends the test errored; empty while all is well.
  [[nodiscard]] virtual std::string failure() const { return {}; }
};

/// Makes a driver for each test, on any thread. A test's outcome must not depend on other tests.
struct OwnVehicle {
  std::string name;
  std::function<std::unique_ptr<VehicleDriver>()> make;
};

}  // namespace jaywalk
