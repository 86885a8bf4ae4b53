// SPDX-License-Identifier: Apache-2.0
#pragma once

// Formulas as terms to goals (code.h). Serves programs, whose terms hold slots, and formulas that
// are data at run time, whose terms hold variables.

#include "interpreter/logic/action.h"
#include "interpreter/logic/code/code.h"

namespace jaywalk {

class RuleUnfolder;

class FormulaCompiler {
 public:
  FormulaCompiler(FormulaCode& code, const ActionRegistry& actions, SymbolTable& symbols)
      : code_(code), actions_(actions), symbols_(symbols) {}

  /// From now on, queries are unfolded (rule_unfolder.h).
  void unfold_with(RuleUnfolder& unfolder) { unfolder_ = &unfolder; }
  /// The entry of the formula; what follows it is `next`.
  const Goal* compile(Value formula, const Goal* next);
  /// An internal action as a goal of its own, for plan bodies.
  const Goal* compile_action(Value literal, const Goal* next);

 private:
  Goal& add(Goal::Kind kind, Value term, const Goal* next);
  const Goal* compile_structure(Value formula, const Goal* next);
  const Goal* compile_relation(Value formula, const Goal* next);
  const Goal* unfolded(Goal& query);

  FormulaCode& code_;
  const ActionRegistry& actions_;
  SymbolTable& symbols_;
  RuleUnfolder* unfolder_ = nullptr;
};

/// A rule from its head and body; head arguments that are expressions are evaluated when the body
/// has been solved, as in Jason. `heap` owns the templates that have to be made for that.
[[nodiscard]] std::unique_ptr<RuleCode> make_rule(Value head, Value body,
                                                  std::vector<Symbol> slot_names, Heap& heap,
                                                  const ActionRegistry& actions,
                                                  SymbolTable& symbols);

}  // namespace jaywalk
