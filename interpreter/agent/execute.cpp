// Rule ExecInt: one formula of one intention. Every kind of formula has its function; each ends in
// one of three ways: go_on (the formula is done), fail, or the intention waits for an event, an
// action's feedback or a resumption.

#include <algorithm>
#include <array>
#include <optional>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/agent/goals.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/agent/step_texts.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

ActionError make_error(std::string id, std::string message) {
  ActionError error;
  error.id = std::move(id);
  error.message = std::move(message);
  return error;
}

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
               term_text(value, unifier.symbols()) + "'.";
  }
  return make_error(std::move(id), std::move(message));
}

}  // namespace

void Agent::execute(Intention& intention) {
  if (intention.is_branch_done()) {
    drop(intention);
    return;
  }
  IntendedMeans& means = intention.top();
  if (means.cursor.at_end() && means.cursor.is_loop) {
    // A round is done: its bindings are undone, and the loop's own formula comes again.
    undo_round(intention, means.loops.back());
    means.cursor = std::move(means.outer.back());
    means.outer.pop_back();
  }
  if (means.cursor.at_end()) {  // an empty body takes a step, too
    make_ready(intention);
    return;
  }
  std::unique_ptr<ActionError> error;
  const Step& step = means.step();
  const bool completed = guarded(error, [&] {
    machine().unifier().set_slot_names(means.plan->slot_names);
    if (observer_ != nullptr) observer_->formula_executes(*this, intention, step);
    std::optional<MemoryReserve> reserve;
    if (heap_.is_short() && handles_failure(intention)) reserve.emplace(heap_);
    execute_step(intention, step);
    return true;
  });
  if (!completed) fail_at_limit(intention, *error);
}

void Agent::fail_at_limit(Intention& intention, const ActionError& error) {
  machine().unifier().undo(0);
  const MemoryReserve reserve(heap_);
  report_limit(error, formula_place(intention));
  fail(intention, error);
}

void Agent::execute_step(Intention& intention, const Step& step) {
  switch (step.kind) {
    case Step::Kind::action:
      execute_action(intention, step.term);
      return;
    case Step::Kind::internal_action:
      execute_internal_action(intention, *step.goal);
      return;
    case Step::Kind::constraint: {
      const std::size_t trail = machine().unifier().mark();
      if (!machine().solve(step.goal, intention.frame(intention.top()))) {
        fail(intention, constraint_failure(machine().unifier(), intention));
        return;
      }
      record_bindings(intention, trail);
      go_on(intention);
      return;
    }
    case Step::Kind::achieve:
    case Step::Kind::achieve_new_focus:
      execute_achieve(intention, step.term, step.kind);
      return;
    case Step::Kind::test:
      execute_test(intention, step);
      return;
    case Step::Kind::add:
    case Step::Kind::add_new_focus:
    case Step::Kind::add_begin:
    case Step::Kind::add_end:
    case Step::Kind::remove:
    case Step::Kind::remove_new_focus:
    case Step::Kind::replace:
      execute_belief(intention, step.term, step.kind);
      return;
    case Step::Kind::variable:
      execute_variable(intention, step);
      return;
    case Step::Kind::if_statement:
      execute_if(intention, step);
      return;
    case Step::Kind::while_loop:
      execute_while(intention, step);
      return;
    case Step::Kind::for_loop:
      execute_for(intention, step);
      return;
    case Step::Kind::fork_and:
    case Step::Kind::fork_or:
      execute_fork(intention, step);
      return;
    case Step::Kind::join:
      execute_join(intention);
      return;
    case Step::Kind::wrong:
      break;
  }
  fail(intention, make_error("body_var_not_literal", "this formula cannot be executed"));
}

// The formula is done: the intention goes to the end of I.
void Agent::go_on(Intention& intention) {
  intention.advance();
  make_ready(intention);
}

void Agent::execute_action(Intention& intention, Value term) {
  Value* const frame = intention.frame(intention.top());
  const Value literal = machine().unifier().instantiate(term, frame);
  record_bindings(intention, 0);
  suspend(intention, Intention::State::acting, "act");
  circumstance_.actions.push_back({&intention, literal});
  if (library_->has_goal_state_plans()) {
    signal_top_state(intention, "waiting",
                     heap_.structure(symbols_.predicate("action", 1), std::span(&literal, 1)));
  }
  if (host_.act(*this)) return;
  (void)take_action();
  give_feedback(false, "no environment configured!");
}

