// SPDX-License-Identifier: Apache-2.0
#pragma once

// From one reasoning cycle to the next, in line.

#include "interpreter/agent/agent.h"

namespace jaywalk {

[[gnu::always_inline]] inline void Agent::end_cycle() {
  Machine& machine = workspace_->machine;
  if (machine.unifier().mark() != 0) machine.unifier().commit(0);
  machine.forget_temporary_code();
  if (finished_ > 0) forget_finished();
  beliefs_.compact();
}

// Whether the held intention's event can be handled at once: no other work comes before it.
[[gnu::always_inline]] inline bool Agent::comes_next(const Intention& intention) const {
  const Circumstance& c = circumstance_;
  return c.events.empty() && (!attention_ || c.waits.empty()) && !intention.is_atomic() &&
         (unusual_ & kGoalStates) == 0;
}

[[gnu::always_inline]] inline void Agent::announce_next_event() {
  workspace_->next.is_pending = true;
  held_->state = Intention::State::in_event;
  if ((unusual_ & kShowsEvents) != 0) tell_of_next_event();
}

}  // namespace jaywalk
