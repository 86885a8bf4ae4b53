// SPDX-License-Identifier: Apache-2.0
#pragma once

// The motorway behind the seam of all worlds. Read motorway.h and env/world/world_spec.h first.

#include <memory>
#include <utility>

#include "env/motorway/motorway.h"
#include "env/world/world_section.h"
#include "env/world/world_spec.h"

namespace jaywalk {

class MotorwaySpec final : public WorldSpec, public std::enable_shared_from_this<MotorwaySpec> {
 public:
  /// REQUIRES: parameters without problems().
  explicit MotorwaySpec(MotorwayParameters parameters) : parameters_(std::move(parameters)) {}

  [[nodiscard]] const MotorwayParameters& parameters() const { return parameters_; }
  /// Where the agents' vehicles begin: in another lane than the AV's where there is one, at a place
  /// drawn evenly; behind all others of the lane where there is no room between them.
  [[nodiscard]] std::vector<MotorwayVehicle> spawn(const WorldStart& start) const;

  [[nodiscard]] std::string_view kind() const override { return kMotorway; }
  [[nodiscard]] double tick_s() const override { return parameters_.tick_s; }
  [[nodiscard]] Ground ground() const override;
  [[nodiscard]] GroundPlan plan() const override;
  [[nodiscard]] std::string agent_name(std::uint32_t number) const override;
  [[nodiscard]] const VehicleParameters& vehicle() const override { return parameters_.av.vehicle; }
  [[nodiscard]] VehicleParameters healthy_vehicle() const override;
  [[nodiscard]] std::shared_ptr<const WorldSpec> with(VehicleParameters vehicle,
                                                      SimulatorParameters simulator) const override;
  [[nodiscard]] std::vector<std::string> command() const override;
  [[nodiscard]] bool same_as(const WorldSpec& other) const override;
  [[nodiscard]] std::unique_ptr<const PreparedWorld> prepare(SymbolTable& symbols) const override;

 private:
  MotorwayParameters parameters_;
};

[[nodiscard]] std::unique_ptr<WorldSection> motorway_section();

}  // namespace jaywalk
