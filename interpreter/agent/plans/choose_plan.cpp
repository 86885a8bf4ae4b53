// SPDX-License-Identifier: Apache-2.0
// Rules RelPl, ApplPl, SelAppl and AddIM: which plan is for an event, and its means. Heads are
// matched with the event's arguments as those of rules with a query's (logic/code/head_code.h);
// triggers that are variables, or have annotations, by the unifier with the event's literal.

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/logic/machine_inline.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/text.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

constinit const ScopePtr kNoScope;  // of the library alone

[[gnu::always_inline]] inline EventArguments arguments_of(const Event& event,
                                                          const NextEvent& next) {
  const Value literal = event.literal;
  if (literal.is_unset()) {
    return {true, next.is_open, next.predicate, {next.args.data(), next.arity}};
  }
  if (literal.is_atom()) return {true, false, literal.atom_id(), {}};
  if (!is_literal(literal)) return {false, true, {}, {}};
  const Structure& structure = *literal.structure();
  return {true, !literal.is_closed(), structure.predicate(), structure.arg_span()};
}

// The formula that has made an event, if that is known.
[[gnu::always_inline]] inline const EventCode* code_of(const Event& event, const NextEvent& next) {
  return &event == &next.event ? next.code : nullptr;
}

// Whether the context has bound a variable of an open event; values bound by the head reach the
// goal from there (goal_of), unless its literal has been made.
bool is_event_bound(const Event& event, std::size_t matched, const Workspace& workspace) {
  if (!event.literal.is_unset()) return true;
  const std::vector<Value>& frame = workspace.frame;
  const auto bound = workspace.machine.unifier().bindings_since(matched);
  return std::any_of(bound.begin(), bound.end(), [&](const Value* cell) {
    return cell < frame.data() || cell >= frame.data() + frame.size();
  });
}

// Whether the trigger of one of the plans unifies with the event's literal.
bool has_relevant(const std::vector<const Plan*>& plans, const Scope* scope, Value literal,
                  Unifier& unifier) {
  return std::any_of(plans.begin(), plans.end(), [&](const Plan* plan) {
    const std::size_t trail = unifier.mark();
    std::vector<Value> slots(plan->slot_count);
    if (scope != nullptr) {
      for (const auto& [own, outer] : plan->inherited) slots[own] = scope->frame[outer];
    }
    const bool unifies =
        unifier.match(plan->trigger, slots.data(), literal, Unifier::Direction::template_first);
    unifier.undo(trail);
    return unifies;
  });
}

}  // namespace

