// SPDX-License-Identifier: Apache-2.0
#pragma once

// Terms, beliefs and queries from text, for the tests of what lies below agents.

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/compile/translator.h"
#include "interpreter/logic/machine.h"

namespace jaywalk::test {

/// A heap, a belief base and a machine, and the way from text to them. Within one Terms, a name of
/// a variable always means the same variable, until new_scope().
class Terms {
 public:
  Terms();
  Terms(const Terms&) = delete;
  Terms& operator=(const Terms&) = delete;

  /// REQUIRES (as all of these): the text is well formed; the test ends otherwise.
  [[nodiscard]] Value term(std::string_view text);
  /// Variables named from here on are new ones.
  void new_scope();
  /// Adds the facts and rules of a program text; queries find them in its order.
  void believe(std::string_view program);

  [[nodiscard]] bool unify(std::string_view a, std::string_view b) {
    const Value left = term(a);
    return unifier().unify(left, term(b));
  }
  /// The text of a term with all bindings applied.
  [[nodiscard]] std::string text(Value value);
  [[nodiscard]] std::string text(std::string_view written) { return text(term(written)); }

  /// Whether the formula has a solution; its bindings stay.
  [[nodiscard]] bool holds(std::string_view formula);
  /// `shown` for each solution of the formula, in order.
  [[nodiscard]] std::vector<std::string> answers(std::string_view formula, std::string_view shown);

  /// The facts of a predicate in the order in which they are asked.
  [[nodiscard]] std::vector<std::string> facts(std::string_view functor, int arity);

  Unifier& unifier() { return machine.unifier(); }

  Heap heap;
  SymbolTable symbols;
  BeliefBase beliefs{heap, symbols};
  Machine machine;
  /// The machine's warnings.
  std::vector<std::string> warnings;

 private:
  Translator translator_;
  std::unique_ptr<VariableScope> scope_;
};

}  // namespace jaywalk::test
