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
// (predicate_named of value.h), and compares numbers from then on. Names that it meets later go
// into the table of the run (`use_names`).

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>

#include <jaywalk/diagnostics.h>
#include <jaywalk/value.h>

namespace jaywalk {

class Percepts;

/// Adds a percept to those of the agent that is asked about. Arguments are numbers and atoms; there
/// are no annotations. REQUIRES: as many arguments as the predicate has.
void add_percept(Percepts& percepts, Predicate predicate, std::initializer_list<Value> args);
void add_percept(Percepts& percepts, Predicate predicate, std::span<const Value> args);

/// A literal without variables, of any arguments and annotations, in memory of its own.
class GroundLiteral {
 public:
  /// Reads `at(robot,[1,2])[from("north")]`; the name of the text is for diagnostics.
  [[nodiscard]] static Result<GroundLiteral> read(SymbolTable& symbols, const std::string& name,
                                                  const std::string& text);
  /// REQUIRES: `make` returns a literal without variables.
  GroundLiteral(SymbolTable& symbols, const std::function<Value(Terms terms)>& make);
  GroundLiteral(GroundLiteral&&) noexcept;
  GroundLiteral& operator=(GroundLiteral&&) noexcept;
  ~GroundLiteral();

  [[nodiscard]] Predicate predicate() const { return predicate_; }
  [[nodiscard]] std::span<const Value> args() const { return args_; }
  /// A list, or the empty list.
  [[nodiscard]] Value annotations() const { return annotations_; }

 private:
  std::unique_ptr<Heap> heap_;
  Predicate predicate_{};
  std::span<const Value> args_;
  Value annotations_;
};

/// Adds a percept of any terms, which must outlive the agent's next look. As in Jason, annotations
/// count when the agent begins to perceive the literal; while it does, others change nothing.
void add_percept(Percepts& percepts, const GroundLiteral& literal);

/// The number of an agent in its multi-agent system, from 0 in the order of creation.
enum class AgentId : std::uint32_t {};

/// An action that an agent has chosen. Arguments are valid during `execute` only.
struct ActionRequest {
  AgentId agent{};
  Predicate predicate{};
  std::span<const Value> args;
  /// From 1, in the order of all actions of the run.
  std::uint64_t number = 0;
};

/// Its outcome. A failed action fails the plan that asked for it (`error(action_failed)`);
/// `reason` becomes the text of the failure's `error_msg`.
struct ActionResult {
  bool succeeded = true;
  std::string reason;
  /// The action takes longer: `take_results` returns its result in a later tick. Until then the
  /// intention waits, while others of the agent go on.
  bool is_pending = false;
};

class Environment {
 public:
  virtual ~Environment() = default;

  /// A run begins. `symbols` are its names: those of the table that the environment was made with,
  /// and what is entered from now on. They are good until the run ends.
  virtual void use_names(SymbolTable& /*symbols*/) {}
  /// Adds all that `agent` perceives now, best in the same order every time, what comes and goes
  /// last. Agents perceive one after another, the world between two ticks being the same for all.
  virtual void perceive(AgentId agent, Percepts& percepts) const = 0;
  /// The agent, which has looked before, is not to look in this tick: its beliefs stay as they are,
  /// even if it has deleted percepts (Jason: `getPercepts` returns null).
  [[nodiscard]] virtual bool is_unchanged(AgentId /*agent*/) const { return false; }
  /// Adds the percepts that every agent has in every look of the run, all agents the same, which
  /// `perceive` adds as well. Agents share them, and rules that ask nothing else are asked once for
  /// all agents. A predicate that has such a percept has no others.
  virtual void constants(Percepts& /*percepts*/) const {}
  /// The actions of one tick, at most one for each agent, in the agents' order. All take effect at
  /// once. `results` has the same length, prefilled with success.
  virtual void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) = 0;
  /// Before agents look: calls `deliver` with the number and result of each pending action that has
  /// ended. A number that is not pending is ignored: its agent or intention may be gone.
  using ResultReceiver = std::function<void(std::uint64_t number, ActionResult result)>;
  virtual void take_results(const ResultReceiver& /*deliver*/) {}
  /// Everything in the world that is not an agent moves on by one tick.
  virtual void advance() = 0;
  /// Nothing more can happen that matters; the run ends.
  [[nodiscard]] virtual bool finished() const = 0;
  /// The length of a tick in milliseconds of virtual time; greater than 0.
  [[nodiscard]] virtual double tick_ms() const = 0;
};

}  // namespace jaywalk
