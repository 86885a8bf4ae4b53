// SPDX-License-Identifier: Apache-2.0
#pragma once

// Calls of internal actions: their arguments and their results.

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/logic/action_registry.h"
#include "interpreter/logic/code/code.h"
#include "interpreter/logic/counted_numbers.h"
#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {

class Agent;
class Intention;
class Machine;
class ActionCall;

/// The solutions of an action with several. Lives as long as the query may come back to it; `next`
/// binds by unifying and returns false at the end. Values that it holds are good until the end of
/// the cycle, as all are.
class Solutions {
 public:
  virtual ~Solutions() = default;
  virtual bool next(ActionCall& call) = 0;
  /// The numbers that the call's first argument, a variable, is bound to by the later solutions, if
  /// they bind nothing else; else null.
  [[nodiscard]] virtual const CountedNumbers* numbers() const { return nullptr; }
};

/// The limit that ends a query or a step before it is done.
enum class ReachedLimit : std::uint8_t { none, inferences, memory, nesting, interruption };

/// Why an action failed, beyond saying no: becomes the failure event's annotations.
struct ActionError {
  std::string id = "internal_action";  // error(id)
  std::string message;                 // error_msg("...")
  std::vector<Value> annots;           // further annotations
  ReachedLimit limit = ReachedLimit::none;
};

/// One call of an internal action.
class ActionCall {
 public:
  ActionCall(Machine& machine, const Goal& goal, Value* slots, Agent* agent, Intention* intention);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// The argument, applied (unless the action takes raw arguments) and dereferenced.
  [[nodiscard]] Value arg(std::size_t index) const { return deref(args()[index]); }
  [[nodiscard]] std::span<const Value> args() const {
    return {count_ <= few_args_.size() ? few_args_.data() : many_args_.data(), count_};
  }
  /// The argument with the values of variables that were bound meanwhile.
  [[nodiscard]] Value applied(std::size_t index);
  /// Unifies an argument with a value.
  [[nodiscard]] bool unify(std::size_t index, Value value);
  [[nodiscard]] Outcome result(std::size_t index, Value value) {
    return unify(index, value) ? Outcome::succeeded : Outcome::failed;
  }
  [[nodiscard]] Outcome many(std::unique_ptr<Solutions> all) {
    solutions = std::move(all);
    return Outcome::many;
  }
  /// error(id), error_msg(message).
  [[nodiscard]] Outcome fail(std::string id, std::string message);
  /// Fails with error(unknown) and an empty error_msg, where Jason throws an exception of Java.
  /// `message` is for people.
  [[nodiscard]] Outcome java_exception(std::string message);
  /// error(wrong_arguments), in the words of Jason's own checks.
  [[nodiscard]] Outcome wrong_arguments(std::string_view reason);
  [[nodiscard]] Outcome wrong_argument(std::size_t index, std::string_view expected);

  /// Calls `solution` for each answer to the formula in an argument; it may return false to stop.
  /// Bindings are undone afterwards.
  void solve(std::size_t index, const std::function<bool()>& solution);
  /// How many answers there are.
  [[nodiscard]] std::size_t count_answers(std::size_t index);

  [[nodiscard]] Machine& machine() { return machine_; }
  [[nodiscard]] Heap& heap();
  [[nodiscard]] SymbolTable& symbols();
  [[nodiscard]] Unifier& unifier();
  /// The agent that calls; null where formulas are solved without one (unit tests).
  [[nodiscard]] Agent* agent() { return agent_; }
  /// The intention that executes the action; null within a context or rule.
  [[nodiscard]] Intention* intention() { return intention_; }
  [[nodiscard]] const Goal& goal() const { return goal_; }
  [[nodiscard]] Value* slots() { return slots_; }

  std::unique_ptr<Solutions> solutions;
  /// Why it failed, to be filled in; most calls have none.
  [[nodiscard]] ActionError& error() {
    if (error_ == nullptr) error_ = std::make_unique<ActionError>();
    return *error_;
  }

 private:
  /// The argument is a formula of the program's text.
  [[nodiscard]] bool is_compiled(std::size_t index) const {
    return index < goal_.queries.size() && goal_.action != nullptr &&
           goal_.action->formula_args != 0;
  }

  std::unique_ptr<ActionError> error_;
  Machine& machine_;
  const Goal& goal_;
  Value* slots_;
  Agent* agent_;
  Intention* intention_;
  std::size_t count_;
  std::array<Value, 6> few_args_;
  std::vector<Value> many_args_;  // if there are more
};

}  // namespace jaywalk