void Agent::execute_internal_action(Intention& intention, const Goal& goal) {
  const std::size_t trail = machine().unifier().mark();
  std::unique_ptr<ActionError> error;
  // The action may drop its own intention, or end its goal: then it is where it belongs already.
  const std::size_t depth = intention.stack.size();
  const Outcome outcome = machine().call(goal, intention.frame(intention.top()), &intention, error);
  if (intention.state != Intention::State::running || intention.stack.size() != depth) return;
  switch (outcome) {
    case Outcome::succeeded:
      record_bindings(intention, trail);
      go_on(intention);
      return;
    case Outcome::suspended:
      return;
    case Outcome::failed:
      fail(intention, make_error("ia_failed", ""));
      return;
    case Outcome::many:
    case Outcome::error:
      fail(intention, error == nullptr ? ActionError{} : *error);
      return;
  }
}

// Behind the frame stands what a call is to bring back: each variable with its copy.
void Agent::note_returns(Intention& intention) {
  IntendedMeans& means = intention.top();
  intention.values.cut(means.frame + means.plan->slot_count);
  for (const auto& [own, copy] : work().renamed) {
    intention.values.push_back(own);
    intention.values.push_back(copy);
  }
  means.returns = 2 * work().renamed.size();
}

// A goal's or belief's literal, applied, with source(self) unless it has a source. Where values are
// to come back, its open variables are renamed and recorded behind the frame.
Value Agent::prepare_for_event(Intention& intention, Value term, bool returns) {
  Unifier& unifier = machine().unifier();
  Value* const frame = intention.frame(intention.top());
  work().renamed.clear();
  if (is_form(term, Form::literal)) {
    const Structure& s = *term.structure();
    const Value annots = s.is_annotated() ? s.annots() : source_self();
    if (annots.is_closed() && has_source(annots)) {
      const Value made =
          unifier.instantiate_renamed(s, frame, annots, returns ? &work().renamed : nullptr);
      record_bindings(intention, 0);
      if (!made.is_unset()) {
        if (!work().renamed.empty()) note_returns(intention);
        return made;
      }
    }
  }
  Value literal = unifier.instantiate(term, frame);
  record_bindings(intention, 0);
  if (!literal.is_closed()) {
    literal = unifier.rename(literal, returns ? &work().renamed : nullptr);
    if (returns) note_returns(intention);
  }
  if (!is_literal(literal)) return literal;
  const Value annots = literal_parts(literal).annots;
  if (has_source(annots)) return literal;
  const Value with_self =
      annots.is_empty_list() ? source_self() : union_of(heap_, annots, source_self(), symbols_);
  return with_annotations(heap_, literal, with_self);
}

void Agent::execute_achieve(Intention& intention, Value term, Step::Kind kind) {
  heap_.require_room();
  const bool new_focus = kind == Step::Kind::achieve_new_focus;
  Value goal = prepare_for_event(intention, term, !new_focus);
  if (!is_literal(goal)) {
    fail(intention, make_error("body_var_not_literal", "a goal must be a literal"));
    return;
  }
  if (!literal_parts(goal).annots.same_as(source_self())) goal = Goals(*this).watch_deadline(goal);
  if (new_focus) {
    add_goal(goal);
    go_on(intention);
  } else {
    add_event({TriggerOperator::add, TriggerKind::achieve, goal, &intention, 0});
  }
}

void Agent::execute_test(Intention& intention, const Step& step) {
  const std::size_t trail = machine().unifier().mark();
  if (machine().solve(step.goal, intention.frame(intention.top()))) {
    record_bindings(intention, trail);
    go_on(intention);
    return;
  }
  fail_test(intention, step);
}

// A test that no belief and no rule answers: the plans for it are asked.
void Agent::fail_test(Intention& intention, const Step& step) {
  const std::size_t trail = machine().unifier().mark();
  const Value term = machine().unifier().instantiate(step.term, intention.frame(intention.top()));
  record_bindings(intention, trail);
  if (is_literal(term)) {
    const TriggerKey key = trigger_key(TriggerOperator::add, TriggerKind::test,
                                       literal_parts(term).predicate, symbols_);
    if (!library_->candidates(key).empty()) {
      heap_.require_room();
      const Value goal = prepare_for_event(intention, step.term, true);
      add_event({TriggerOperator::add, TriggerKind::test, goal, &intention, 0});
      return;
    }
  }
  fail(intention,
       make_error("test_goal_failed",
                  "Failed to test '" +
                      (step.kind == Step::Kind::test
                           ? text_as_written(machine().unifier(), *intention.top().plan, step)
                           : term_text(term, symbols_)) +
                      "'"));
}

