// SPDX-License-Identifier: Apache-2.0
// How events come about: most pass through E, that of the formula which is being executed mostly
// does not.

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/agent/next_cycle.h"

namespace jaywalk {

// The event of the formula that is being executed does not pass through E if the next cycle can be
// about nothing else (go_on_alone in execute.cpp).
void Agent::add_event(const Event& event) {
  changed_ = true;
  if (event.intention == nullptr || event.intention != held_ || !comes_next(*held_)) {
    queue_event(event);
    return;
  }
  NextEvent& next = work().next;
  next.event = event;
  const EventCode* const code =
      held_->is_finished() || held_->top().is_finished() ? nullptr : held_->top().step().event;
  const bool is_its = code != nullptr && code->event && is_literal(event.literal) &&
                      *code->event == TriggerKey{event.op, event.kind, predicate_of(event.literal)};
  next.code = is_its ? code : nullptr;
  announce_next_event();
}

void Agent::tell_of_next_event() {
  NextEvent& next = workspace_->next;
  (void)literal_of(next.event);
  observer_->event_posted(*this, next.event);
}

void Agent::queue_event(const Event& event) {
  heap_.note_other_bytes(sizeof(Event));
  if ((unusual_ & kShowsEvents) != 0) observer_->event_posted(*this, event);
  if (!circumstance_.waits.empty()) Waits(*this).check_event(event);
  if (event.op == TriggerOperator::add && event.kind != TriggerKind::belief) {
    signal_goal_state(TriggerKind::achieve, event.literal, "pending");
  }
  if (event.intention != nullptr) {
    event.intention->state = Intention::State::in_event;
    event.intention->has_event = true;
    if (event.intention->is_atomic()) {
      circumstance_.atomic_event = std::make_unique<Event>(event);
      attention_ = true;
      return;
    }
  } else {
    if (event.kind == TriggerKind::belief && (unusual_ & kSubplans) == 0 &&
        settings_.unwanted == ReasoningSettings::Unwanted::discard &&
        (!library_->has_belief_plans() || library_->candidates(key_of(event)).empty())) {
      return;
    }
  }
  circumstance_.events.push_back(event);
}

void Agent::add_goal(Value literal) {
  add_event({TriggerOperator::add, TriggerKind::achieve, literal, nullptr});
}

}  // namespace jaywalk
