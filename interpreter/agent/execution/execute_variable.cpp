// SPDX-License-Identifier: Apache-2.0
// Rule ExecInt for a variable: a formula, or a whole body, that is known at run time only.

#include "interpreter/agent/agent.h"
#include "interpreter/agent/execution/step_texts.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

// The variable of the step has a value, or none, with which it is no formula.
ActionError variable_error(std::string id, Unifier& unifier, const Plan& plan, const Step& step,
                           Value value) {
  const std::string place = "file:" + plan.file + ":" + std::to_string(step.place.line) + ": ";
  const std::string name = "'" + text_as_written(unifier, plan, step) + "'";
  std::string message = place;
  if (id == "body_var_without_value") {
    message += "Variable " + name + " must be ground.";
  } else if (id == "body_var_with_op") {
    message += "The operator is lost with the variable " + name + " unified with a plan body.";
  } else {
    message += "Variable " + name + " must be a Literal and not '" +
               brief_text(value, unifier.symbols()) + "'.";
  }
  ActionError error;
  error.id = std::move(id);
  error.message = std::move(message);
  return error;
}

}  // namespace

// A variable as formula, with or without an operator: its value says what to do.
void Agent::execute_variable(Intention& intention, const Step& step) {
  IntendedMeans& means = intention.top();
  const Value value = machine().unifier().instantiate(step.term, intention.frame(means));
  record_bindings(intention, 0);
  const bool is_open = value.is_variable() || is_form(value, Form::decorated);
  // N::p(X) asks all namespaces; to do something, the namespace must be known.
  const bool is_named =
      is_form(value, Form::decorated) && is_literal(deref(value.structure()->arg(0)));
  if (is_open && !(is_named && step.variable_kind == Step::Kind::test)) {
    fail(intention,
         variable_error("body_var_without_value", machine().unifier(), *means.plan, step, value));
    return;
  }
  if (step.variable_kind == Step::Kind::test) {
    execute_test(intention, step);
    return;
  }
  const bool has_operator = step.variable_kind != Step::Kind::action;
  if (is_form(value, Form::body)) {
    if (has_operator) {
      fail(intention,
           variable_error("body_var_with_op", machine().unifier(), *means.plan, step, value));
      return;
    }
  } else if (!is_literal(value) && !value.is_structure()) {
    fail(intention,
         variable_error("body_var_not_literal", machine().unifier(), *means.plan, step, value));
    return;
  } else if (has_operator) {
    if (step.variable_kind == Step::Kind::achieve ||
        step.variable_kind == Step::Kind::achieve_new_focus) {
      achieve(intention, value, step.variable_kind);
    } else {
      change_belief_by_term(intention, value, step.variable_kind);
    }
    return;
  }
  auto code = std::make_shared<BodyCode>();
  code->entry = BodyCompiler(*code, machine().actions(), symbols_).compile(value);
  code->link(step.next);
  for (Body& made : code->bodies) {  // a literal that was a term has the place of the variable
    for (Step& each : made.steps) {
      if (each.place.line == 0) each.place = step.place;
    }
  }
  const Step* const first = code->entry->begin(step.next);
  std::vector<std::shared_ptr<BodyCode>>& codes = means.extras.make().codes;
  while (!codes.empty() && !codes.back()->has(step)) codes.pop_back();
  codes.push_back(std::move(code));
  // The formulas come in the variable's place, the first of them in this step.
  intention.go_on_at(first);
  if (first != nullptr) {
    execute(intention);
  } else {
    make_ready(intention);
  }
}

}  // namespace jaywalk
