// SPDX-License-Identifier: Apache-2.0
#pragma once

// The Vehicle Behaviour Interface between the controller of an automated vehicle (AV) and the
// world. The world provides the view of the vehicle's sensors, the controller answers with an
// acceleration, and the world moves the vehicle. The vehicle keeps its row: a controller
// accelerates and brakes, it does not steer. Models are the rows of models.def; another one is a
// class in its own file and a row, an external process, or a driver of the program that embeds
// Jaywalk (external.cpp).

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/scene.h"
#include <jaywalk/vehicle.h>

namespace jaywalk {

class ControllerProcesses;
class Simulators;

/// The test that a controller is about to drive in.
struct DriveBriefing {
  std::uint64_t test = 0;
  std::uint64_t seed = 0;
  std::string behaviour;
  std::uint32_t agents = 0;
  double road_m = 0;
  double cruise_mps = 0;
  /// Processes that outlive the test, for an external controller that keeps its; null: there are
  /// none.
  ControllerProcesses* processes = nullptr;
  /// The thread's simulators, for a world whose vehicles a simulator moves.
  Simulators* simulators = nullptr;
};

/// How it ended.
struct DriveEnd {
  /// `precondition`, `collision`, `road_end`, `time_limit`.
  std::string_view why;
  /// Speed of the first collision, in m/s; empty if there was none.
  std::optional<double> impact_mps;
};

/// The controller's decision. The world keeps the speed between 0 and what the limits allow.
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
  /// Seconds from the moment an actor is in the way until it is perceived. A model
  /// brakes then, or later if models.def says so.
  std::optional<double> reaction_s;
  /// The strongest braking and acceleration, both positive, in m/s^2.
  std::optional<double> deceleration_mps2;
  double acceleration_mps2 = 2;
  /// How far the sensors see, in metres ahead of the front.
  double range_m = 100;
  /// The remaining gap to an obstacle when standing, in metres.
  double standoff_m = 2;
  /// Time from one decision to the next; 0: one tick. Models that decide more often do so anyway.
  double period_s = 0;
  /// The program of an external controller with its arguments.
  std::vector<std::string> command;
  /// Its process is used again from test to test.
  bool keeps_process = false;
  /// Drives instead of the model; null: the model does.
  std::shared_ptr<const OwnVehicle> own;
  /// Faults put on the model, the first one next to it. Without any it is the healthy twin.
  std::vector<VehicleDefect> defects;

  friend bool operator==(const VehicleParameters&, const VehicleParameters&) = default;
};

/// Decides anew every period; keeps what it must remember of the test in which it drives.
class VehicleController {
 public:
  virtual ~VehicleController() = default;
  /// Before the first decision of a test, and after its last one.
  virtual void begin(const DriveBriefing& /*briefing*/) {}
  virtual void end(const DriveEnd& /*end*/) {}
  [[nodiscard]] virtual VehicleDecision decide(const VehicleView& view) = 0;
  /// The longest period between two decisions, in seconds, even if the parameters ask for longer
  /// ones.
  [[nodiscard]] virtual double longest_period_s() const {
    return std::numeric_limits<double>::infinity();
  }
  /// Why it can go on no longer (an external process died, say); empty while all is well.
  [[nodiscard]] virtual std::string failure() const { return {}; }
  /// Remarks on the test for its author, each once; usually none.
  [[nodiscard]] virtual std::vector<std::string> take_notes() { return {}; }
};

/// The hardest braking on a dry road; answers of external controllers and drivers are limited to
/// it.
inline constexpr double kHardestBrakingMps2 = kGravityMps2;
inline constexpr double kHardestAccelerationMps2 = 5;

/// In how many equal periods it decides if it is asked no oftener than it needs.
[[nodiscard]] int periods_of(const VehicleController& controller, double seconds);

/// A speed, and the way to get to it.
struct Motion {
  double speed = 0;
  double way = 0;
};
/// The motion in a period in which the speed changes evenly by `change`, kept between 0 and
/// `highest`: a vehicle that stops stands until the period ends. In any consistent units.
[[nodiscard]] Motion drive_on(double speed, double change, double highest, double period);

struct VehicleModel {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<VehicleController> (*make)(const VehicleParameters&);
};

#define JAYWALK_VEHICLE_MODEL(name, function, summary) \
  [[nodiscard]] std::unique_ptr<VehicleController> function(const VehicleParameters& parameters);
#include "env/vehicle/models.def"
#undef JAYWALK_VEHICLE_MODEL

[[nodiscard]] std::span<const VehicleModel> vehicle_models();
/// Null if there is none of that name.
[[nodiscard]] const VehicleModel* find_vehicle_model(std::string_view name);

[[nodiscard]] std::unique_ptr<VehicleController> make_own(const OwnVehicle& vehicle);

/// The model, or the driver that replaces it, with its defects on it. Null for the model
/// `constant`, which needs no controller. REQUIRES: the model and the defects exist.
[[nodiscard]] std::unique_ptr<VehicleController> make_controller(
    const VehicleParameters& parameters);

}  // namespace jaywalk