TriggerKey Agent::key_of(const Event& event) {
  if (event.literal.is_unset()) {
    return trigger_key(event.op, event.kind, work().next.predicate, symbols_);
  }
  const Predicate predicate =
      is_literal(event.literal) ? predicate_of(event.literal) : predicates::truth;
  return trigger_key(event.op, event.kind, predicate, symbols_);
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

// The frame of a sub-plan, which has values of the enclosing plan.
Value* Agent::prepare_scratch(const Plan& plan, std::span<const Value> enclosing) {
  Value* const frame = empty_frame(plan, 0);
  if (enclosing.empty() || plan.inherited.empty()) return frame;
  const std::vector<Value> values = closed_off(enclosing);
  for (const auto& [own, outer] : plan.inherited) frame[own] = values[outer];
  return frame;
}

// Copies of values with fresh unbound variables: bindings on one side are not seen on the other.
std::vector<Value> Agent::closed_off(std::span<const Value> values) {
  std::vector<Value> copies(values.begin(), values.end());
  const auto is_closed = [](Value value) { return value.is_unset() || value.is_closed(); };
  if (std::all_of(values.begin(), values.end(), is_closed)) return copies;
  for (Value& value : copies) {
    if (value.is_unset()) value = Value::empty_list();
  }
  Value list = machine().unifier().fresh_copy(heap_.list(copies));
  for (std::size_t i = 0; i < copies.size(); ++i, list = deref(list.pair()->tail)) {
    copies[i] = values[i].is_unset() ? Value() : deref(list.pair()->head);
  }
  return copies;
}

// A limit has been met while the trigger was matched or the context was solved. REQUIRES: called
// from a handler.
void Agent::leave_plan_at_limit(const Plan& plan, std::size_t trail, Heap::Mark unused) {
  const ActionError error = error_of_limit();
  machine().unifier().undo(trail);  // before the terms that are bound are released
  leave_context_at_limit(plan, error, unused);
}

// Releases all terms that were made while the context was solved: none of them is in use.
void Agent::leave_context_at_limit(const Plan& plan, const ActionError& error, Heap::Mark unused) {
  heap_.release(unused);
  const std::string where = "the context of " + plan_name(plan);
  log(fmt::format("in {}: {}", where, shortened(error.message, kLongestLogged)));
  report_limit(error, where);
}

// Rule ApplPl for a relevant plan, with an observer.
bool Agent::observed_context_holds(const Plan& plan, const Event& event, Value* frame) {
  observer_->plan_relevant(*this, plan, event, {frame, plan.slot_count});
  const bool found = machine().solve_context(observer_->context_of(plan), frame);
  observer_->plan_tried(*this, plan, found);
  return found;
}

// Rule RelPl for one plan: whether its trigger matches the event. Its variables get their values in
// the frame. The event's literal is made if the frame loses something of it.
bool Agent::is_relevant(const Plan& plan, const Event& event, const EventArguments& given,
                        Value* frame) {
  Machine& machine = workspace_->machine;
  if (!plan.head.is_decoded || !given.is_literal) {
    return machine.unifier().match(plan.trigger, frame, event.literal,
                                   Unifier::Direction::template_first);
  }
  if (plan.head.predicate != given.predicate) return false;
  if (!machine.match_head(plan.head.code, frame, given.args.data())) return false;
  if (machine.has_lost_annotations()) keep_literal(event);
  return true;
}

// Rules RelPl and ApplPl for one plan; the head has been matched if there is a frame. `matched`
// receives how much was bound when it had been.
bool Agent::applies_in_general(const Plan& plan, const Event& event, const EventArguments& given,
                               std::span<const Value> enclosing, Value* frame,
                               std::size_t& matched) {
  const bool has_matched = frame != nullptr;
  if (!has_matched) {
    if (!plan.head.tells_goal || !enclosing.empty()) (void)literal_of(event);
    frame = prepare_scratch(plan, enclosing);
  }
  Machine& machine = workspace_->machine;
  const Heap::Mark unused = heap_.mark();
  const std::size_t trail = machine.unifier().mark();
  bool applicable = false;
  try {
    if (has_matched || is_relevant(plan, event, given, frame)) {
      matched = machine.unifier().mark();
      applicable = (unusual_ & kObserved) == 0 ? machine.solve_context(plan.context, frame)
                                               : observed_context_holds(plan, event, frame);
    }
  } catch (...) {
    leave_plan_at_limit(plan, trail, unused);
  }
  return applicable;
}

// Whether an event that had candidates had relevant plans. Jason takes the rules one by one for
// atomic intentions and where options are selected by rules, and RelPl looks at the triggers.
bool Agent::were_relevant(const Event& event) {
  const bool is_atomic = event.intention != nullptr && event.intention->is_atomic();
  if (!is_atomic && !selects_by_rules()) return true;
  const TriggerKey key = key_of(event);
  const Value literal = literal_of(event);
  Unifier& unifier = machine().unifier();
  if (has_relevant(library_->candidates(key), nullptr, literal, unifier)) return true;
  ScopePtr scope = is_atomic ? event.intention->top().scope() : nullptr;
  for (; scope != nullptr; scope = scope->outer) {
    if (has_relevant(scope->library->candidates(key), scope.get(), literal, unifier)) return true;
  }
  return false;
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
    workspace_->binds_event = given.is_open && is_event_bound(event, matched, *workspace_);
    unifier.commit(trail);
  } else {
    unifier.undo(trail);
  }
  return applicable;
}

bool Agent::is_applicable(const Plan& plan, const Event& event, std::span<const Value> enclosing) {
  return applies(plan, event, arguments_of(event, workspace_->next), enclosing);
}

const Plan* Agent::first_indexed(const PlanList& plans, const Event& event,
                                 std::span<const Value> enclosing) {
  const EventArguments given = arguments_of(event, workspace_->next);
  const std::uint64_t key = given.args.empty() ? 0 : argument_key(given.args.front());
  return plans.find(key, [&](const Plan& plan) { return is_applicable(plan, event, enclosing); });
}

