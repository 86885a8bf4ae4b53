// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interface between a world and the code that runs tests in it. A world defines the percepts
// and actions of agents (Environment), the scene (env/scene.h), the events of a test, its end and
// its score. Tests, stores, metrics, assertions and pages use worlds by this file alone;
// world_spec.h has a scenario's description of a world.
//
// The agents under comparison come first, by their numbers, then a world's other agents. Actors are
// the scene's: the first is the automated vehicle (AV) under test, then the agents in their order,
// then perhaps others without agents.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "env/scene.h"
#include "env/vehicle/vehicle.h"
#include "interpreter/environment/percepts.h"
#include <jaywalk/environment.h>

namespace jaywalk {

/// One compared agent's cost and reward in a test.
struct AgentOutcome {
  double cost = 0;
  double reward = 0;
  /// How many of its actions were carried out.
  std::uint32_t actions = 0;
};

/// The AV's first contact with an agent or actor.
struct Collision {
  /// Index of the agent; the world's other bodies are numbered after the agents. The actor's number
  /// less one.
  std::size_t body = 0;
  int tick = 0;
  double impact_mps = 0;
};

/// The outcome of a test.
struct WorldResult {
  /// The precondition of the assertion under test was met.
  bool success = false;
  /// The ticks that it took, until success or in all.
  int ticks = 0;
  /// The ticks of the whole test, and the reason that ended it, a word of the world's; empty while
  /// it goes on.
  int all_ticks = 0;
  std::string_view end;
  /// One outcome for each compared agent, in their order.
  std::vector<AgentOutcome> agents;
  /// The agents that met the precondition, as indices.
  std::vector<std::size_t> met_by;
  /// The actors that the AV has touched, each once, in the order of time. Assertions judge them.
  std::vector<Collision> collisions;

  /// Rewards less costs, as mean over all agents.
  [[nodiscard]] double score() const;
};

/// Something that happened, for recordings: a signal's new colour, a lane that was changed.
struct WorldEvent {
  int tick = 0;
  /// Index into the actors.
  std::size_t actor = 0;
  std::string kind;
  std::string text;
};

/// The world of one test.
class World : public Environment {
 public:
  /// The name of its row of environments.def.
  [[nodiscard]] virtual std::string_view kind() const = 0;
  [[nodiscard]] virtual double tick_s() const = 0;
  [[nodiscard]] double tick_ms() const final { return tick_s() * 1000; }
  /// Ticks that have passed.
  [[nodiscard]] virtual int ticks() const = 0;
  /// Passes on the caller's share of what the AV's controller or simulator receives before the
  /// test. There may be more actors from then on.
  virtual void begin(DriveBriefing briefing) = 0;
  /// Reports to the AV's controller how the test ended. REQUIRES: it is finished.
  virtual void end() = 0;
  /// Remarks on the test for the author of the AV's controller, each once; usually none.
  [[nodiscard]] virtual std::vector<std::string> take_notes() { return {}; }
  /// Why the test cannot go on (a controller or simulator died, say); empty while all is well.
  [[nodiscard]] virtual std::string failure() const { return {}; }
  /// The same during the whole test, and where they are now.
  [[nodiscard]] virtual std::vector<Actor> actors() const = 0;
  [[nodiscard]] virtual Scene scene() const = 0;
  /// Events that only the world knows of, in the order of time; those in result() are not among
  /// them.
  [[nodiscard]] virtual std::vector<WorldEvent> events() const { return {}; }
  /// The test's result so far; final once it is finished.
  [[nodiscard]] virtual const WorldResult& result() const = 0;
  /// The result in words: `precondition met in tick 5 by v1, score 12.00`.
  [[nodiscard]] virtual std::string describe_result() const;
  /// The agent's last action led nowhere, though no tick follows in which it would hear of that.
  [[nodiscard]] virtual bool last_action_failed(std::size_t /*agent*/) const { return false; }
  /// The next test's head start, in a world whose tests depend on each other.
  [[nodiscard]] virtual int left_over() const { return 0; }
};

}  // namespace jaywalk
