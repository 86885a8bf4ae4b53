// Rule ExecInt: one formula of one intention. Every kind of formula has its function; each ends in
// one of three ways: go_on (the formula is done), fail, or the intention waits for an event, an
// action's feedback or a resumption.

#include <algorithm>
#include <array>
#include <optional>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/execution/goal_arguments.h"
#include "interpreter/agent/execution/step_texts.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/agent/goals/goals.h"
#include "interpreter/agent/step_guard.h"
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

}  // namespace

void Agent::fail_at_limit(Intention& intention, const ActionError& error) {
  machine().unifier().undo(0);
  const MemoryReserve reserve(heap_);
  report_limit(error, formula_place(intention));
  fail(intention, error);
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

[[gnu::always_inline]] inline void Agent::execute_constraint(Intention& intention,
                                                             const Step& step) {
  const std::size_t trail = machine().unifier().mark();
  if (!machine().solve(step.goal, intention.frame(intention.top()))) {
    fail(intention, constraint_failure(machine().unifier(), intention));
    return;
  }
  record_bindings(intention, trail);
  go_on(intention);
}

// The goal of a formula, in the workspace. False: its literal is to be made in the general way.
[[gnu::always_inline]] inline bool Agent::put_goal(Intention& intention, const EventCode& code) {
  NextEvent& next = workspace_->next;
  bool is_open = false;
  const Value* const frame = intention.frame(intention.top());
  if (!code.is_decoded || !put_arguments(code, frame, next.args.data(), is_open)) return false;
  next.predicate = code.predicate;
  next.arity = code.args.size();
  next.is_open = is_open;
  if (is_open) rename_in_goal(intention);
  return true;
}

namespace {

// A deep stack doubles when it grows, and is there twice meanwhile.
inline void require_room_on(const Intention& intention, Heap& heap) {
  constexpr std::size_t kDeep = 1024;
  const std::size_t depth = intention.stack.size();
  if (depth < kDeep || depth < intention.stack.capacity()) return;
  heap.require_bytes(2 * depth * sizeof(IntendedMeans));
}

}  // namespace

[[gnu::always_inline]] inline void Agent::execute_achieve(Intention& intention, const Step& step) {
  heap_.require_room();
  require_room_on(intention, heap_);
  if (step.event == nullptr || !put_goal(intention, *step.event)) {
    achieve(intention, step.term, step.kind);
    return;
  }
  NextEvent& next = workspace_->next;
  next.event = {TriggerOperator::add, TriggerKind::achieve, Value(), &intention};
  next.code = step.event;
  changed_ = true;
  if (comes_next(intention)) {
    announce_next_event();
  } else {
    (void)literal_of(next.event);
    queue_event(next.event);
  }
}

// The goal of a formula that is a term.
void Agent::achieve(Intention& intention, Value term, Step::Kind kind) {
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
    add_event({TriggerOperator::add, TriggerKind::achieve, goal, &intention});
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
      add_event({TriggerOperator::add, TriggerKind::test, goal, &intention});
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

// The belief that was added last goes if it is a fact of the agent's own and has no other source.
// False: it is something else, and nothing has been done.
bool Agent::forget_one(Predicate predicate) {
  if (customisation_ != nullptr) return false;
  Relation* const relation = beliefs_.find(predicate);
  if (relation == nullptr) return true;
  for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
    const Row& row = relation->row(seq);
    if (row.is_hole()) continue;
    if (!row.fact.is_structure() || !row.fact.is_closed()) return false;
    const Structure& fact = *row.fact.structure();
    if (fact.arity == 0 || !fact.annots().same_as(source_self())) return false;
    const Value forgotten = row.fact;
    beliefs_.erase(*relation, seq);
    add_event({TriggerOperator::remove, TriggerKind::belief, forgotten, nullptr});
    return true;
  }
  return true;
}

// Removes a belief that is to be replaced.
void Agent::forget_for(Value literal) {
  const LiteralParts parts = literal_parts(literal);
  if (parts.annots.same_as(source_self()) && forget_one(parts.predicate)) return;
  std::vector<Value> args(parts.args.size());
  for (Value& arg : args) arg = heap_.variable();
  const std::size_t trail = machine().unifier().mark();
  (void)remove_belief(heap_.structure(parts.predicate, args, parts.annots), nullptr);
  machine().unifier().commit(trail);
}

// `+b`, `-b` and `-+b` with a ground b that has no other source than the agent itself, without
// belief revision. The next formula waits for the plan for it.
[[gnu::always_inline]] inline void Agent::change_own_belief(Intention& intention, Value literal,
                                                            Step::Kind kind) {
  bool changed = false;
  if (kind == Step::Kind::remove) {
    changed = disbelieve_as_it_is(literal, &intention);
  } else {
    const bool replaces = kind == Step::Kind::replace;
    if (replaces && !forget_one(literal.structure()->predicate())) forget_for(literal);
    changed = believe_as_it_is(literal, Place::front, &intention);
  }
  if (!changed) go_on(intention);
}

// The belief of the formula if it is ground, of the usual form, and the agent's own; else unset.
[[gnu::always_inline]] inline Value Agent::ground_belief(Intention& intention,
                                                         const EventCode& code) {
  if (!code.is_decoded) return {};
  Structure* const made = heap_.blank_literal(code.predicate, code.args.size(), source_self());
  bool is_open = false;
  const Value* const frame = intention.frame(intention.top());
  if (!put_arguments(code, frame, made->args(), is_open) || is_open) return {};
  return heap_.literal_of(made, true);
}

void Agent::execute_belief(Intention& intention, const Step& step) {
  const Value literal = step.event == nullptr ? Value() : ground_belief(intention, *step.event);
  if (literal.is_unset()) {
    change_belief_by_term(intention, step.term, step.kind);
  } else if (customisation_ != nullptr || !settings_.same_focus) {
    change_belief(intention, literal, step.kind);
  } else {
    change_own_belief(intention, literal, step.kind);
  }
}

void Agent::change_belief_by_term(Intention& intention, Value term, Step::Kind kind) {
  if (execute_plan_or_rule(intention, term, kind)) return;
  const bool new_focus = kind == Step::Kind::add_new_focus || !settings_.same_focus;
  const bool adds = kind == Step::Kind::add || kind == Step::Kind::add_new_focus ||
                    kind == Step::Kind::add_begin || kind == Step::Kind::add_end;
  // Deleting binds the variables of the pattern, so they are not renamed.
  const Value literal =
      adds ? prepare_for_event(intention, term, !new_focus)
           : machine().unifier().instantiate(term, intention.frame(intention.top()));
  if (is_literal(literal)) {
    change_belief(intention, literal, kind);
  } else {
    fail(intention, make_error("body_var_not_literal", "a belief must be a literal"));
  }
}

void Agent::change_belief(Intention& intention, Value literal, Step::Kind kind) {
  if (kind == Step::Kind::replace) {
    execute_replace(intention, literal);
    return;
  }
  const bool new_focus = kind == Step::Kind::add_new_focus ||
                         kind == Step::Kind::remove_new_focus || !settings_.same_focus;
  Intention* const focus = new_focus ? nullptr : &intention;
  const bool removes = kind == Step::Kind::remove || kind == Step::Kind::remove_new_focus;
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
  forget_for(literal);
  record_bindings(intention, 0);
  if (!literal.is_closed()) literal = machine().unifier().fresh_copy(literal);
  Intention* const focus = settings_.same_focus ? &intention : nullptr;
  if (!add_belief(literal, Place::front, focus) || focus == nullptr) go_on(intention);
}

void Agent::execute_if(Intention& intention, const Step& step) {
  const std::size_t trail = machine().unifier().mark();
  const bool holds = machine().solve(step.goal, intention.frame(intention.top()));
  record_bindings(intention, trail);
  const Body* const branch = holds ? step.first : step.second;
  intention.go_on_at(branch == nullptr ? step.next : branch->begin(step.next));
  make_ready(intention);
}

void Agent::execute_while(Intention& intention, const Step& step) {
  const IntendedMeans& means = intention.top();
  std::vector<Loop>& loops = intention.top().extras.make().loops;
  if (loops.empty() || loops.back().step != &step) {
    loops.emplace_back().step = &step;
  } else {
    undo_round(intention, loops.back());
  }
  const std::size_t trail = machine().unifier().mark();
  if (!machine().solve(step.goal, intention.frame(means))) {
    loops.pop_back();
    go_on(intention);
    return;
  }
  record_bindings(intention, trail);
  intention.go_on_at(step.first->begin(&step));
  make_ready(intention);
}

[[gnu::always_inline]] inline void Agent::execute_step(Intention& intention, const Step& step) {
  switch (step.kind) {
    case Step::Kind::action:
      execute_action(intention, step.term);
      return;
    case Step::Kind::internal_action:
      execute_internal_action(intention, *step.goal);
      return;
    case Step::Kind::constraint:
      execute_constraint(intention, step);
      return;
    case Step::Kind::achieve:
    case Step::Kind::achieve_new_focus:
      execute_achieve(intention, step);
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
      execute_belief(intention, step);
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

void Agent::execute(Intention& intention) {
  if (intention.is_branch_done()) {
    drop(intention);
    return;
  }
  const IntendedMeans& means = intention.top();
  if (means.is_finished()) {  // an empty body takes a step, too
    make_ready(intention);
    return;
  }
  std::unique_ptr<ActionError> error;
  const Step& step = means.step();
  const bool completed = guarded(error, [&] {
    workspace_->machine.unifier().set_slot_names(means.plan->slot_names);
    if (observer_ != nullptr) observer_->formula_executes(*this, intention, step);
    if (heap_.is_short() && handles_failure(intention)) {
      const MemoryReserve reserve(heap_);
      execute_step(intention, step);
    } else {
      execute_step(intention, step);
    }
    return true;
  });
  if (!completed) fail_at_limit(intention, *error);
}

}  // namespace jaywalk
