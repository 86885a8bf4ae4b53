#pragma once

// The world as the interpreter sees it. An environment is asked what each agent perceives, is given
// all the actions chosen in one tick at once, and then moves on by itself. See mas.h for the order.

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/term/value.h"

namespace jaywalk {

/// The number of an agent in its multi-agent system, from 0 in the order of creation.
enum class AgentId : std::uint32_t {};

/// What one agent perceives in one tick: ground literals without annotations, whose arguments are
/// numbers and atoms. Written by the environment, read by belief update.
class Percepts {
 public:
  /// REQUIRES: as many arguments as the predicate has.
  void add(Predicate predicate, std::initializer_list<Value> args) {
    add(predicate, std::span<const Value>(args.begin(), args.size()));
  }
  void add(Predicate predicate, std::span<const Value> args);
  void clear();

  [[nodiscard]] std::size_t size() const { return predicates_.size(); }
  [[nodiscard]] Predicate predicate(std::size_t index) const { return predicates_[index]; }
  [[nodiscard]] std::span<const Value> args(std::size_t index) const;

 private:
  std::vector<Predicate> predicates_;
  std::vector<std::size_t> ends_;
  std::vector<Value> args_;
};

/// An action that an agent has chosen. Arguments are valid during `execute` only.
struct ActionRequest {
  AgentId agent{};
  Predicate predicate{};
  std::span<const Value> args;
};

/// What came of it. A failed action fails the plan that asked for it (`error(action_failed)`);
/// `reason` becomes the text of the failure's `error_msg`.
struct ActionResult {
  bool succeeded = true;
  std::string reason;
};

class Environment {
 public:
  virtual ~Environment() = default;

  /// What `agent` perceives now. Agents perceive one after another, the world between two ticks
  /// being the same for all of them.
  virtual void perceive(AgentId agent, Percepts& percepts) const = 0;
  /// The actions of one tick, at most one for each agent, in the agents' order. All take effect at
  /// once. `results` has the same length, prefilled with success.
  virtual void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) = 0;
  /// Everything in the world that is not an agent moves on by one tick.
  virtual void advance() = 0;
  /// Nothing more can happen that matters; the run ends.
  [[nodiscard]] virtual bool finished() const = 0;
  /// The length of a tick in milliseconds of virtual time.
  [[nodiscard]] virtual double tick_ms() const = 0;
};

}  // namespace jaywalk
