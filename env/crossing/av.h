// SPDX-License-Identifier: Apache-2.0
#pragma once

// The automated vehicle (AV) of a crossing world: how far it has come, how fast it is, what its
// sensors see and whom it hits. Its controller decides (env/vehicle/vehicle.h), this file moves it;
// or a simulator does both (simulated_drive.h).

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "env/crossing/road_user.h"
#include "env/crossing/simulated_drive.h"
#include "env/vehicle/sight.h"
#include "env/vehicle/vehicle.h"
#include "env/world/world.h"

namespace jaywalk {

class Av {
 public:
  /// Begins `head_start` cells ahead of the parameters' start. The parameters must outlive it.
  explicit Av(const CrossingParameters& parameters, int head_start = 0);

  /// Cells that it is ahead of the parameters' start.
  [[nodiscard]] double driven() const { return driven_; }
  /// Cells per tick, now.
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] double speed_mps() const { return speed_ * cell_mps_; }
  /// Metres along the road of its leading edge.
  [[nodiscard]] double front_m() const;

  /// Drives for tick number `tick`, whose moves the bodies have made already. Bodies in `hit` have
  /// been touched before; the collisions are returned, nearest first.
  std::vector<Collision> drive(int tick, std::span<const RoadUser> bodies,
                               std::span<const SignalColour> signals, const Layout& layout,
                               std::span<const Collision> hit);

  /// `actors` and `scene` are the world's, the AV is the first of them.
  void begin(DriveBriefing briefing, const std::vector<Actor>& actors, const Scene& scene);
  void end(const DriveEnd& end);
  [[nodiscard]] std::vector<std::string> take_notes();
  /// Why its controller or simulator failed; empty while it works.
  [[nodiscard]] std::string failure() const;

  [[nodiscard]] Actor actor() const;
  /// Where it is now.
  [[nodiscard]] ActorState state() const;
  /// The simulator that moves it and other traffic; null if a controller drives it.
  [[nodiscard]] const SimulatedDrive* simulated() const { return simulated_.get(); }

 private:
  struct Surroundings;

  void follow_simulator();
  [[nodiscard]] double decide(double time_s, double period_s, const Surroundings& around);
  /// How many decisions there are in a tick.
  [[nodiscard]] int periods() const;
  [[nodiscard]] std::vector<SeenActor> look(const Surroundings& around) const;
  [[nodiscard]] std::vector<StopLine> stop_lines(const Surroundings& around) const;
  [[nodiscard]] std::vector<SeenObstacle> seen_obstacles() const;

  const CrossingParameters& parameters_;
  std::unique_ptr<VehicleController> controller_;
  std::unique_ptr<SimulatedDrive> simulated_;
  std::vector<Rectangle> obstacles_;
  std::vector<SeenLane> lanes_;
  double cell_mps_;  // the metres per second of one cell per tick
  double driven_;
  double speed_;
  bool begun_ = false;  // the simulator knows where it is
};

}  // namespace jaywalk
