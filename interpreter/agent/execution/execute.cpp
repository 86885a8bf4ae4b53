// SPDX-License-Identifier: Apache-2.0
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
#include "interpreter/agent/next_cycle.h"
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

[[gnu::noinline]] void Agent::execute_action(Intention& intention, Value term) {
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
  constexpr std::uint64_t kNoNumber = 0;
  (void)take_action(kNoNumber);
  give_feedback(kNoNumber, false, "no environment configured!");
}

[[gnu::noinline]] void Agent::execute_internal_action(Intention& intention, const Goal& goal) {
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

[[gnu::noinline]] void Agent::fail_constraint(Intention& intention) {
  fail(intention, constraint_failure(machine().unifier(), intention));
}

[[gnu::always_inline]] inline void Agent::execute_constraint(Intention& intention,
                                                             const Step& step) {
  Machine& machine = workspace_->machine;
  const std::size_t trail = machine.unifier().mark();
  if (!machine.solve(step.goal, intention.frame(intention.top()))) {
    fail_constraint(intention);
    return;
  }
  record_bindings(intention, trail);
  go_on(intention);
}

// The only variable of a goal, which has no value yet: see rename_in_goal.
[[gnu::always_inline]] inline void Agent::rename_slot(Intention& intention, Value& slot) {
  IntendedMeans& means = intention.top();
  const Symbol name = means.plan->slot_names[slot.slot_index()];
  intention.values.cut(means.frame + means.plan->slot_count);
  Value* const pair = intention.values.extend(2);
  pair[0] = slot;
  slot = pair[1] = heap_.variable(name);
  means.returns = 2;
}

// The goal of a formula, in the workspace. False: its literal must be made in the general way.
[[gnu::always_inline]] inline bool Agent::put_goal(Intention& intention, const EventCode& code) {
  NextEvent& next = workspace_->next;
  const Value* const frame = intention.frame(intention.top());
  OpenArguments open;
  if (!code.is_decoded || !put_arguments(code, frame, next.args.data(), open)) return false;
  next.predicate = code.predicate;
  next.arity = code.args.size();
  next.is_open = open.count > 0;
  if (open.count == 1 && open.last->is_slot()) {
    rename_slot(intention, *open.last);
  } else if (open.count > 0) {
    rename_in_goal(intention);
  }
  return true;
}

namespace {

// A deep stack doubles when it grows, and is there twice meanwhile.
inline void require_room_on(const Intention& intention, Heap& heap) {
  constexpr std::size_t kDeep = 1024;
  if (intention.stack.data() + intention.stack.size() <
      intention.stack.data() + intention.stack.capacity()) {
    return;
  }
  const std::size_t depth = intention.stack.size();
  if (depth >= kDeep) heap.require_bytes(2 * depth * sizeof(IntendedMeans));
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
  if (comes_next(intention)) {
    announce_next_event();
  } else {
    (void)literal_of(next.event);
    queue_event(next.event);
  }
}

// The goal of a formula that is a term.
[[gnu::noinline]] void Agent::achieve(Intention& intention, Value term, Step::Kind kind) {
  heap_.require_room();
  const bool new_focus = kind == Step::Kind::achieve_new_focus;
  const Unifier::KeepCircles keep(machine().unifier());
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

[[gnu::noinline]] void Agent::execute_test(Intention& intention, const Step& step) {
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
  const Unifier::KeepCircles keep(machine().unifier());
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
                           : brief_text(term, symbols_)) +
                      "'"));
}

[[gnu::noinline]] void Agent::execute_if(Intention& intention, const Step& step) {
  const std::size_t trail = machine().unifier().mark();
  const bool holds = machine().solve(step.goal, intention.frame(intention.top()));
  record_bindings(intention, trail);
  const Body* const branch = holds ? step.first : step.second;
  intention.go_on_at(branch == nullptr ? step.next : branch->begin(step.next));
  make_ready(intention);
}

