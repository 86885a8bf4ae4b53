// SPDX-License-Identifier: Apache-2.0
#pragma once

// The crossing behind the seam of all worlds. Read crossing.h and env/world/world_spec.h first.

#include <memory>
#include <utility>

#include "env/crossing/crossing.h"
#include "env/crossing/parameters.h"
#include "env/grid/start_cells.h"
#include "env/world/world_spec.h"

namespace jaywalk {

class CrossingSpec final : public WorldSpec, public std::enable_shared_from_this<CrossingSpec> {
 public:
  /// REQUIRES: parameters without problems().
  explicit CrossingSpec(CrossingParameters parameters,
                        std::shared_ptr<const StartCells> start_cells = nullptr)
      : parameters_(std::move(parameters)), start_cells_(std::move(start_cells)) {}

  [[nodiscard]] const CrossingParameters& parameters() const { return parameters_; }
  /// The start cells of the scenario's file; null if start cells are drawn.
  [[nodiscard]] const StartCells* given_starts() const { return start_cells_.get(); }

  [[nodiscard]] std::string_view kind() const override { return kCrossing; }
  [[nodiscard]] double tick_s() const override { return parameters_.tick_s; }
  [[nodiscard]] Ground ground() const override;
  [[nodiscard]] GroundPlan plan() const override;
  [[nodiscard]] const VehicleParameters& vehicle() const override { return parameters_.av.vehicle; }
  [[nodiscard]] VehicleParameters healthy_vehicle() const override;
  [[nodiscard]] const SimulatorParameters& simulator() const override {
    return parameters_.simulator;
  }
  [[nodiscard]] std::optional<SimulatedSite> site() const override;
  [[nodiscard]] std::shared_ptr<const WorldSpec> with(VehicleParameters vehicle,
                                                      SimulatorParameters simulator) const override;
  [[nodiscard]] std::vector<std::string> command() const override;
  [[nodiscard]] bool same_as(const WorldSpec& other) const override;
  [[nodiscard]] bool carries_over() const override { return parameters_.av.carry_over; }
  [[nodiscard]] std::vector<std::size_t> absent_percepts() const override;
  /// The scenario's own, or those that are drawn (spawn.h).
  [[nodiscard]] std::vector<Position> start_cells(const WorldStart& start) const override;
  [[nodiscard]] bool has_given_starts() const override { return start_cells_ != nullptr; }
  [[nodiscard]] std::string problem(const WorldStart& start) const override;
  [[nodiscard]] std::unique_ptr<const PreparedWorld> prepare(SymbolTable& symbols) const override;

 private:
  CrossingParameters parameters_;
  std::shared_ptr<const StartCells> start_cells_;
};

/// REQUIRES: the world is a crossing.
[[nodiscard]] const CrossingParameters& crossing_parameters(const WorldSpec& world);
/// The crossing's own specification or world; null for other worlds.
[[nodiscard]] const CrossingSpec* find_crossing(const WorldSpec& world);
[[nodiscard]] const Crossing* find_crossing(const World& world);

}  // namespace jaywalk
