// SPDX-License-Identifier: Apache-2.0
// Rule AddIM: the plan that was chosen becomes an intended means, a new intention for an external
// event, else on top of the intention that waits for the event (add_intended_means in
// choose_plan.cpp). This file has the rare cases.

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"

namespace jaywalk {

// The event's literal with the bindings of the head and the context. The body may bind its
// remaining variables, and a failure unsets them again (free_goal).
Value Agent::settled_literal(const Event& event) {
  work().binds_event = false;
  const Unifier::KeepCircles keep(machine().unifier());
  Value settled;
  try {
    settled = machine().unifier().apply(literal_of(event));
  } catch (const HeapExhausted&) {
    const MemoryReserve reserve(heap_);
    settled = machine().unifier().apply(literal_of(event));
  }
  for (GoalDeadline& deadline : circumstance_.deadlines) {
    if (deadline.goal.same_as(event.literal)) deadline.goal = settled;
  }
  return settled;
}

// Tail recursion: a means whose last formula calls the same goal again gives way to the new one.
bool Agent::is_last_call(const Intention& intention, const Event& event) {
  const IntendedMeans& caller = intention.top();
  if (caller.is_finished() || caller.step().next != nullptr) return false;
  // The literal is not made here: the means would have what the head has bound as if it were open.
  const Predicate predicate =
      event.literal.is_unset() ? work().next.predicate : predicate_of(event.literal);
  return event.op == TriggerOperator::add && event.kind != TriggerKind::belief &&
         caller.kind == event.kind && caller.op == event.op && !caller.plan->has_goal_condition &&
         caller.predicate() == predicate;
}

// The open variables of its own caller live on in the variables that the new means was given.
void Agent::hand_over(const Intention& intention, const IntendedMeans& caller) {
  signal_end(intention, caller);
  const Value* const pairs = intention.values.data() + caller.frame + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    const Value own = deref(pairs[i]);
    if (own.is_variable()) own.variable()->value = pairs[i + 1];
  }
}

// Sets the parts of means that few plans need.
void Agent::fill_rare(IntendedMeans& means, const ScopePtr& scope) {
  const Plan& plan = *means.plan;
  if (scope != nullptr) means.extras.make().scope = scope;
  if (plan.subplans != nullptr) {
    unusual_ |= kSubplans;
    means.extras.make().scope =
        std::make_shared<Scope>(Scope{plan.subplans.get(), closed_off(frame_for(plan)), scope});
  }
  if (plan.has_goal_condition) {
    ++goal_conditions_;
    attention_ = true;
    changed_ = true;  // it may hold already: then no formula is executed
  }
  if (plan.atomic) circumstance_.atomic_suspended = false;
}

// Informs the observer, and plans for goal states.
void Agent::announce_means(const Plan& plan, const Event& event, Intention& intention,
                           bool replaces) {
  if (replaces) hand_over(intention, intention.top());
  if (observer_ != nullptr) observer_->plan_chosen(*this, plan, event, intention);
}

// The literal of the event for which a means was added.
Value Agent::goal_of(const Intention& intention, const IntendedMeans& means) {
  if (!means.trigger.is_unset()) return means.trigger;
  return heap_.structure(means.plan->head.predicate, intention.goal_arguments(means, heap_),
                         source_self());
}

// An event whose literal has not been made is the next one, whose arguments are known.
Value Agent::literal_of(const Event& event) {
  if (!event.literal.is_unset()) return event.literal;
  NextEvent& next = work().next;
  Structure* const made = heap_.blank_literal(next.predicate, next.arity, source_self());
  std::copy_n(next.args.data(), next.arity, made->args());
  return next.event.literal = heap_.literal_of(made, !next.is_open);
}

// Like literal_of(), but the literal survives queries that are given up.
void Agent::keep_literal(const Event& event) {
  (void)literal_of(event);
  heap_.protect();
}

}  // namespace jaywalk
