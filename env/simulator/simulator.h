// SPDX-License-Identifier: Apache-2.0
#pragma once

// The simulator seam: what stands between a world and a simulator that moves the automated vehicle
// (AV) and other traffic in it. Agents, percepts, preconditions, scores, collisions and recordings
// stay the world's; the simulator receives where the bodies go and answers where its vehicles are.
// Everything is in metres, seconds and radians on the plane of env/scene.h: y runs along the road
// the way the AV drives, x to its right, headings are counted counter-clockwise from x. Simulators
// are the rows of simulators.def; another one is a class in a folder beside this file and a row.
//
// A simulator belongs to one thread and simulates many tests, one after another: begin, advance
// for each tick, end. Each test has to come out as if it were the only one. Nothing is thrown: an
// error is a text for people, the test ends errored with it, and the next begin starts afresh.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/ground.h"
#include "env/scene.h"
#include "env/simulator/parameters.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// A strip of the road, over its whole length.
struct RoadBand {
  AreaKind kind = AreaKind::pavement;
  double left_m = 0;
  double right_m = 0;
  /// Whether the lane's traffic comes towards the AV; unused for pavements.
  bool oncoming = false;
};

struct SimulatedRoad {
  /// It lies from y = 0 to here; the AV may begin before it and drive on beyond.
  double length_m = 0;
  /// From left to right; none where the ground is drawn as a map.
  std::vector<RoadBand> bands;
  Ground ground;
};

/// Where the tests of a scenario take place, and the AV as it begins there, with the speed that it
/// would keep if nothing were in its way.
struct SimulatedSite {
  SimulatedRoad road;
  Actor av;
  ActorState av_start;
  VehicleParameters vehicle;
  double tick_s = 1;
};

/// An actor that the world moves, as it goes from the begin of a tick to its end.
struct SimulatedBody {
  /// Index into the actors of the test.
  std::size_t actor = 0;
  ActorState before;
  ActorState after;
};

/// The colour that a signal of the world shows to vehicles: `green`, `amber` or `red`.
struct ShownSignal {
  /// Index into the crosswalks of the ground.
  std::size_t crosswalk = 0;
  std::string_view colour;
};

/// The test that is about to begin. What it refers to lives as long as the test.
struct SimulatedTest {
  std::uint64_t test = 0;
  /// The experiment's. What a simulator draws derives from it and the test's number.
  std::uint64_t seed = 0;
  std::string behaviour;
  std::uint32_t agents = 0;
  double tick_s = 1;
  const SimulatedRoad& road;
  /// The AV's body, where it begins, and the speed that it would keep if nothing were in its way.
  Actor av;
  ActorState av_start;
  double cruise_mps = 0;
  /// Limits and habits of the AV as the scenario gives them under `world.av`.
  const VehicleParameters& vehicle;
  /// The actors that the world moves: the pedestrians, then others, perhaps vehicles and signals;
  /// and where they begin.
  std::span<const Actor> actors;
  std::span<const ActorState> starts;
};

/// A vehicle of the simulator at one moment.
struct SimulatedVehicle {
  ActorState state;
  double acceleration_mps2 = 0;
  /// Whether it is in the simulation; if not (yet, or no longer), the state has no meaning.
  bool present = true;
};

/// The state of the simulator's vehicles at one moment.
struct SimulatedScene {
  /// Since the test began.
  double time_s = 0;
  SimulatedVehicle av;
  /// In the order of SimulatedStart::traffic.
  std::vector<SimulatedVehicle> traffic;
  /// Indices of the actors that the AV touches; nothing if the simulator does not report contacts
  /// and the world has to find them from the boxes.
  std::optional<std::vector<std::size_t>> contacts;
};

/// The simulator's own traffic, which stays the same during the test, and the scene at time 0, in
/// which the AV is where the test says.
struct SimulatedStart {
  std::vector<Actor> traffic;
  SimulatedScene scene;
};

