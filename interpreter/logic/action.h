#pragma once

// Internal actions and arithmetic functions: how they are called and found. The standard ones stand
// in actions/table/actions.def, a row each; programs that embed the interpreter may register their
// own.

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "interpreter/logic/code/code.h"
#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {

class Agent;
class Intention;
class Machine;
class ActionCall;

/// What came of a call.
enum class Outcome : std::uint8_t {
  failed,  // false: the formula fails with ia_failed, the query has no solution
  succeeded,
  many,       // ActionCall::solutions yields them one by one
  suspended,  // the intention waits; once resumed it goes on after the formula
  error,      // ActionCall::error says why
};

/// The solutions of an action with several. Lives as long as the query may come back to it; `next`
/// binds by unifying and returns false at the end. Values that it holds are good until the end of
/// the cycle, as all are.
class Solutions {
 public:
  virtual ~Solutions() = default;
  virtual bool next(ActionCall& call) = 0;
};

using ActionFunction = Outcome (*)(ActionCall& call);

struct ActionDefinition {
  std::string name;  // with its dot: ".print"
  int least_args = 0;
  int most_args = -1;  // -1: any number
  ActionFunction function = nullptr;
  std::string signature;  // ".print(Term, ...)"
  std::string summary;    // one sentence
  /// May not stand in a plan's context.
  bool body_only = false;
  /// Which arguments are formulas (bit i: argument i, bit 31: the last one); compiled beforehand.
  std::uint32_t formula_args = 0;
  /// Arguments are handed over as written, not applied.
  bool raw_args = false;
  /// Jason does not count its arguments: too few are an exception of Java, more are passed over.
  bool is_uncounted = false;
  /// What own_action() calls: a function object with what it needs.
  std::function<Outcome(ActionCall& call)> own;
};

/// An internal action of a program that embeds the interpreter. Its name has a dot, as Jason's
/// `package.name` has: "my.sum". It is called on the threads that run agents of its registry.
[[nodiscard]] ActionDefinition own_action(std::string name, int least_args, int most_args,
                                          std::function<Outcome(ActionCall& call)> body);

/// Evaluates a function whose arguments have been applied; no value: the term stays as it is.
using FunctionBody = bool (*)(std::span<const Value> args, Heap& heap, SymbolTable& symbols,
                              Value& result);

struct FunctionDefinition {
  std::string name;
  int least_args = 0;
  int most_args = 0;
  FunctionBody function = nullptr;  // null: needs the machine (.count, math.random)
  std::string signature;
  std::string summary;
};

/// What error_msg says when an action is called with another number of arguments.
[[nodiscard]] std::string wrong_number_of_arguments(const ActionDefinition& action);
/// Whether it can be called with so many.
[[nodiscard]] bool takes(const ActionDefinition& action, std::size_t count);

/// All known actions and functions, by name. Immutable once programs are compiled against it. What
/// is added later stands before what has the same name.
class ActionRegistry {
 public:
  ActionRegistry() = default;
  ActionRegistry(const ActionRegistry&) = delete;
  ActionRegistry& operator=(const ActionRegistry&) = delete;
  ActionRegistry(ActionRegistry&&) = default;
  ActionRegistry& operator=(ActionRegistry&&) = default;
  ~ActionRegistry() = default;

  /// Everything that another registry has.
  void add_all(const ActionRegistry& other);
  void add(ActionDefinition action);
  void add(FunctionDefinition function);
  [[nodiscard]] const ActionDefinition* action(std::string_view name) const;
  [[nodiscard]] const FunctionDefinition* function(std::string_view name, std::size_t arity) const;
  /// In the order of registration.
  [[nodiscard]] const std::deque<ActionDefinition>& actions() const { return actions_; }
  [[nodiscard]] const std::deque<FunctionDefinition>& functions() const { return functions_; }

 private:
  std::deque<ActionDefinition> actions_;
  std::deque<FunctionDefinition> functions_;
  std::unordered_map<std::string_view, const ActionDefinition*> by_name_;
  std::unordered_map<std::string_view, const FunctionDefinition*> functions_by_name_;
};

/// The standard library (defined in actions/).
[[nodiscard]] const ActionRegistry& standard_actions();

/// What ends a query or a step before it is done.
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
  /// The argument with what it now means for variables bound meanwhile.
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
  /// Where Jason ends in an exception of Java: error(unknown), and error_msg is empty. `message` is
  /// for people.
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