void Agent::execute_belief(Intention& intention, Value term, Step::Kind kind) {
  if (execute_plan_or_rule(intention, term, kind)) return;
  const bool new_focus = kind == Step::Kind::add_new_focus ||
                         kind == Step::Kind::remove_new_focus || !settings_.same_focus;
  Intention* const focus = new_focus ? nullptr : &intention;
  const bool removes = kind == Step::Kind::remove || kind == Step::Kind::remove_new_focus;
  // Deleting binds the variables of the pattern, so they are not renamed.
  const Value literal =
      removes || kind == Step::Kind::replace
          ? machine().unifier().instantiate(term, intention.frame(intention.top()))
          : prepare_for_event(intention, term, !new_focus);
  if (!is_literal(literal)) {
    fail(intention, make_error("body_var_not_literal", "a belief must be a literal"));
    return;
  }
  if (kind == Step::Kind::replace) {
    execute_replace(intention, literal);
    return;
  }
  if (removes) record_bindings(intention, 0);
  const std::size_t trail = machine().unifier().mark();
  const Place place = kind == Step::Kind::add_end ? Place::back : Place::front;
  const bool changed = removes ? remove_belief(literal, focus) : add_belief(literal, place, focus);
  // What is deleted gives its values to the intention if it handles the event.
  if (removes && (!changed || focus == nullptr)) machine().unifier().undo(trail);
  record_bindings(intention, trail);
  if (!changed || new_focus) go_on(intention);
}

// -+b: one belief of the same name goes, as if deleted by another intention, then b comes.
void Agent::execute_replace(Intention& intention, Value literal) {
  const LiteralParts parts = literal_parts(literal);
  work().frame.resize(parts.args.size());
  for (Value& arg : work().frame) arg = heap_.variable();
  const std::size_t trail = machine().unifier().mark();
  (void)remove_belief(heap_.structure(parts.predicate, work().frame, parts.annots), nullptr);
  machine().unifier().commit(trail);
  record_bindings(intention, 0);
  if (!literal.is_closed()) literal = machine().unifier().fresh_copy(literal);
  Intention* const focus = settings_.same_focus ? &intention : nullptr;
  if (!add_belief(literal, Place::front, focus) || focus == nullptr) go_on(intention);
}

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
      execute_achieve(intention, value, step.variable_kind);
    } else {
      execute_belief(intention, value, step.variable_kind);
    }
    return;
  }
  auto code = std::make_shared<BodyCode>();
  code->entry = BodyCompiler(*code, machine().actions(), symbols_).compile(value);
  for (Body& made : code->bodies) {  // a literal that was a term has the place of the variable
    for (Step& each : made.steps) {
      if (each.place.line == 0) each.place = step.place;
    }
  }
  const Body& body = *code->entry;
  if (is_form(value, Form::body)) {
    // The formulas come in the variable's place, the first of them in this step.
    enter_body(intention, body, std::move(code));
    if (!intention.top().cursor.at_end())
      execute(intention);
    else
      make_ready(intention);
  } else {
    enter_body(intention, body, std::move(code));
    execute(intention);
  }
}

// The rest of the current body waits until `body` is done.
void Agent::enter_body(Intention& intention, const Body& body, std::shared_ptr<BodyCode> code) {
  IntendedMeans& means = intention.top();
  if (code == nullptr) code = means.cursor.code;
  ++means.cursor.index;
  if (!means.cursor.at_end() || means.cursor.is_loop) means.outer.push_back(means.cursor);
  means.cursor = Cursor{&body, 0, std::move(code), false};
  Intention::leave_finished_bodies(means);
}

void Agent::execute_if(Intention& intention, const Step& step) {
  const std::size_t trail = machine().unifier().mark();
  const bool holds = machine().solve(step.goal, intention.frame(intention.top()));
  record_bindings(intention, trail);
  const Body* const branch = holds ? step.first : step.second;
  if (branch == nullptr) {
    go_on(intention);
    return;
  }
  enter_body(intention, *branch, nullptr);
  make_ready(intention);
}

void Agent::execute_while(Intention& intention, const Step& step) {
  IntendedMeans& means = intention.top();
  if (means.loops.empty() || means.loops.back().step != &step) {
    means.loops.emplace_back().step = &step;
  }
  const std::size_t trail = machine().unifier().mark();
  if (!machine().solve(step.goal, intention.frame(means))) {
    means.loops.pop_back();
    go_on(intention);
    return;
  }
  record_bindings(intention, trail);
  means.outer.push_back(means.cursor);
  means.cursor = Cursor{step.first, 0, means.cursor.code, true};
  make_ready(intention);
}

}  // namespace jaywalk
