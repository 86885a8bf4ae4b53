// SPDX-License-Identifier: Apache-2.0
#pragma once

// The world as the interpreter sees it. An environment is asked what each agent perceives, is given
// all the actions chosen in one tick at once, and then moves on by itself (run.h has the order):
//
//   class Room : public jaywalk::Environment { ... };
//   jaywalk::Interpreter interpreter({}, [](jaywalk::SymbolTable& symbols) {
//     return std::make_unique<Room>(symbols);
//   });
//
// An environment enters the names of its percepts and actions into the table when it is made
// (predicate_named of value.h), and compares numbers from then on.

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

#include <jaywalk/value.h>

namespace jaywalk {

class Percepts;

/// Adds a percept to those of the agent that is asked about. Arguments are numbers and atoms; there
/// are no annotations. REQUIRES: as many arguments as the predicate has.
void add_percept(Percepts& percepts, Predicate predicate, std::initializer_list<Value> args);
void add_percept(Percepts& percepts, Predicate predicate, std::span<const Value> args);

/// The number of an agent in its multi-agent system, from 0 in the order of creation.
enum class AgentId : std::uint32_t {};

/// An action that an agent has chosen. Arguments are valid during `execute` only.
struct ActionRequest {
  AgentId agent{};
  Predicate predicate{};
  std::span<const Value> args;
};

/// Its outcome. A failed action fails the plan that asked for it (`error(action_failed)`);
/// `reason` becomes the text of the failure's `error_msg`.
struct ActionResult {
  bool succeeded = true;
  std::string reason;
};

class Environment {
 public:
  virtual ~Environment() = default;

  /// Adds all that `agent` perceives now, best in the same order every time, what comes and goes
  /// last. Agents perceive one after another, the world between two ticks being the same for all.
  virtual void perceive(AgentId agent, Percepts& percepts) const = 0;
  /// Adds the percepts that every agent has in every look of the run, all agents the same, which
  /// `perceive` adds as well. Agents share them, and rules that ask nothing else are asked once for
  /// all agents. A predicate that has such a percept has no others.
  virtual void constants(Percepts& /*percepts*/) const {}
  /// The actions of one tick, at most one for each agent, in the agents' order. All take effect at
  /// once. `results` has the same length, prefilled with success.
  virtual void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) = 0;
  /// Everything in the world that is not an agent moves on by one tick.
  virtual void advance() = 0;
  /// Nothing more can happen that matters; the run ends.
  [[nodiscard]] virtual bool finished() const = 0;
  /// The length of a tick in milliseconds of virtual time; greater than 0.
  [[nodiscard]] virtual double tick_ms() const = 0;
};

}  // namespace jaywalk
