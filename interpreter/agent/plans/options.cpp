// SPDX-License-Identifier: Apache-2.0
// Rules RelPl, ApplPl and SelAppl one by one, for agents that choose among their options by rules
// `select__option(Trigger, Intention, Plan, Unifier)`.

#include <array>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"

namespace jaywalk {

// The first option that the rules select. None of them: a goal fails with no_option, where Jason
// loses all events and intentions.
bool Agent::select_by_rules(const Event& event) {
  const TriggerKey key = key_of(event);
  work().had_candidates = false;
  std::vector<Option> options;
  const auto add_all = [&](const PlanLibrary& library, const ScopePtr& scope) {
    for (const Plan* const plan : library.candidates(key)) {
      work().had_candidates = true;
      find_options(*plan, event, scope, options);
    }
  };
  if (event.intention != nullptr && !event.intention->is_finished()) {
    ScopePtr scope = event.intention->top().scope();
    for (; scope != nullptr; scope = scope->outer) add_all(*scope->library, scope);
  }
  add_all(*library_, nullptr);
  for (Option& option : options) {
    if (!is_selected(option, event)) continue;
    intend(option, event);
    return true;
  }
  const bool is_goal = event.kind != TriggerKind::belief && event.op != TriggerOperator::goal_state;
  if (options.empty() || !is_goal) return false;
  ActionError error;
  error.id = "no_option";
  error.message = "selectOption returned null";
  fail_event(event, error);
  return true;
}

bool Agent::is_selected(const Option& option, const Event& event) {
  const Value literal = machine().unifier().apply(event.literal);
  const Value trigger =
      heap_.structure(symbols_.predicate(trigger_operator(event.op, event.kind), 1),
                      std::span(&literal, 1), Value::empty_list(), Form::trigger);
  std::vector<Value> maps;
  for (std::uint32_t i = 0; i < option.plan->own_slots; ++i) {
    const Value value = deref(option.values[i]);
    if (value.is_unset() || value.is_variable()) continue;
    const std::array<Value, 2> args{heap_.variable(option.plan->slot_names[i]), value};
    maps.push_back(heap_.structure(symbols_.predicate("map", 2), args));
  }
  const double intention =
      event.intention == nullptr ? -1.0 : static_cast<double>(event.intention->id);
  const std::array<Value, 4> args{trigger, Value::number(intention), plan_term(*option.plan),
                                  heap_.list(maps)};
  const Value query = heap_.structure(predicates::select_option, args);
  const std::size_t trail = machine().unifier().mark();
  ActionError error;
  const bool selected = guarded(error, [&] { return machine().solve_term(query); });
  machine().unifier().undo(trail);
  return selected;
}

}  // namespace jaywalk
