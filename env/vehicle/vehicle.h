#pragma once

// The Vehicle Behaviour Interface: what stands between the controller of an automated vehicle (AV)
// and the world. The world gives out what the vehicle's sensors see, the controller answers with an
// acceleration; the world moves the vehicle. The vehicle keeps its row: a controller accelerates
// and brakes, it does not steer. Models are the rows of models.def; another one is a class in a
// file of its own and a row, or an external process (external.h).

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/scene.h"

namespace jaywalk {

/// Somebody in the way, or who could come there, as the sensors see them.
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
};

/// A place where the vehicle has to stop while `closed`: a red signal, or somebody on a zebra.
struct StopLine {
  double gap_m = 0;
  bool closed = false;
};

/// Something that nobody can be where it is or look through: a parked car.
struct SeenObstacle {
  /// From the vehicle's front to its near and its far side.
  double gap_m = 0;
  double far_m = 0;
  /// Its sides, as the vehicle's own.
  double left_m = 0;
  double right_m = 0;
};

/// What the controller is told, once every control period.
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
  /// In the order of their numbers; what is hidden or out of range is not among them.
  std::span<const SeenActor> actors;
  std::span<const StopLine> stop_lines;
  /// What the map has of them, ahead and behind.
  std::span<const SeenObstacle> obstacles{};
};

/// What the controller decides. The world keeps the speed between 0 and what the limits allow.
struct VehicleDecision {
  double acceleration_mps2 = 0;
};

/// A fault put on a controller: the name of a row of defects.def, and how severe it is, in the
/// row's unit. Read defects.h after this file.
struct VehicleDefect {
  std::string name;
  double severity = 1;

  friend bool operator==(const VehicleDefect&, const VehicleDefect&) = default;
};

/// Limits and habits; a model uses those that it names in models.def.
struct VehicleParameters {
  /// A row of models.def.
  std::string model = "constant";
  /// Seconds from the moment at which somebody is in the way until that is perceived. A model
  /// brakes then, or later if models.def says so.
  std::optional<double> reaction_s;
  /// The strongest braking and acceleration, both positive, in m/s^2.
  std::optional<double> deceleration_mps2;
  double acceleration_mps2 = 2;
  /// How far the sensors see, in metres ahead of the front.
  double range_m = 100;
  /// What is left to an obstacle when standing, in metres.
  double standoff_m = 2;
  /// Time from one decision to the next; 0: one tick. Models that decide more often do so anyway.
  double period_s = 0;
  /// The program of an external controller with its arguments.
  std::vector<std::string> command;
  /// Faults put on the model, the first one next to it. Without any it is the healthy twin.
  std::vector<VehicleDefect> defects;

  friend bool operator==(const VehicleParameters&, const VehicleParameters&) = default;
};

/// Decides anew every period; keeps what it must remember of the test in which it drives.
class VehicleController {
 public:
  virtual ~VehicleController() = default;
  [[nodiscard]] virtual VehicleDecision decide(const VehicleView& view) = 0;
  /// It is to be asked at least so often, even if the parameters say less often.
  [[nodiscard]] virtual double longest_period_s() const {
    return std::numeric_limits<double>::infinity();
  }
  /// Why it can go on no longer (an external process died, say); empty while all is well.
  [[nodiscard]] virtual std::string failure() const { return {}; }
};

/// In how many equal periods it decides if it is asked no oftener than it needs.
[[nodiscard]] int periods_of(const VehicleController& controller, double seconds);

/// A speed, and the way to get to it.
struct Motion {
  double speed = 0;
  double way = 0;
};
/// After a period in which the speed changes evenly by `change`, kept between 0 and `highest`:
/// whoever comes to a stand stays there until the period ends. In any units that fit together.
[[nodiscard]] Motion drive_on(double speed, double change, double highest, double period);

struct VehicleModel {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<VehicleController> (*make)(const VehicleParameters&);
};

[[nodiscard]] std::span<const VehicleModel> vehicle_models();
/// Null if there is none of that name.
[[nodiscard]] const VehicleModel* find_vehicle_model(std::string_view name);

/// The model with its defects on it. Null for the model `constant`, which needs no controller.
/// REQUIRES: the model and the defects exist.
[[nodiscard]] std::unique_ptr<VehicleController> make_controller(
    const VehicleParameters& parameters);

}  // namespace jaywalk
