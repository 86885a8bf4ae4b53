// SPDX-License-Identifier: Apache-2.0
// Handles external changes of belief by sub-plans of goals being pursued (AgentSpeak(ER)). As in
// Jason, a branch handles them: an intention with a copy of the goal's stack, so that a failure
// looks for handlers there. When the sub-plan is done, so is the branch; when the failure of one of
// the copied goals has been handled, the branch goes on below that goal and replaces the original
// intention.

#include <algorithm>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/goals.h"

namespace jaywalk {

// For each intention, the first means from the top that has an applicable sub-plan.
void Agent::start_branches(const Event& event) {
  if (event.intention != nullptr || event.kind != TriggerKind::belief) return;
  const TriggerKey key = key_of(event);
  for (Intention* const intention : Goals(*this).all_intentions()) {
    for (std::size_t i = intention->stack.size(); i > intention->shared; --i) {
      const IntendedMeans& means = intention->stack[i - 1];
      if (means.plan->subplans == nullptr) continue;
      // The sub-plan sees the present values of the plan's variables.
      const std::span<const Value> values(intention->frame(means), means.plan->slot_count);
      const std::vector<const Plan*>& plans = means.plan->subplans->candidates(key);
      const auto chosen = std::find_if(plans.begin(), plans.end(), [&](const Plan* plan) {
        return is_applicable(*plan, event, values);
      });
      if (chosen == plans.end()) continue;
      start_branch(*intention, **chosen, event, means.scope());
      break;
    }
  }
}

void Agent::start_branch(Intention& intention, const Plan& plan, const Event& event,
                         const ScopePtr& scope) {
  const std::vector<Value> values = work().frame;
  Intention& branch = copy_for_branch(intention);
  work().frame = values;
  branch.fork = nullptr;
  branch.origin = intention.id;
  branch.shared = branch.stack.size();
  if (observer_ != nullptr) observer_->plan_chosen(*this, plan, event, branch);
  push_means(branch, plan, event, scope);
  Event chosen = event;
  chosen.intention = &branch;
  chosen.has_means = true;
  add_event(chosen);
}

// A copied goal has ended in a branch, which replaces the intention below that goal, unless that
// intention itself is past it.
void Agent::take_over(Intention& branch) {
  const std::size_t count = branch.stack.size();
  Intention* const origin = find_intention(branch.origin);
  branch.shared = 0;
  if (origin == nullptr || origin->fork != nullptr || origin->stack.size() <= count) {
    while (!branch.is_finished()) pop_means(branch);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (origin->stack[i].plan->has_goal_condition) --goal_conditions_;
  }
  origin->forget_bottom(count);
}

}  // namespace jaywalk
