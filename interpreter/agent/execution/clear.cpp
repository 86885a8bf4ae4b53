// SPDX-License-Identifier: Apache-2.0
// Rule ClrInt: removes finished means and returns their values.

#include "interpreter/agent/agent.h"

namespace jaywalk {

// A goal has been achieved.
void Agent::signal_end(const Intention& intention, const IntendedMeans& done) {
  if (!library_->has_goal_state_plans()) return;
  const Value goal = goal_of(intention, done);
  signal_goal_state(done.kind, goal, "achieved");
  signal_goal_state(done.kind, goal, "finished");
}

void Agent::pop_means(Intention& intention) {
  if (intention.top().plan->has_goal_condition) --goal_conditions_;
  intention.pop();
}

// The usual case: all that comes back is closed and goes into slots without a value. False:
// something is of another kind, and all of it is still to be returned.
[[gnu::always_inline]] inline bool Agent::return_closed_values(Intention& intention) {
  const IntendedMeans& caller = intention.top();
  if (caller.has_loops()) return false;
  Value* const frame = intention.frame(caller);
  const Value* const pairs = frame + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    if (!pairs[i].is_slot() || !frame[pairs[i].slot_index()].is_unset()) return false;
    const Value returned = deref(pairs[i + 1]);
    if (!returned.is_closed() || Unifier::is_of_other_namespace(returned)) return false;
    frame[pairs[i].slot_index()] = returned;
  }
  return true;
}

// Copies back the values of the variables that were renamed at the call. Unbound variables in them
// are renamed, so that they are not shared with the plan that has ended.
void Agent::return_values(Intention& intention) {
  const IntendedMeans& caller = intention.top();
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  Value* const frame = intention.frame(caller);
  Value* const pairs = frame + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    const Value returned = deref(pairs[i + 1]);
    if (pairs[i].is_slot()) {
      // The caller's variable has not been made yet (goal_arguments.cpp).
      Value& slot = frame[pairs[i].slot_index()];
      if (slot.is_unset() && returned.is_closed() && !Unifier::is_of_other_namespace(returned)) {
        unifier.set_slot(&slot, returned);
        continue;
      }
      if (slot.is_unset()) {
        slot = heap_.variable(caller.plan->slot_names[pairs[i].slot_index()]);
      }
      pairs[i] = slot;
    }
    if (returned.is_variable()) {
      // Still open; if two of them have become one, so do the caller's.
      for (std::size_t j = 0; j < i; j += 2) {
        const Value own = deref(pairs[i]);
        if (deref(pairs[j + 1]).same_as(returned) && own.is_variable() &&
            !own.same_as(deref(pairs[j]))) {
          unifier.bind(own.variable(), pairs[j]);
        }
      }
      continue;
    }
    const Unifier::KeepCircles keep(unifier);
    const Value value = returned.is_closed() ? returned : unifier.fresh_copy(returned);
    (void)unifier.unify(pairs[i], value);
  }
  record_bindings(intention, trail);
}

[[gnu::always_inline]] inline void Agent::finish_means(Intention& intention) {
  const IntendedMeans& done = intention.top();
  const bool was_failure = done.op == TriggerOperator::remove && done.is_goal();
  const std::size_t keeps = done.keeps;
  if ((unusual_ & kGoalStates) != 0 && done.is_goal() && done.op != TriggerOperator::goal_state) {
    signal_end(intention, done);
  }
  pop_means(intention);
  // The means of the goal that failed have stayed until now.
  while (was_failure && intention.stack.size() > keeps) pop_means(intention);
  if (intention.stack.size() < intention.shared) take_over(intention);
  if (intention.is_finished() || intention.is_branch_done() || intention.top().is_finished()) {
    return;
  }
  if (intention.top().returns > 0 && !return_closed_values(intention)) return_values(intention);
  intention.advance();
}

// Finished means are popped and their results handed on.
void Agent::clear_intention(Intention& intention) {
  while (!intention.is_finished() && !intention.is_branch_done() && intention.top().is_finished()) {
    if (intention.top().plan->has_goal_condition) {
      // Not done before the condition holds.
      hold_back(intention);
      erase(circumstance_.running, &intention);
      if (circumstance_.atomic == &intention) circumstance_.atomic = nullptr;
      suspend(intention, Intention::State::waiting, "goal_condition");
      return;
    }
    finish_means(intention);
  }
  // When an atomic plan is done, its intention stays in I for one step more, as in Jason.
  if (intention.is_finished()) drop(intention);
}

}  // namespace jaywalk