[[gnu::noinline]] void Agent::execute_while(Intention& intention, const Step& step) {
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

void Agent::execute_at_limit(Intention& intention, const Step& step) {
  const MemoryReserve reserve(heap_);
  execute_step(intention, step);
}

void Agent::tell_of_formula(const Intention& intention, const Step& step) {
  observer_->formula_executes(*this, intention, step);
}

[[gnu::always_inline]] inline void Agent::execute_formula(Intention& intention) {
  if (intention.is_branch_done()) {
    drop(intention);
    return;
  }
  const IntendedMeans& means = intention.top();
  if (means.is_finished()) {  // an empty body takes a step, too
    make_ready(intention);
    return;
  }
  const Step& step = means.step();
  try {
    workspace_->machine.unifier().set_slot_names(
        {means.plan->slot_names.data(), means.plan->slot_count});
    if (observer_ != nullptr) tell_of_formula(intention, step);
    if (heap_.is_short() && handles_failure(intention)) {
      execute_at_limit(intention, step);
    } else {
      execute_step(intention, step);
    }
  } catch (...) {
    fail_at_limit(intention, error_of_limit());
  }
}

void Agent::execute(Intention& intention) { execute_formula(intention); }

// Something may be in the way of going on with the same intention. Mostly it is known that there
// has been nothing of the kind.
bool Agent::has_unusual_business() {
  const Circumstance& c = circumstance_;
  attention_ = c.atomic != nullptr || c.atomic_event != nullptr || c.atomic_suspended ||
               unseen_ != nullptr || goal_conditions_ > 0 || !c.feedback.empty() ||
               !c.tasks.empty() || !c.waits.empty() || !c.mailbox.empty();
  return attention_;
}

// The next cycle may begin, and only the intention that is held can be meant by it.
inline bool Agent::is_alone() {
  const Circumstance& c = circumstance_;
  return c.events.empty() && c.running.empty() && cycles_ < last_cycle_ &&
         !heap_.wants_collection() && !heap_.wants_count() && !turn_->has_business &&
         (unusual_ & (kCustomised | kSeldomLooks)) == 0 && (!attention_ || !has_unusual_business());
}

// Decides what follows a formula: the next one, for which another cycle has begun; the cycle's
// SelInt; or nothing more in this cycle.
[[gnu::always_inline]] inline Agent::Next Agent::go_on_alone(Intention& intention) {
  NextEvent& next = workspace_->next;
  while (next.is_pending) {
    if (!is_alone()) {
      queue_next_event(intention);
      return Next::nothing;
    }
    end_cycle();
    ++cycles_;
    next.is_pending = false;
    if (!find_option(next.event)) (void)no_plan(next.event);
    if (goal_conditions_ > 0 || !circumstance_.running.empty() || !(goes_on_ || next.is_pending)) {
      if (next.is_pending) queue_next_event(intention);
      release_held();
      return Next::selection;
    }
    if (std::exchange(goes_on_, false)) return Next::formula;
  }
  if (!goes_on_) return Next::nothing;
  if (!is_alone()) {
    release_held();
    return Next::nothing;
  }
  end_cycle();
  ++cycles_;
  goes_on_ = false;
  return Next::formula;
}

// Rules ExecInt and ClrInt: executes one formula of an intention, or more, a cycle for each, while
// it is the only intention. The intention is held outside of I until its next state is known.
Agent::Next Agent::run(Intention& intention) {
  Next next = Next::formula;
  do {
    executing_ = &intention;
    execute_formula(intention);
    changed_ = true;
    // An intention that suspends itself by its last formula is not done before it is resumed.
    if (!intention.is_finished() && intention.top().is_finished() &&
        intention.state != Intention::State::suspended) {
      clear_intention(intention);
    }
    executing_ = nullptr;
    next = go_on_alone(intention);
  } while (next == Next::formula);
  held_ = nullptr;
  return next;
}

}  // namespace jaywalk
