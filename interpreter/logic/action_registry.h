// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definitions of internal actions and arithmetic functions, found by name. The standard ones
// are rows of actions/table/actions.def; programs that embed the interpreter may register their
// own. action.h has the calls.

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <jaywalk/action.h>

namespace jaywalk {

class ActionCall;

using ActionFunction = Outcome (*)(ActionCall& call);

/// Formulas written like an action that are goals of their own kind (Goal::Kind::probe).
enum class Probe : std::uint8_t { none, asked, answered };

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
  /// It is none, but reports how far a query comes (coverage/probes.h).
  Probe probe = Probe::none;
  /// The function object that own_action() calls.
  std::function<Outcome(ActionCall& call)> own;
};

/// An internal action of a program that embeds the interpreter. Its name has a dot, as Jason's
/// `package.name` has: "my.sum". It is called on the threads that run agents of its registry.
[[nodiscard]] ActionDefinition own_action(std::string name, int least_args, int most_args,
                                          std::function<Outcome(ActionCall& call)> body);

/// The error_msg of an action that is called with another number of arguments.
[[nodiscard]] std::string wrong_number_of_arguments(const ActionDefinition& action);
/// Whether it takes `count` arguments.
[[nodiscard]] bool takes(const ActionDefinition& action, std::size_t count);

/// All known actions and functions, by name. Immutable once programs are compiled against it. A
/// later entry hides an earlier one of the same name.
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

}  // namespace jaywalk
