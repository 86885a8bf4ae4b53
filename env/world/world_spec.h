// SPDX-License-Identifier: Apache-2.0
#pragma once

// A world as a scenario describes it, the same for all tests. The world's own WorldSection reads it
// layer by layer (world_section.h); then it is immutable. Bound to the symbols of a scenario's
// programs it makes the worlds of single tests. Read world.h first.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/grid/grid.h"
#include "env/ground.h"
#include "env/simulator/parameters.h"
#include "env/vehicle/vehicle.h"
#include "env/world/world.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

struct SimulatedSite;

/// The inputs of a world for one test.
struct WorldStart {
  /// How many agents are compared, without the world's others.
  std::uint32_t agents = 1;
  /// The test's number, and the seed for where agents start, which is the same for all behaviours.
  std::uint64_t test = 0;
  std::uint64_t seed = 0;
  /// World::left_over of the test before.
  int head_start = 0;
  /// The cells where the agents start, of a world that has cells; empty: the world says.
  std::vector<Position> cells = {};
};

class WorldSpec;

/// A world whose words are symbols; shared by tests on all threads.
class PreparedWorld {
 public:
  virtual ~PreparedWorld() = default;
  [[nodiscard]] virtual const WorldSpec& spec() const = 0;
  /// REQUIRES: there is no problem (WorldSpec::problem). What is made must not outlive this.
  [[nodiscard]] virtual std::unique_ptr<World> make(const WorldStart& start) const = 0;
};

class WorldSpec {
 public:
  virtual ~WorldSpec() = default;
  /// The name of its row of environments.def.
  [[nodiscard]] virtual std::string_view kind() const = 0;
  [[nodiscard]] virtual double tick_s() const = 0;
  [[nodiscard]] virtual Ground ground() const = 0;
  /// The ground that pictures show.
  [[nodiscard]] virtual GroundPlan plan() const = 0;
  /// The name of a compared agent, by number, from 1.
  [[nodiscard]] virtual std::string agent_name(std::uint32_t number) const;

  /// How the AV is driven, and how it would be if it were healthy (VehicleDefect).
  [[nodiscard]] virtual const VehicleParameters& vehicle() const = 0;
  [[nodiscard]] virtual VehicleParameters healthy_vehicle() const = 0;
  /// The simulator that moves the vehicles; its name is empty if the world moves them itself.
  [[nodiscard]] virtual const SimulatorParameters& simulator() const;
  /// Where simulated tests take place; nothing of a world that no simulator can take part in.
  [[nodiscard]] virtual std::optional<SimulatedSite> site() const;
  /// The same world with another AV.
  [[nodiscard]] virtual std::shared_ptr<const WorldSpec> with(
      VehicleParameters vehicle, SimulatorParameters simulator) const = 0;
  /// The words of the program that tests start; none if they start none.
  [[nodiscard]] virtual std::vector<std::string> command() const;

  /// Whether every test has the same outcome in both worlds.
  [[nodiscard]] virtual bool same_as(const WorldSpec& other) const = 0;
  /// Whether each test starts from the head start that the one before it left over, so that tests
  /// must run in order.
  [[nodiscard]] virtual bool carries_over() const { return false; }
  /// The row's percepts that agents do not have in this world, as indices.
  [[nodiscard]] virtual std::vector<std::size_t> absent_percepts() const { return {}; }

  /// The cells where agents start; none of a world without cells, or where there are too few.
  [[nodiscard]] virtual std::vector<Position> start_cells(const WorldStart& /*start*/) const {
    return {};
  }
  /// Whether the scenario gives the start cells, rather than having them drawn.
  [[nodiscard]] virtual bool has_given_starts() const { return false; }
  /// Why a test cannot begin so; empty if it can.
  [[nodiscard]] virtual std::string problem(const WorldStart& /*start*/) const { return {}; }

  /// Ready for tests; `symbols` is not shared yet. REQUIRES: this is owned by a shared pointer.
  [[nodiscard]] virtual std::unique_ptr<const PreparedWorld> prepare(
      SymbolTable& symbols) const = 0;
};

}  // namespace jaywalk
