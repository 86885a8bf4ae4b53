// SPDX-License-Identifier: Apache-2.0
#include "env/motorway/world.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "env/vehicle/vehicle_section.h"
#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

/// The gap between two vehicles of a lane at the start.
constexpr double kStartGapM = 10;
constexpr int kDraws = 100;

class PreparedMotorway final : public PreparedWorld {
 public:
  PreparedMotorway(std::shared_ptr<const MotorwaySpec> spec, SymbolTable& symbols)
      : spec_(std::move(spec)), vocabulary_(symbols) {}

  [[nodiscard]] const WorldSpec& spec() const override { return *spec_; }
  [[nodiscard]] std::unique_ptr<World> make(const WorldStart& start) const override {
    return std::make_unique<Motorway>(spec_->parameters(), vocabulary_, spec_->spawn(start));
  }

 private:
  std::shared_ptr<const MotorwaySpec> spec_;
  MotorwayVocabulary vocabulary_;
};

/// From front to front of two vehicles of a lane, of which the AV may be one.
double apart_m(const MotorwayParameters& parameters) {
  return std::max(size_of(ActorKind::vehicle).length_m, parameters.av.length_m) + kStartGapM;
}

/// The fronts of all vehicles that are in a lane already, the AV's too.
std::vector<double> fronts_in(int lane, const MotorwayParameters& parameters,
                              const std::vector<MotorwayVehicle>& vehicles) {
  std::vector<double> fronts;
  if (lane == parameters.av.lane) fronts.push_back(parameters.av.start_m);
  for (const MotorwayVehicle& each : vehicles) {
    if (each.lane == lane) fronts.push_back(each.front_m);
  }
  return fronts;
}

}  // namespace

EnvironmentKind motorway_world() {
  return {.name = kMotorway,
          .summary =
              "a carriageway of several lanes; vehicles that agents drive cut in before an "
              "automated vehicle",
          .percepts = kMotorwayPercepts,
          .actions = kMotorwayActions,
          .presets = {},
          .section = motorway_section};
}

std::vector<MotorwayVehicle> MotorwaySpec::spawn(const WorldStart& start) const {
  const MotorwayParameters& p = parameters_;
  std::vector<int> lanes;
  for (int lane = 1; lane <= p.lanes; ++lane) {
    if (lane != p.av.lane || p.lanes == 1) lanes.push_back(lane);
  }
  SplitMix64 random(start.seed);
  std::vector<MotorwayVehicle> vehicles;
  for (std::uint32_t i = 0; i < start.agents; ++i) {
    MotorwayVehicle vehicle{.speed_mps = p.av.speed_mps};
    bool has_room = false;
    for (int tries = 0; tries < kDraws && !has_room; ++tries) {
      vehicle.lane = lanes[random.below(lanes.size())];
      const double range_m = p.drivers.start_to_m - p.drivers.start_from_m;
      vehicle.front_m = p.av.start_m + p.drivers.start_from_m + random.share() * range_m;
      has_room = std::ranges::none_of(fronts_in(vehicle.lane, p, vehicles), [&](double front_m) {
        return std::fabs(front_m - vehicle.front_m) < apart_m(p);
      });
    }
    if (!has_room) {
      vehicle.front_m = std::ranges::min(fronts_in(vehicle.lane, p, vehicles)) - apart_m(p);
    }
    vehicle.x_m = middle_of_lane(p, vehicle.lane);
    vehicles.push_back(vehicle);
  }
  return vehicles;
}

Ground MotorwaySpec::ground() const {
  Ground ground;
  for (int lane = 1; lane <= parameters_.lanes; ++lane) {
    const double left = (lane - 1) * parameters_.lane_m;
    const double right = lane * parameters_.lane_m;
    const double far = parameters_.length_m;
    ground.areas.push_back({.kind = AreaKind::lane,
                            .corners = {{left, 0}, {right, 0}, {right, far}, {left, far}},
                            .of_av = lane == parameters_.av.lane});
  }
  ground.cruise_mps = parameters_.av.speed_mps;
  ground.moves_evenly = true;
  return ground;
}

GroundPlan MotorwaySpec::plan() const {
  const int cells = static_cast<int>(std::ceil(parameters_.length_m / parameters_.lane_m));
  GroundPlan plan{.grid = {parameters_.lanes, cells}, .cell_m = parameters_.lane_m};
  plan.bands.assign(static_cast<std::size_t>(parameters_.lanes), {AreaKind::lane, 1});
  plan.cells.assign(static_cast<std::size_t>(parameters_.lanes) * static_cast<std::size_t>(cells),
                    Surface::lane);
  return plan;
}

std::string MotorwaySpec::agent_name(std::uint32_t number) const {
  return fmt::format("v{}", number);
}

VehicleParameters MotorwaySpec::healthy_vehicle() const {
  return healthy_twin(parameters_.av.vehicle, parameters_.av.twin);
}

std::shared_ptr<const WorldSpec> MotorwaySpec::with(VehicleParameters vehicle,
                                                    SimulatorParameters) const {
  auto changed = std::make_shared<MotorwaySpec>(*this);
  changed->parameters_.av.vehicle = std::move(vehicle);
  return changed;
}

std::vector<std::string> MotorwaySpec::command() const {
  const MotorwayParameters::AutomatedVehicle& av = parameters_.av;
  return av.vehicle.command.empty() && av.twin ? av.twin->command : av.vehicle.command;
}

bool MotorwaySpec::same_as(const WorldSpec& other) const {
  return other.kind() == kMotorway &&
         static_cast<const MotorwaySpec&>(other).parameters_ == parameters_;
}

std::unique_ptr<const PreparedWorld> MotorwaySpec::prepare(SymbolTable& symbols) const {
  return std::make_unique<PreparedMotorway>(shared_from_this(), symbols);
}

}  // namespace jaywalk
