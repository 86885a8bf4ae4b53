// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/surroundings/observer.h"

#include <algorithm>

#include "interpreter/program/plan.h"

namespace jaywalk {

bool Observers::interrupted() {
  return std::ranges::any_of(all_, [](ReasoningObserver* each) { return each->interrupted(); });
}

bool Observers::wants_events() const {
  return std::ranges::any_of(all_, [](ReasoningObserver* each) { return each->wants_events(); });
}

const Goal* Observers::context_of(const Plan& plan) {
  for (ReasoningObserver* const each : all_) {
    const Goal* const context = each->context_of(plan);
    if (context != plan.context) return context;
  }
  return plan.context;
}

const RuleCode& Observers::rule_for(const RuleCode& rule) {
  for (ReasoningObserver* const each : all_) {
    const RuleCode& own = each->rule_for(rule);
    if (&own != &rule) return own;
  }
  return rule;
}

// Observers without compiled contexts and rules return 0.
std::size_t Observers::condition_asked(Agent& agent, std::size_t number,
                                       std::span<const Value> variables) {
  std::size_t asking = 0;
  for (ReasoningObserver* const each : all_) {
    asking = std::max(asking, each->condition_asked(agent, number, variables));
  }
  return asking;
}

void Observers::condition_answered(Agent& agent, std::size_t number, std::size_t asking) {
  for (ReasoningObserver* const each : all_) each->condition_answered(agent, number, asking);
}

void Observers::event_selected(Agent& agent, const Event& event) {
  for (ReasoningObserver* const each : all_) each->event_selected(agent, event);
}

void Observers::plan_relevant(Agent& agent, const Plan& plan, const Event& event,
                              std::span<const Value> slots) {
  for (ReasoningObserver* const each : all_) each->plan_relevant(agent, plan, event, slots);
}

void Observers::plan_tried(Agent& agent, const Plan& plan, bool applicable) {
  for (ReasoningObserver* const each : all_) each->plan_tried(agent, plan, applicable);
}

void Observers::option_drawn(Agent& agent, const LearnedChoice& choice, const DrawnOption& drawn) {
  for (ReasoningObserver* const each : all_) each->option_drawn(agent, choice, drawn);
}

void Observers::plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                            const Intention& intention) {
  for (ReasoningObserver* const each : all_) each->plan_chosen(agent, plan, event, intention);
}

void Observers::no_plan(Agent& agent, const Event& event, bool had_candidates) {
  for (ReasoningObserver* const each : all_) each->no_plan(agent, event, had_candidates);
}

void Observers::formula_executes(Agent& agent, const Intention& intention, const Step& step) {
  for (ReasoningObserver* const each : all_) each->formula_executes(agent, intention, step);
}

void Observers::formula_failed(Agent& agent, const Intention& intention, const ActionError& error) {
  for (ReasoningObserver* const each : all_) each->formula_failed(agent, intention, error);
}

void Observers::event_posted(Agent& agent, const Event& event) {
  for (ReasoningObserver* const each : all_) each->event_posted(agent, event);
}

}  // namespace jaywalk
