// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/surroundings/customisation.h"

#include <cassert>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/term/compare.h"

namespace jaywalk {

bool BeliefRevision::changed(bool something) {
  if (!something) return false;
  focus_ = nullptr;
  changed_ = true;
  return true;
}

bool BeliefRevision::accept() { return kind_ == Kind::add ? add(literal_) : remove(literal_); }
bool BeliefRevision::add(Value literal) { return changed(agent_.believe(literal, place_, focus_)); }
bool BeliefRevision::remove(Value literal) { return changed(agent_.disbelieve(literal, focus_)); }

bool Agent::revise(BeliefRevision::Kind kind, Value literal, Place place, Intention* focus) {
  BeliefRevision revision(*this, kind, with_own_source(literal), place, focus);
  customisation_->revise_beliefs(revision);
  return revision.changed_;
}

// Rule SelEv with a function of the agent's own. False: it chose none.
bool Agent::take_selected_event(Event& event) {
  Ring<Event>& events = circumstance_.events;
  const auto chosen = customisation_->select_event(*this, events);
  if (!chosen || *chosen >= events.size()) return false;
  event = events[*chosen];
  events.erase(events.begin() + static_cast<std::ptrdiff_t>(*chosen));
  return true;
}

// Rule SelInt with a function of the agent's own.
Intention* Agent::take_selected_intention() {
  Ring<Intention*>& ready = circumstance_.running;
  const auto chosen = customisation_->select_intention(*this, ready);
  if (!chosen || *chosen >= ready.size()) return nullptr;
  Intention* const intention = ready[*chosen];
  ready.erase(ready.begin() + static_cast<std::ptrdiff_t>(*chosen));
  return intention;
}

// Rules RelPl and ApplPl for all plans at once, then SelAppl with a function of the agent's own.
bool Agent::select_option(const std::vector<const Plan*>& plans, const Event& event,
                          const ScopePtr& scope) {
  std::vector<Option> options;
  for (const Plan* const plan : plans) {
    work().had_candidates = true;
    find_options(*plan, event, scope, options);
  }
  if (options.empty()) return false;
  const auto chosen = customisation_->select_option(*this, event, options);
  if (!chosen || *chosen >= options.size()) return false;
  intend(options[*chosen], event);
  return true;
}

// Rule AddIM for an option that was found before.
void Agent::intend(Option& option, const Event& event) {
  for (const auto& [variable, value] : option.bindings) variable.variable()->value = value;
  work().binds_event = !option.bindings.empty();
  work().frame = std::move(option.values);
  add_intended_means(*option.plan, event, option.scope);
}

// Adds an option for each solution of a plan's context, with its bindings, which are then undone.
void Agent::find_options(const Plan& plan, const Event& event, const ScopePtr& scope,
                         std::vector<Option>& options) {
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  const std::uint32_t young = heap_.first_young();
  prepare_scratch(plan, scope == nullptr ? std::span<const Value>() : scope->frame);
  Value* const first = work().frame.data();
  Value* const last = first + plan.slot_count;
  const auto note = [&] {
    Option option{.plan = &plan, .values = {first, last}, .scope = scope};
    for (Value* const cell : unifier.bindings_since(trail)) {
      if (cell >= first && cell < last) {
        option.values[static_cast<std::size_t>(cell - first)] = unifier.apply(*cell);
      } else if (machine().is_known_outside(cell, young)) {
        option.bindings.emplace_back(Value::reference(Value::Kind::variable, cell, 0),
                                     unifier.apply(*cell));
      }
    }
    options.push_back(std::move(option));
    return plan.all_unifs;
  };
  ActionError error;
  const bool completed = guarded(error, [&] {
    if (unifier.match(plan.trigger, first, event.literal, Unifier::Direction::template_first)) {
      if (observer_ == nullptr) {
        machine().solve_all(plan.context, first, note);
      } else {
        observer_->plan_relevant(*this, plan, event, {first, plan.slot_count});
        const std::size_t before = options.size();
        machine().solve_all(observer_->context_of(plan), first, note);
        observer_->plan_tried(*this, plan, options.size() > before);
      }
    }
    return true;
  });
  unifier.undo(trail);
  if (!completed) leave_context_at_limit(plan, error, heap_.mark());
}

}  // namespace jaywalk