/// One tick of the world.
struct SimulatedTick {
  /// From 1.
  std::uint64_t tick = 1;
  double begin_s = 0;
  double length_s = 1;
  /// A body for each actor of the test, in their order. Within the tick they move evenly (body_at).
  std::span<const SimulatedBody> bodies;
  std::span<const ShownSignal> signals;
};

/// A simulator's name and version, as stores and reports show them.
struct SimulatorIdentity {
  std::string name;
  std::string version;
  /// The network that it simulates on: a file's path, or how it was made; empty if it has none.
  std::string network;
  /// Whether a test has the same result whatever was simulated before it.
  bool deterministic = true;
};

class Simulator {
 public:
  virtual ~Simulator() = default;

  /// Fills in the identity, and starts the simulator first if needed. Returns why that failed;
  /// empty if it did not.
  [[nodiscard]] virtual std::string identify(SimulatorIdentity& identity) = 0;
  /// Errors of the scenario that show once the simulator runs, before any test; usually none.
  [[nodiscard]] virtual std::vector<SettingProblem> survey(const SimulatedSite& /*site*/) {
    return {};
  }
  /// A test begins; one that has not ended is given up.
  [[nodiscard]] virtual std::string begin(const SimulatedTest& test, SimulatedStart& start) = 0;
  /// Simulates a tick: its scenes at equal distances in time, the last one at the end of the tick.
  [[nodiscard]] virtual std::string advance(const SimulatedTick& tick,
                                            std::vector<SimulatedScene>& scenes) = 0;
  /// Ends the test. Returns an error that shows only then; empty if there is none.
  [[nodiscard]] virtual std::string end(const DriveEnd& /*end*/) { return {}; }
  /// Remarks on the test for the scenario's author, each once; usually none.
  [[nodiscard]] virtual std::vector<std::string> take_notes() { return {}; }
};

/// Where a body is after this share of the tick, from 0 to 1.
[[nodiscard]] ActorState body_at(const SimulatedBody& body, double share);

/// In how many steps of about that length a tick is simulated; at least one.
[[nodiscard]] int steps_of(double tick_s, double step_s);

/// A row of simulators.def.
struct SimulatorKind {
  std::string_view name;
  std::string_view summary;
  /// The keys of the scenario's `world.simulator`, besides `name` and `step`.
  std::span<const SettingKey> keys;
  /// Settings that contradict each other, and parts of the site that it cannot simulate; usually
  /// none. The site is null if it has errors itself.
  std::vector<SettingProblem> (*check)(const SimulatorParameters&, const SimulatedSite*);
  std::unique_ptr<Simulator> (*make)(const SimulatorParameters&);
};

[[nodiscard]] std::span<const SimulatorKind> simulator_kinds();
/// Null if there is none of that name.
[[nodiscard]] const SimulatorKind* find_simulator(std::string_view name);

/// The simulator of one thread, which is kept from test to test.
class Simulators {
 public:
  /// The one with these parameters, made when it is first asked for; one with others is ended,
  /// since tests of one vehicle come one after another. REQUIRES: the kind exists.
  [[nodiscard]] Simulator& of(const SimulatorParameters& parameters);

 private:
  SimulatorParameters parameters_;
  std::unique_ptr<Simulator> kept_;
};

[[nodiscard]] std::span<const SettingKey> process_keys();
[[nodiscard]] std::vector<SettingProblem> check_process(const SimulatorParameters& parameters,
                                                        const SimulatedSite* site);
[[nodiscard]] std::unique_ptr<Simulator> make_process(const SimulatorParameters& parameters);

[[nodiscard]] std::span<const SettingKey> sumo_keys();
[[nodiscard]] std::vector<SettingProblem> check_sumo(const SimulatorParameters& parameters,
                                                     const SimulatedSite* site);
[[nodiscard]] std::unique_ptr<Simulator> make_sumo(const SimulatorParameters& parameters);

}  // namespace jaywalk
