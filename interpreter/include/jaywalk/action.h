// SPDX-License-Identifier: Apache-2.0
#pragma once

// Internal actions and functions that a program which embeds the interpreter adds to the language.
// An internal action stands in contexts, rules and bodies, and its name has a dot:
//
//   interpreter.add_action("road.distance", 2, 2, [](jaywalk::Call& call) {
//     if (!call.arg(0).is_number()) return call.wrong_argument(0, "a speed in m/s");
//     return call.result(1, jaywalk::Value::number(...));
//   });
//
// A function stands in arithmetic expressions and must depend on its arguments alone.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <jaywalk/value.h>

namespace jaywalk {

class ActionCall;

/// The result of a call.
enum class Outcome : std::uint8_t {
  failed,  // false: the formula fails with ia_failed, the query has no solution
  succeeded,
  many,       // several solutions, one by one: Call::each
  suspended,  // the intention waits; once resumed it goes on after the formula
  error,      // Call::fail says why
};

/// One call of an internal action, good until the action returns.
class Call {
 public:
  explicit Call(ActionCall& call) : call_(&call) {}

  /// How many arguments there are, and each of them with the values of its variables.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] Value arg(std::size_t index) const;
  /// Reads arguments and makes new terms.
  [[nodiscard]] Terms terms() const;
  /// The name of the agent that calls.
  [[nodiscard]] const std::string& agent() const;

  /// Unifies an argument with a value. False: they differ.
  [[nodiscard]] bool unify(std::size_t index, Value value);
  /// The outcome of that.
  [[nodiscard]] Outcome result(std::size_t index, Value value) {
    return unify(index, value) ? Outcome::succeeded : Outcome::failed;
  }
  /// Several solutions: `next` unifies what it likes and returns true, or returns false at the end.
  /// It must own its data: it is called long after the action has returned.
  [[nodiscard]] Outcome each(std::function<bool(Call& call)> next);
  /// Calls `solution` for each answer to a formula that is an argument; it may return false to
  /// stop. Bindings are undone afterwards.
  void solve(std::size_t index, const std::function<bool()>& solution);

  /// The failure has the annotations error(id), error_msg(message).
  [[nodiscard]] Outcome fail(std::string id, std::string message);
  /// error(wrong_arguments), in the words of Jason's own checks; `expected`: "a number".
  [[nodiscard]] Outcome wrong_argument(std::size_t index, std::string_view expected);

  /// The number of the intention that executes the action, for Interpreter::resume; nothing within
  /// a context or rule, which cannot wait.
  [[nodiscard]] std::optional<std::uint32_t> intention() const;
  /// Makes the intention wait until Interpreter::resume; in a context or rule it is an error.
  /// `reason` is what `.suspended` reports.
  [[nodiscard]] Outcome suspend(std::string reason);

 private:
  ActionCall* call_;
};

/// Evaluates a function whose arguments have no variables that are bound; false: it has no value,
/// and the term stays as it is. `Terms(heap, symbols)` reads them.
using FunctionBody = bool (*)(std::span<const Value> args, Heap& heap, SymbolTable& symbols,
                              Value& result);

struct FunctionDefinition {
  std::string name;
  int least_args = 0;
  int most_args = 0;
  FunctionBody function = nullptr;  // null: `own`, or it needs the machine (.count, math.random)
  /// For people: "road.kmh(Speed)", and one sentence.
  std::string signature;
  std::string summary;
  /// Instead of `function`, one that has data of its own.
  std::function<bool(std::span<const Value> args, Heap& heap, SymbolTable& symbols, Value& result)>
      own = {};
};

}  // namespace jaywalk
