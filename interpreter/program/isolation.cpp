// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/isolation.h"

#include <algorithm>

#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {
namespace {

// Goals whose predicate is known, and is none of an action.
bool is_inner(const FormulaCode& code) {
  return std::all_of(code.goals.begin(), code.goals.end(), [](const Goal& goal) {
    if (goal.kind == Goal::Kind::slow_query) return is_literal(goal.term);
    return goal.kind != Goal::Kind::action && goal.kind != Goal::Kind::variable;
  });
}

// Not of the plans for messages, which act; without annotations, which may set timers.
bool is_inner_goal(Value literal) {
  return is_literal(literal) && predicate_of(literal) != predicates::kqml_received &&
         (literal.is_atom() || !literal.structure()->is_annotated());
}

bool is_inner(const Step& step) {
  switch (step.kind) {
    case Step::Kind::achieve:
    case Step::Kind::achieve_new_focus:
      return is_inner_goal(step.term);
    case Step::Kind::test:  // the goal that it becomes if no belief answers
    case Step::Kind::add:
    case Step::Kind::add_new_focus:
    case Step::Kind::add_begin:
    case Step::Kind::add_end:
    case Step::Kind::remove:
    case Step::Kind::remove_new_focus:
    case Step::Kind::replace:
      return is_literal(step.term) || step.kind == Step::Kind::test;
    case Step::Kind::constraint:
    case Step::Kind::if_statement:
    case Step::Kind::while_loop:
    case Step::Kind::for_loop:
      return true;
    default:
      return false;
  }
}

bool is_inner(const Plan& plan) {
  if (plan.any_predicate || plan.subplans != nullptr || !is_inner(plan.code.formulas)) return false;
  const Predicate about = plan.key.predicate;
  if (about == predicates::kqml_received || about == predicates::jag_sleeping ||
      about == predicates::jag_awaking || about == predicates::jag_shutting_down) {
    return false;
  }
  return std::all_of(plan.code.bodies.begin(), plan.code.bodies.end(), [](const Body& body) {
    return std::all_of(body.steps.begin(), body.steps.end(),
                       [](const Step& step) { return is_inner(step); });
  });
}

}  // namespace

bool keeps_to_itself(const Program& program) {
  const auto& plans = program.library().plans();
  const auto& beliefs = program.beliefs();
  const auto& goals = program.goals();
  return std::all_of(plans.begin(), plans.end(),
                     [](const auto& plan) { return plan->is_standard || is_inner(*plan); }) &&
         std::all_of(beliefs.begin(), beliefs.end(),
                     [](const Program::Belief& belief) {
                       return belief.rule == nullptr || is_inner(belief.rule->body);
                     }) &&
         std::all_of(goals.begin(), goals.end(),
                     [](const Program::Goal& goal) { return is_literal(goal.literal); });
}

}  // namespace jaywalk
