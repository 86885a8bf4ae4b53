// SPDX-License-Identifier: Apache-2.0
// The roots of garbage collection: every term that the agent's parts hold.

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/own_parts.h"

namespace jaywalk {

void Agent::collect_garbage() {
  if (own_ != nullptr) forget_removed_plans();
  heap_.collect([this](Heap::Relocator& relocate) { visit_roots(relocate); });
}

void Agent::visit_roots(Heap::Relocator& relocate) {
  Circumstance& c = circumstance_;
  std::vector<BodyCode*> codes;
  // Shared parts are visited once: a Value that has moved must not be moved again.
  std::unordered_set<Scope*> scopes;
  const auto add_code = [&](BodyCode* code) {
    if (code != nullptr && std::find(codes.begin(), codes.end(), code) == codes.end()) {
      codes.push_back(code);
    }
  };
  for (const auto& intention : c.intentions) {
    for (const IntendedMeans& means : intention->stack) {
      if (!means.extras) continue;
      for (const auto& code : means.extras->codes) add_code(code.get());
      Scope* scope = means.extras->scope.get();
      while (scope != nullptr && scopes.insert(scope).second) scope = scope->outer.get();
    }
  }
  const auto visit = [&](Value& value) { relocate(value); };
  beliefs_.visit_terms(visit);
  if (own_ != nullptr) {
    for (const auto& plan : own_->plans) plan->visit_terms(visit);
    for (auto& [plan, label] : own_->labels) visit(label);
  }
  for (BodyCode* code : codes) code->visit_terms(visit);
  for (const auto& intention : c.intentions) intention->visit_terms(visit);
  for (Event& event : c.events) relocate(event.literal);
  if (c.atomic_event) relocate(c.atomic_event->literal);
  for (Event& event : c.pending_events) relocate(event.literal);
  const auto visit_wait = [&](Wait& wait) {
    relocate(wait.trigger);
    relocate(wait.formula);
    relocate(wait.elapsed);
  };
  for (Wait& wait : c.waits) visit_wait(wait);
  for (PendingAsk& ask : c.asks) {
    relocate(ask.answer);
    for (Value& answer : ask.answers) relocate(answer);
  }
  for (Task& task : c.tasks) {
    visit_wait(task.wait);
    relocate(task.event.literal);
  }
  for (auto& [token, event] : c.scheduled) relocate(event.literal);
  for (GoalDeadline& deadline : c.deadlines) relocate(deadline.goal);
  for (Scope* const scope : scopes) {
    for (Value& value : scope->frame) relocate(value);
  }
  for (PendingAction& action : c.actions) relocate(action.literal);
  for (PendingAction& action : c.acting) relocate(action.literal);
  for (Feedback& feedback : c.feedback) relocate(feedback.literal);
  for (Message& message : c.mailbox) relocate(message.content);
  for (Message& message : c.arriving) relocate(message.content);
}

}  // namespace jaywalk
