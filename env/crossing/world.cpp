// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/world.h"

#include <cassert>

#include <fmt/format.h>

#include "env/crossing/layout.h"
#include "env/crossing/section/crossing_section.h"
#include "env/crossing/spawn.h"
#include "env/crossing/vocabulary.h"
#include "env/environments.h"
#include "env/vehicle/vehicle_section.h"

namespace jaywalk {
namespace {

class PreparedCrossing final : public PreparedWorld {
 public:
  PreparedCrossing(std::shared_ptr<const CrossingSpec> spec, SymbolTable& symbols)
      : spec_(std::move(spec)), vocabulary_(symbols) {}

  [[nodiscard]] const WorldSpec& spec() const override { return *spec_; }
  [[nodiscard]] std::unique_ptr<World> make(const WorldStart& start) const override {
    return std::make_unique<Crossing>(spec_->parameters(), vocabulary_, spec_->start_cells(start),
                                      start.head_start);
  }

 private:
  std::shared_ptr<const CrossingSpec> spec_;
  CrossingVocabulary vocabulary_;
};

}  // namespace

EnvironmentKind crossing_world() {
  return {.name = kCrossing,
          .summary = "a straight road with pavements; pedestrians exercise an automated vehicle",
          .percepts = kCrossingPercepts,
          .actions = kCrossingActions,
          .presets = crossing_presets(),
          .section = crossing_section};
}

std::optional<SimulatedSite> CrossingSpec::site() const { return simulated_site(parameters_); }

Ground CrossingSpec::ground() const { return jaywalk::ground(parameters_); }

GroundPlan CrossingSpec::plan() const {
  const Layout layout(parameters_);
  GroundPlan plan{.grid = layout.grid(),
                  .cell_m = parameters_.cell_m,
                  .bands = {},
                  .is_drawn = !parameters_.map.empty(),
                  .cells = {}};
  for (const Band& band : parameters_.bands) {
    const bool lane = band.kind == BandKind::lane;
    plan.bands.push_back({lane ? AreaKind::lane : AreaKind::pavement, band.rows, band.direction});
  }
  for (int row = 0; row < plan.grid.rows; ++row) {
    for (int y = 0; y < plan.grid.cells; ++y) plan.cells.push_back(layout.at({row, y}));
  }
  return plan;
}

VehicleParameters CrossingSpec::healthy_vehicle() const {
  return healthy_twin(parameters_.av.vehicle, parameters_.av.twin);
}

std::shared_ptr<const WorldSpec> CrossingSpec::with(VehicleParameters vehicle,
                                                    SimulatorParameters simulator) const {
  auto changed = std::make_shared<CrossingSpec>(*this);
  changed->parameters_.av.vehicle = std::move(vehicle);
  changed->parameters_.simulator = std::move(simulator);
  return changed;
}

std::vector<std::string> CrossingSpec::command() const {
  const AvParameters& av = parameters_.av;
  if (!av.vehicle.command.empty()) return av.vehicle.command;
  if (av.twin && !av.twin->command.empty()) return av.twin->command;
  for (const auto& [key, value] : parameters_.simulator.settings) {
    // A file that a setting names is a word, too, but is not started.
    if (value.text.empty() && !value.command.empty()) return value.command;
  }
  return {};
}

bool CrossingSpec::same_as(const WorldSpec& other) const {
  const CrossingSpec* const crossing = find_crossing(other);
  return crossing != nullptr && crossing->parameters_ == parameters_;
}

std::vector<std::size_t> CrossingSpec::absent_percepts() const {
  const auto given = given_percepts(parameters_);
  std::vector<std::size_t> absent;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) absent.push_back(i);
  }
  return absent;
}

std::vector<Position> CrossingSpec::start_cells(const WorldStart& start) const {
  if (!start.cells.empty()) return start.cells;
  if (start_cells_ == nullptr) return spawn(parameters_, start.agents, start.seed);
  const auto test = start_cells_->find(start.test);
  if (test == start_cells_->end() || test->second.size() < start.agents) return {};
  return {test->second.begin(), test->second.begin() + start.agents};
}

std::string CrossingSpec::problem(const WorldStart& start) const {
  if (!start_cells(start).empty()) return {};
  return fmt::format("test {} has fewer than {} start cells in the scenario's file", start.test,
                     start.agents);
}

std::unique_ptr<const PreparedWorld> CrossingSpec::prepare(SymbolTable& symbols) const {
  return std::make_unique<PreparedCrossing>(shared_from_this(), symbols);
}

const CrossingParameters& crossing_parameters(const WorldSpec& world) {
  const CrossingSpec* const crossing = find_crossing(world);
  assert(crossing != nullptr && "the caller knows which world it is");
  return crossing->parameters();
}

const CrossingSpec* find_crossing(const WorldSpec& world) {
  return world.kind() == kCrossing ? static_cast<const CrossingSpec*>(&world) : nullptr;
}

const Crossing* find_crossing(const World& world) {
  return world.kind() == kCrossing ? static_cast<const Crossing*>(&world) : nullptr;
}

}  // namespace jaywalk
