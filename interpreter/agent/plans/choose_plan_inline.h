#pragma once

// Rules RelPl, ApplPl, SelAppl and AddIM, what nearly every event passes through, in line: plans are
// tried in order, and the means of the first that is applicable is added.

#include <memory>
#include <span>

#include "interpreter/agent/agent.h"
#include "interpreter/logic/machine_inline.h"

namespace jaywalk {

/// The scope of plans that are of the library alone.
inline constinit const std::shared_ptr<Scope> kNoScope;

[[gnu::always_inline]] inline EventArguments Agent::arguments_of(const Event& event) const {
  const Value literal = event.literal;
  if (literal.is_unset()) {
    const NextEvent& next = workspace_->next;
    return {true, next.is_open, next.predicate, {next.args.data(), next.arity}};
  }
  if (literal.is_atom()) return {true, false, literal.atom_id(), {}};
  if (!is_literal(literal)) return {false, true, {}, {}};
  const Structure& structure = *literal.structure();
  return {true, !literal.is_closed(), structure.predicate(), structure.arg_span()};
}

// The formula that has made an event, if that is known.
[[gnu::always_inline]] inline const EventCode* Agent::code_of(const Event& event) const {
  const NextEvent& next = workspace_->next;
  return &event == &next.event ? next.code : nullptr;
}

// The plans that an event may be for: mostly known from its formula.
[[gnu::always_inline]] inline const PlanList& Agent::plans_for(const Event& event,
                                                               const EventCode* code) {
  const bool is_known = code != nullptr && code->library == library_;
  return is_known ? *code->plans : library_->list(key_of(event));
}

// The frame of a plan before its trigger is matched.
[[gnu::always_inline]] inline Value* Agent::empty_frame(const Plan& plan,
                                                        std::uint32_t first_to_clear) {
  std::vector<Value>& scratch = workspace_->frame;
  if (scratch.size() < plan.slot_count) scratch.resize(plan.slot_count);
  Value* const frame = scratch.data();
  for (std::uint32_t i = first_to_clear; i < plan.slot_count; ++i) frame[i] = Value();
  workspace_->machine.unifier().set_slot_names({plan.slot_names.data(), plan.slot_count});
  return frame;
}

// Rules RelPl and ApplPl for one plan, whose values are in the workspace's frame then.
[[gnu::always_inline]] inline bool Agent::applies(const Plan& plan, const Event& event,
                                                  const EventArguments& given,
                                                  std::span<const Value> enclosing) {
  Machine& machine = workspace_->machine;
  Unifier& unifier = machine.unifier();
  const std::size_t trail = unifier.mark();
  std::size_t matched = trail;
  Value* frame = nullptr;
  if (plan.head.tells_goal && given.is_literal && enclosing.empty()) {
    if (plan.head.predicate != given.predicate) return false;
    frame = empty_frame(plan, plan.head.code.first_to_clear());
    const HeadMatch match = machine.match_head_at_once(plan.head.code, frame, given.args.data());
    matched = unifier.mark();
    if (match != HeadMatch::holds) {
      if (matched != trail) unifier.undo(trail);
      if (match == HeadMatch::fails) return false;
      frame = nullptr;
    }
  }
  bool applicable = false;
  if (frame == nullptr || (unusual_ & kObserved) != 0 ||
      !machine.solve_at_once(plan.context, frame, applicable)) {
    applicable = applies_in_general(plan, event, given, enclosing, frame, matched);
  }
  workspace_->binds_event = false;
  if (unifier.mark() == trail) return applicable;
  if (applicable) {
    workspace_->binds_event = given.is_open && is_event_bound(event, matched);
    unifier.commit(trail);
  } else {
    unifier.undo(trail);
  }
  return applicable;
}

// Rules RelPl, ApplPl and SelAppl for plans in order: the first that is applicable, or null.
[[gnu::always_inline]] inline const Plan* Agent::first_applicable(
    const PlanList& plans, const Event& event, std::span<const Value> enclosing) {
  if (!plans.is_short()) {
    workspace_->had_candidates = true;
    return first_indexed(plans, event, enclosing);
  }
  const EventArguments given = arguments_of(event);
  const Value first = given.args.empty() ? Value() : deref(given.args.front());
  for (const Plan* const plan : plans.plans()) {
    if (!evidently_differ(plan->first_argument, first) && applies(*plan, event, given, enclosing)) {
      return plan;
    }
  }
  if (!plans.plans().empty()) workspace_->had_candidates = true;
  return nullptr;
}

// Rule AddIM. The values of the plan's slots are in the workspace's frame.
[[gnu::always_inline]] inline std::span<const Value> Agent::frame_for(const Plan& plan) const {
  return {workspace_->frame.data(), plan.slot_count};
}

[[gnu::always_inline]] inline bool Agent::replaces_caller(const Intention& intention,
                                                          const Event& event) {
  if ((unusual_ & kKeepsCallers) != 0) return false;
  const EventCode* const code = code_of(event);
  const bool is_known = code != nullptr && code->last_call != EventCode::LastCall::unknown;
  return is_known ? code->last_call == EventCode::LastCall::yes : is_last_call(intention, event);
}

[[gnu::always_inline]] inline void Agent::fill_means(Intention& intention, const Plan& plan,
                                                     const Event& event,
                                                     const std::shared_ptr<Scope>& scope) {
  IntendedMeans& means = intention.top();
  means.op = event.op;
  means.kind = event.kind;
  means.trigger = workspace_->binds_event ? settled_literal(event) : event.literal;
  means.keeps = event.keeps;
  if (scope != nullptr || !plan.is_simple) fill_rare(means, scope);
}

[[gnu::always_inline]] inline void Agent::add_means(const Plan& plan, const Event& event,
                                                    const std::shared_ptr<Scope>& scope) {
  Intention& intention = event.intention == nullptr ? new_intention() : *event.intention;
  const bool replaces = event.intention != nullptr && replaces_caller(intention, event);
  if ((unusual_ & (kObserved | kGoalStates)) != 0 || (replaces && intention.top().returns > 0)) {
    announce_means(plan, event, intention, replaces);
  }
  if (replaces) {
    intention.replace(plan, frame_for(plan));
  } else {
    heap_.note_beside(sizeof(IntendedMeans));
    intention.push(plan, frame_for(plan));
  }
  fill_means(intention, plan, event, scope);
  if ((unusual_ & kGoalStates) != 0 && event.op == TriggerOperator::add &&
      event.kind == TriggerKind::achieve) {
    signal_goal_state(event.kind, literal_of(event), "executing");
  }
  stay_ready(intention);
}

// Whether a plan has been chosen and its means added, or the event has failed for another reason.
[[gnu::always_inline]] inline bool Agent::find_usual_option(const Event& event) {
  constexpr std::uint32_t kUnusual =
      kShowsEvents | kCustomised | kSelectsByRules | kSubplans | kLearned;
  workspace_->had_candidates = false;
  selected_event_ = &event;
  bool found = false;
  if ((unusual_ & kUnusual) != 0) {
    found = find_unusual_option(event);
  } else if (const Plan* const chosen =
                 first_applicable(plans_for(event, code_of(event)), event, {})) {
    add_means(*chosen, event, kNoScope);
    found = true;
  }
  selected_event_ = nullptr;
  if (!found && (workspace_->had_candidates || observer_ != nullptr)) note_no_option(event);
  return found;
}

}  // namespace jaywalk
