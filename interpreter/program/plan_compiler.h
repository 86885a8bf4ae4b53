// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compiles plans and plan bodies as terms to code (plan.h), like formula_compiler.h for formulas.
// Used for programs and for terms at run time.

#include "interpreter/logic/formula_compiler.h"
#include "interpreter/program/plan.h"

namespace jaywalk {

class BodyCompiler {
 public:
  BodyCompiler(BodyCode& code, const ActionRegistry& actions, SymbolTable& symbols)
      : code_(code), formulas_(code.formulas, actions, symbols), symbols_(symbols) {}

  /// The body of a term of form body (or of a single formula).
  const Body* compile(Value body);
  /// A formula used as the context of the same plan.
  const Goal* compile_formula(Value formula) { return formulas_.compile(formula, nullptr); }

 private:
  void compile_steps(const Structure& body, Body& made);
  Step compile_step(Value step);
  void compile_plain(Step& step);
  void prepare(Step& step);
  bool compile_statement(Step& step);
  void add_conjuncts(Value formula, std::vector<const Goal*>& conjuncts);

  BodyCode& code_;
  FormulaCompiler formulas_;
  SymbolTable& symbols_;
};

/// The parts of a term of form plan.
struct PlanParts {
  Value label, trigger, context, body, goal_condition, subplans;
};
[[nodiscard]] PlanParts plan_parts(Value plan);

/// Whether the plans have the same trigger, context and body; labels do not count.
[[nodiscard]] bool equal_plans(const Plan& a, const Plan& b);

/// The parts of a trigger term.
struct TriggerParts {
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  Value literal;
};
/// Takes a term of form trigger, or a body with the single formula `+b` or `-b`, apart. False:
/// neither.
[[nodiscard]] bool trigger_parts(Value term, const SymbolTable& symbols, TriggerParts& parts);

/// `+!`, `-`, `^?`, ...: how a trigger begins.
[[nodiscard]] std::string trigger_operator(TriggerOperator op, TriggerKind kind);

/// The key under which plans for a trigger's literal are found.
[[nodiscard]] TriggerKey trigger_key(TriggerOperator op, TriggerKind kind, Predicate predicate,
                                     SymbolTable& symbols);

/// Compiles a plan term whose variables are slots. Null: it is no plan.
[[nodiscard]] std::shared_ptr<Plan> compile_plan(Value plan, std::vector<Symbol> slot_names,
                                                 const ActionRegistry& actions,
                                                 SymbolTable& symbols);

}  // namespace jaywalk