// Rules RelPl, ApplPl and SelAppl for plans in order: the first that is applicable, or null.
[[gnu::always_inline]] inline const Plan* Agent::first_applicable(
    const PlanList& plans, const Event& event, std::span<const Value> enclosing) {
  if (!plans.is_short()) {
    workspace_->had_candidates = true;
    return first_indexed(plans, event, enclosing);
  }
  const EventArguments given = arguments_of(event, workspace_->next);
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
std::span<const Value> Agent::frame_for(const Plan& plan) const {
  return {workspace_->frame.data(), plan.slot_count};
}

[[gnu::always_inline]] inline bool Agent::replaces_caller(const Intention& intention,
                                                          const Event& event) {
  if ((unusual_ & kKeepsCallers) != 0) return false;
  const EventCode* const code = code_of(event, workspace_->next);
  const bool is_known = code != nullptr && code->last_call != EventCode::LastCall::unknown;
  return is_known ? code->last_call == EventCode::LastCall::yes : is_last_call(intention, event);
}

[[gnu::always_inline]] inline void Agent::fill_means(Intention& intention, const Plan& plan,
                                                     const Event& event, const ScopePtr& scope) {
  IntendedMeans& means = intention.top();
  means.op = event.op;
  means.kind = event.kind;
  means.trigger = workspace_->binds_event ? settled_literal(event) : event.literal;
  means.keeps = event.keeps;
  if (scope != nullptr || !plan.is_simple) fill_rare(means, scope);
}

[[gnu::always_inline]] inline void Agent::add_means(const Plan& plan, const Event& event,
                                                    const ScopePtr& scope) {
  Intention& intention = event.intention == nullptr ? new_intention() : *event.intention;
  const bool replaces = event.intention != nullptr && replaces_caller(intention, event);
  if ((unusual_ & (kObserved | kGoalStates)) != 0 || (replaces && intention.top().returns > 0)) {
    announce_means(plan, event, intention, replaces);
  }
  if (replaces) {
    intention.replace(plan, frame_for(plan));
  } else {
    heap_.note_other_bytes(sizeof(IntendedMeans));
    intention.push(plan, frame_for(plan));
  }
  fill_means(intention, plan, event, scope);
  if ((unusual_ & kGoalStates) != 0 && event.op == TriggerOperator::add &&
      event.kind == TriggerKind::achieve) {
    signal_goal_state(event.kind, literal_of(event), "executing");
  }
  stay_ready(intention);
}

bool Agent::try_plans(const PlanList& plans, const Event& event, const ScopePtr& scope) {
  if (customisation_ != nullptr && customisation_->select_option) {
    return select_option(plans.plans(), event, scope);
  }
  if (plans.has_learned()) return try_learned(plans, event, scope);
  const Plan* const chosen =
      first_applicable(plans, event, scope == nullptr ? std::span<const Value>() : scope->frame);
  if (chosen != nullptr) add_intended_means(*chosen, event, scope);
  return chosen != nullptr;
}

void Agent::note_no_option(const Event& event) {
  if (work().had_candidates && !were_relevant(event)) work().had_candidates = false;
  if (observer_ != nullptr) observer_->no_plan(*this, event, work().had_candidates);
}

inline bool Agent::selects_by_rules() {
  if ((unusual_ & kSelectsByRules) == 0) return false;
  const Relation* const selecting = beliefs_.find(predicates::select_option);
  return selecting != nullptr && selecting->has_rules();
}

// For observed agents, for agents that select options in another way, and for goals below a plan
// with sub-plans: these are searched first, then, if none is applicable, the plans further out, and
// last the agent's library.
bool Agent::find_unusual_option(const Event& event) {
  const bool by_rules = selects_by_rules();
  if (by_rules || (unusual_ & (kShowsEvents | kCustomised)) != 0) (void)literal_of(event);
  if ((unusual_ & kShowsEvents) != 0) observer_->event_selected(*this, event);
  if (by_rules) return select_by_rules(event);
  const Intention* const intention = event.intention;
  const bool is_below = intention != nullptr && !intention->is_finished();
  ScopePtr scope = is_below ? intention->top().scope() : nullptr;
  for (; scope != nullptr; scope = scope->outer) {
    if (try_plans(scope->library->list(key_of(event)), event, scope)) return true;
  }
  return try_plans(plans_for(event, code_of(event, workspace_->next)), event, nullptr);
}

void Agent::push_means(Intention& intention, const Plan& plan, const Event& event,
                       const ScopePtr& scope) {
  heap_.note_other_bytes(sizeof(IntendedMeans));
  intention.push(plan, frame_for(plan));
  fill_means(intention, plan, event, scope);
}

void Agent::add_intended_means(const Plan& plan, const Event& event, const ScopePtr& scope) {
  add_means(plan, event, scope);
}

// Whether a plan has been chosen and its means added, or the event has failed for another reason.
bool Agent::find_option(const Event& event) {
  constexpr std::uint32_t kUnusual =
      kShowsEvents | kCustomised | kSelectsByRules | kSubplans | kLearned;
  workspace_->had_candidates = false;
  selected_event_ = &event;
  bool found = false;
  if ((unusual_ & kUnusual) != 0) {
    found = find_unusual_option(event);
  } else if (const Plan* const chosen =
                 first_applicable(plans_for(event, code_of(event, workspace_->next)), event, {})) {
    add_means(*chosen, event, kNoScope);
    found = true;
  }
  selected_event_ = nullptr;
  if (!found && (workspace_->had_candidates || observer_ != nullptr)) note_no_option(event);
  return found;
}

}  // namespace jaywalk
