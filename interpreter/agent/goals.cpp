// Goals as wholes: looked for, suspended, ended from outside, with all the means that serve them;
// goal conditions and sub-plans of AgentSpeak(ER).

#include <algorithm>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"

namespace jaywalk {

bool Agent::has_goal(const Intention& intention, Value goal) {
  for (std::size_t i = intention.stack.size(); i > 0; --i) {
    const IntendedMeans& means = intention.stack[i - 1];
    if (means.kind == TriggerKind::achieve && means.op == TriggerOperator::add &&
        machine_.unifier().unify(goal, means.trigger)) {
      return true;
    }
  }
  return false;
}

std::vector<Intention*> Agent::all_intentions() {
  std::vector<Intention*> found;
  const auto add = [&](Intention* intention) {
    if (intention == nullptr || intention->is_finished()) return;
    if (std::find(found.begin(), found.end(), intention) == found.end()) {
      found.push_back(intention);
    }
  };
  // The executing one, those of events, those that act or wait, those that are ready.
  add(executing_);
  const Circumstance& c = circumstance_;
  for (const Event& event : c.events) add(event.intention);
  if (c.atomic_event) add(c.atomic_event->intention);
  for (const Event& event : c.pending_events) add(event.intention);
  for (const auto& intention : c.intentions) {
    if (intention->state != Intention::State::running) add(intention.get());
  }
  add(c.atomic);
  for (Intention* const intention : c.running) add(intention);
  return found;
}

std::vector<Intention*> Agent::intentions_with(Value goal) {
  std::vector<Intention*> found;
  for (Intention* const intention : all_intentions()) {
    const std::size_t trail = machine_.unifier().mark();
    if (has_goal(*intention, goal)) found.push_back(intention);
    machine_.unifier().undo(trail);
  }
  return found;
}

void Agent::drop_goal_events(Value goal) {
  Circumstance& c = circumstance_;
  std::vector<Intention*> orphaned;
  const auto matches = [&](const Event& event) {
    if (event.kind != TriggerKind::achieve || event.op != TriggerOperator::add) return false;
    const std::size_t trail = machine_.unifier().mark();
    const bool found = machine_.unifier().unify(goal, event.literal);
    machine_.unifier().undo(trail);
    if (found && event.intention != nullptr) orphaned.push_back(event.intention);
    if (found) signal_goal_state(event.kind, event.literal, "dropped");
    return found;
  };
  erase_if(c.events, matches);
  std::erase_if(c.pending_events, matches);
  if (c.atomic_event && matches(*c.atomic_event)) c.atomic_event.reset();
  for (Intention* const intention : orphaned) drop(*intention);
}

void Agent::end_means(Intention& intention, std::size_t depth, GoalEnd end) {
  Circumstance& c = circumstance_;
  // Whatever the intention was waiting for is off.
  erase(c.running, &intention);
  if (c.atomic == &intention) c.atomic = nullptr;
  if (intention.is_atomic()) c.atomic_suspended = false;
  const auto is_its = [&](const auto& item) { return item.intention == &intention; };
  erase_if(c.events, is_its);
  std::erase_if(c.pending_events, is_its);
  if (c.atomic_event && c.atomic_event->intention == &intention) c.atomic_event.reset();
  erase_if(c.actions, is_its);
  erase_if(c.feedback, is_its);
  std::erase_if(c.waits, [&](const Wait& wait) {
    if (wait.intention != intention.id) return false;
    if (wait.has_formula) --formula_waits_;
    return true;
  });
  while (intention.stack.size() > depth + 1) pop_means(intention);
  if (end == GoalEnd::fail) {
    const ActionError error{.id = "goal_failed", .message = "", .annots = {}};
    const IntendedMeans& means = intention.top();
    signal_goal_state(means.kind, means.trigger, "failed", "fail_goal");
    if (has_failure_plan(means.kind, means.trigger, means.scope.get())) {
      Event event{TriggerOperator::remove, means.kind, machine_.unifier().apply(means.trigger),
                  &intention, depth};
      add_event(event);
      return;
    }
    if (!post_failure(intention, 0, error, Value(), 0)) drop(intention);
    return;
  }
  const IntendedMeans& done = intention.top();
  signal_goal_state(done.kind, done.trigger, "achieved");
  signal_goal_state(done.kind, done.trigger, "finished");
  pop_means(intention);
  if (intention.is_finished()) {
    drop(intention);
    return;
  }
  if (!intention.top().is_finished()) {
    return_values(intention);
    intention.advance();
  }
  make_ready(intention);
  clear_intention(intention);
}

void Agent::end_goal(Value goal, GoalEnd end, const Intention* except) {
  for (Intention* const intention : all_intentions()) {
    if (intention == except) continue;
    for (std::size_t i = 0; i < intention->stack.size(); ++i) {
      const IntendedMeans& means = intention->stack[i];
      if (means.kind != TriggerKind::achieve || means.op != TriggerOperator::add) continue;
      const std::size_t trail = machine_.unifier().mark();
      const bool found = machine_.unifier().unify(goal, means.trigger);
      machine_.unifier().commit(trail);
      if (!found) continue;
      end_means(*intention, i, end);
      break;
    }
  }
  // Goals that no plan has been chosen for yet.
  Circumstance& c = circumstance_;
  std::vector<Event> ended;
  const auto take = [&](const Event& event) {
    if (event.kind != TriggerKind::achieve || event.op != TriggerOperator::add) return false;
    const std::size_t trail = machine_.unifier().mark();
    const bool found = machine_.unifier().unify(goal, event.literal);
    machine_.unifier().undo(trail);
    if (found) ended.push_back(event);
    return found;
  };
  erase_if(c.events, take);
  std::erase_if(c.pending_events, take);
  for (const Event& event : ended) {
    if (end == GoalEnd::fail) {
      const ActionError error{.id = "goal_failed", .message = "", .annots = {}};
      fail_event(event, error);
    } else if (event.intention != nullptr) {
      go_on(*event.intention);
      clear_intention(*event.intention);
    }
  }
}

void Agent::suspend_goal(Value goal) {
  Circumstance& c = circumstance_;
  for (Intention* const intention : intentions_with(goal)) {
    if (intention->state == Intention::State::running) {
      erase(c.running, intention);
      if (c.atomic == intention) c.atomic = nullptr;
      if (intention != executing_)
        suspend(*intention, Intention::State::suspended, "suspend_ia");
      else
        intention->also_suspended = true;
    } else if (intention->state != Intention::State::in_event) {
      intention->also_suspended = true;
    }
    signal_goal_state(TriggerKind::achieve, goal, "suspended");
  }
  std::vector<Event> moved;
  erase_if(c.events, [&](const Event& event) {
    if (event.kind != TriggerKind::achieve || event.op != TriggerOperator::add) return false;
    const std::size_t trail = machine_.unifier().mark();
    const bool found = machine_.unifier().unify(goal, event.literal) ||
                       (event.intention != nullptr && has_goal(*event.intention, goal));
    machine_.unifier().undo(trail);
    if (found) moved.push_back(event);
    return found;
  });
  c.pending_events.insert(c.pending_events.end(), moved.begin(), moved.end());
}

void Agent::resume_goal(Value goal) {
  Circumstance& c = circumstance_;
  for (Intention* const intention : intentions_with(goal)) {
    if (intention->also_suspended) {
      intention->also_suspended = false;
    } else if (intention->state == Intention::State::suspended) {
      signal_goal_state(TriggerKind::achieve, goal, "resumed");
      make_ready(*intention);
      clear_intention(*intention);
    }
  }
  std::vector<Event> moved;
  std::erase_if(c.pending_events, [&](const Event& event) {
    const std::size_t trail = machine_.unifier().mark();
    const bool found = machine_.unifier().unify(goal, event.literal) ||
                       (event.intention != nullptr && has_goal(*event.intention, goal));
    machine_.unifier().undo(trail);
    if (found) moved.push_back(event);
    return found;
  });
  for (const Event& event : moved) c.events.push_back(event);
}

// Rule ClrSatInt: goals whose condition has come true are achieved.
void Agent::check_goal_conditions() {
  std::vector<Intention*> intentions = all_intentions();
  for (Intention* const intention : intentions) {
    for (std::size_t i = 0; i < intention->stack.size(); ++i) {
      const IntendedMeans& means = intention->stack[i];
      if (!means.plan->has_goal_condition) continue;
      ActionError error;
      machine_.unifier().set_slot_names(means.plan->slot_names);
      const std::size_t trail = machine_.unifier().mark();
      const bool holds = guarded(error, [&] {
        return machine_.solve(means.plan->goal_condition, intention->frame(means));
      });
      machine_.unifier().commit(trail);
      if (!holds) continue;
      end_means(*intention, i, GoalEnd::succeed);
      break;
    }
  }
}

// An external change of belief goes to the sub-plans of goals being pursued, too: for each
// intention the first means from the top that has an applicable one.
void Agent::start_subplan_intentions(const Event& event) {
  if (event.intention != nullptr || event.kind != TriggerKind::belief) return;
  const TriggerKey key = key_of(event);
  for (Intention* const intention : all_intentions()) {
    std::shared_ptr<Scope> scope = intention->is_finished() ? nullptr : intention->top().scope;
    for (; scope != nullptr; scope = scope->outer) {
      if (scope->intention != intention->id) continue;  // an inner intention of its own
      bool had_candidates = false;
      if (try_plans(scope->library->candidates(key), event, scope, had_candidates)) break;
    }
  }
}

}  // namespace jaywalk
