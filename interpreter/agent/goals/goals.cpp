// SPDX-License-Identifier: Apache-2.0
// Goals as wholes: looked for, suspended, ended from outside, with all the means that serve them;
// goal conditions of AgentSpeak(ER).

#include "interpreter/agent/goals/goals.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

// The bindings stay on the trail.
bool Goals::is_it(const Intention& intention, const IntendedMeans& means, Value goal) {
  if (means.kind != TriggerKind::achieve || means.op != TriggerOperator::add) return false;
  goal = deref(goal);
  const bool differs =
      is_literal(goal) && means.predicate() && *means.predicate() != predicate_of(goal);
  if (differs && means.trigger.is_unset()) return false;
  return agent_.machine().unifier().unify(goal, agent_.goal_of(intention, means));
}

bool Goals::has(const Intention& intention, Value goal) {
  for (std::size_t i = intention.stack.size(); i > 0; --i) {
    const IntendedMeans& means = intention.stack[i - 1];
    if (is_it(intention, means, goal)) return true;
  }
  return false;
}

std::vector<Intention*> Goals::all_intentions() {
  std::vector<Intention*> found;
  const auto add = [&](Intention* intention) {
    if (intention == nullptr || intention->is_finished()) return;
    if (std::find(found.begin(), found.end(), intention) == found.end()) {
      found.push_back(intention);
    }
  };
  // The executing one, those of events, those that act or wait, those that are ready.
  add(agent_.executing());
  const Circumstance& c = agent_.circumstance_;
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

std::vector<Intention*> Goals::intentions_with(Value goal) {
  std::vector<Intention*> found;
  for (Intention* const intention : all_intentions()) {
    const std::size_t trail = agent_.machine().unifier().mark();
    if (has(*intention, goal)) found.push_back(intention);
    agent_.machine().unifier().undo(trail);
  }
  return found;
}

void Goals::drop_events(Value goal) {
  Circumstance& c = agent_.circumstance_;
  std::vector<Intention*> orphaned;
  const auto matches = [&](const Event& event) {
    if (event.kind != TriggerKind::achieve || event.op != TriggerOperator::add) return false;
    const std::size_t trail = agent_.machine().unifier().mark();
    const bool found = agent_.machine().unifier().unify(goal, event.literal);
    agent_.machine().unifier().undo(trail);
    if (found && event.intention != nullptr) orphaned.push_back(event.intention);
    if (found) agent_.signal_goal_state(event.kind, event.literal, "dropped");
    return found;
  };
  erase_if(c.events, matches);
  erase_if(c.pending_events, matches);
  if (c.atomic_event && matches(*c.atomic_event)) c.atomic_event.reset();
  for (Intention* const intention : orphaned) agent_.drop(*intention);
}

// Whatever the intention was waiting for is off.
void Goals::stop_waiting(Intention& intention) {
  Circumstance& c = agent_.circumstance_;
  agent_.hold_back(intention);
  erase(c.running, &intention);
  if (c.atomic == &intention) c.atomic = nullptr;
  if (intention.is_atomic()) c.atomic_suspended = false;
  const auto is_its = [&](const auto& item) { return item.intention == &intention; };
  erase_if(c.events, is_its);
  erase_if(c.pending_events, is_its);
  if (c.atomic_event && c.atomic_event->intention == &intention) c.atomic_event.reset();
  erase_if(c.actions, is_its);
  erase_if(c.acting, is_its);
  erase_if(c.feedback, is_its);
  erase_if(c.waits, [&](const Wait& wait) {
    if (wait.intention != intention.id) return false;
    if (wait.has_formula) --agent_.formula_waits_;
    return true;
  });
  intention.also_suspended = false;
  intention.suspended_itself = false;
}

void Goals::end_means(Intention& intention, std::size_t depth, End end, Value failed,
                      const ActionError* reason) {
  if (depth < intention.shared) {  // the goal is the other intention's, which ends it
    agent_.drop(intention);
    return;
  }
  stop_waiting(intention);
  while (intention.stack.size() > depth + 1) agent_.pop_means(intention);
  if (end == End::fail) {
    fail_top(intention, failed, reason);
    return;
  }
  const IntendedMeans& done = intention.top();
  agent_.signal_end(intention, done);
  agent_.pop_means(intention);
  if (intention.is_finished()) {
    agent_.drop(intention);
    return;
  }
  // No values are returned: the plan has not come to its end.
  if (!intention.is_branch_done() && !intention.top().is_finished()) intention.advance();
  agent_.make_ready(intention);
  agent_.clear_intention(intention);
}

// The goal on top fails from outside. Unlike one whose formula has failed, its means is gone when
// its failure is handled.
void Goals::fail_top(Intention& intention, Value failed, const ActionError* reason) {
  const ActionError error =
      reason != nullptr ? *reason : ActionError{.id = "goal_failed", .message = "", .annots = {}};
  const std::size_t depth = intention.stack.size() - 1;
  const TriggerKind kind = intention.top().kind;
  const Value trigger = agent_.goal_of(intention, intention.top());
  agent_.signal_goal_state(kind, trigger, "failed", "fail_goal");
  agent_.free_goal(intention, depth);
  const Unifier::KeepCircles keep(agent_.machine().unifier());
  if (failed.is_unset()) failed = agent_.machine().unifier().apply(trigger);
  if (reason != nullptr) failed = agent_.failure_literal(failed, error, Value(), 0, nullptr);
  agent_.pop_means(intention);
  const bool is_external = intention.is_finished();
  if (agent_.has_failure_plan(kind, predicate_of(trigger),
                              is_external ? nullptr : intention.top().scope().get())) {
    Intention* const own = is_external ? nullptr : &intention;
    agent_.add_event({TriggerOperator::remove, kind, failed, own, depth});
    if (is_external) agent_.drop(intention);
    return;
  }
  if (is_external || !agent_.post_failure(intention, 0, error, Value(), 0)) agent_.drop(intention);
}

// The topmost says what the goal's variables are, others must be
// like it. The bindings stay on the trail.
std::optional<std::size_t> Goals::find(const Intention& intention, Value goal) {
  std::optional<std::size_t> found;
  for (std::size_t i = intention.stack.size(); i > 0; --i) {
    const IntendedMeans& means = intention.stack[i - 1];
    if (is_it(intention, means, goal)) found = i - 1;
  }
  return found;
}

void Goals::end(Value goal, End end, const Intention* except) {
  Unifier& unifier = agent_.machine().unifier();
  const Unifier::KeepCircles keep(unifier);
  for (Intention* const intention : all_intentions()) {
    if (intention == except || intention->is_finished()) continue;
    const std::size_t trail = unifier.mark();
    const std::optional<std::size_t> depth = find(*intention, goal);
    Value failed;
    if (depth && end == End::fail) {
      unifier.undo(trail);
      agent_.free_goal(*intention, *depth);
      (void)unifier.unify(goal, agent_.goal_of(*intention, intention->stack[*depth]));
      failed = unifier.fresh_copy(goal);
    }
    unifier.undo(trail);
    if (depth) end_means(*intention, *depth, end, failed);
  }
  // Goals that no plan has been chosen for yet.
  Circumstance& c = agent_.circumstance_;
  std::vector<Event> ended;
  const auto take = [&](const Event& event) {
    if (event.kind != TriggerKind::achieve || event.op != TriggerOperator::add) return false;
    const std::size_t trail = unifier.mark();
    const bool found = unifier.unify(goal, event.literal);
    unifier.undo(trail);
    if (found) ended.push_back(event);
    return found;
  };
  erase_if(c.events, take);
  erase_if(c.pending_events, take);
  if (c.atomic_event && take(*c.atomic_event)) c.atomic_event.reset();
  for (const Event& event : ended) {
    if (end == End::fail) {
      const ActionError error{.id = "goal_failed", .message = "", .annots = {}};
      agent_.fail_event(event, error);
    } else {
      agent_.signal_goal_state(event.kind, event.literal, "achieved");
      agent_.signal_goal_state(event.kind, event.literal, "finished");
      if (event.intention == nullptr) continue;
      agent_.go_on(*event.intention);
      agent_.clear_intention(*event.intention);
    }
  }
}

bool Goals::is_pursued(Value goal) const {
  const Circumstance& c = agent_.circumstance_;
  const auto is_it = [&](const auto& item) { return item.literal.same_as(goal); };
  return std::any_of(c.events.begin(), c.events.end(), is_it) ||
         std::any_of(c.pending_events.begin(), c.pending_events.end(), is_it) ||
         (c.atomic_event && is_it(*c.atomic_event)) ||
         std::any_of(c.intentions.begin(), c.intentions.end(), [&](const auto& intention) {
           return std::any_of(
               intention->stack.begin(), intention->stack.end(),
               [&](const IntendedMeans& means) { return means.trigger.same_as(goal); });
         });
}

Value Goals::watch_deadline(Value goal) {
  const LiteralParts parts = literal_parts(goal);
  for (Value a = deref(parts.annots); a.is_pair(); a = deref(a.pair()->tail)) {
    const Value annot = deref(a.pair()->head);
    if (!annot.is_structure() || annot.structure()->predicate() != predicates::hard_deadline) {
      continue;
    }
    double ms = 0;
    if (!agent_.machine().unifier().evaluate(annot.structure()->arg(0), nullptr, ms) || !(ms >= 0))
      break;
    goal = agent_.heap_.structure(parts.predicate, parts.args, parts.annots);
    const std::uint64_t token = agent_.new_token();
    agent_.circumstance_.deadlines.push_back({token, goal});
    agent_.host_.set_timer(agent_, agent_.host_.now_ms() + ms, token);
    break;
  }
  return goal;
}

void Goals::end_late(Value goal) {
  const ActionError error{.id = "deadline_reached", .message = "", .annots = {}};
  for (Intention* const intention : all_intentions()) {
    for (std::size_t i = 0; i < intention->stack.size(); ++i) {
      if (!intention->stack[i].trigger.same_as(goal) || !intention->stack[i].is_goal_addition()) {
        continue;
      }
      end_means(*intention, i, End::fail, Value(), &error);
      break;
    }
  }
  Circumstance& c = agent_.circumstance_;
  std::vector<Event> late;
  const auto take = [&](const Event& event) {
    const bool is_it = event.op == TriggerOperator::add && event.literal.same_as(goal);
    if (is_it) late.push_back(event);
    return is_it;
  };
  erase_if(c.events, take);
  erase_if(c.pending_events, take);
  if (c.atomic_event && take(*c.atomic_event)) c.atomic_event.reset();
  for (const Event& event : late) agent_.fail_event(event, error);
}

// The order in which `.suspend` and `.resume` look at intentions: those that wait for an action,
// then all that wait, then those that are ready, last the executing one.
std::vector<Intention*> Goals::intentions_to_suspend() {
  std::vector<Intention*> found = all_intentions();
  const auto rank = [this](const Intention* intention) {
    if (intention == agent_.executing_) return 3;
    if (intention->state == Intention::State::acting) return 0;
    return intention->state == Intention::State::running ? 2 : 1;
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Intention* a, const Intention* b) { return rank(a) < rank(b); });
  return found;
}

// Running intentions stop; those that wait for something else go on waiting, and stop then. The
// first goal found says what the goal's variables are: no others are suspended.
void Goals::suspend(Value goal) {
  Circumstance& c = agent_.circumstance_;
  const Value reason = Value::atom(agent_.symbols_.predicate("suspend_ia", 0));
  for (Intention* const intention : intentions_to_suspend()) {
    if (intention->state == Intention::State::in_event) continue;  // its event is moved, below
    if (!has(*intention, goal)) continue;
    if (intention == agent_.executing_) {
      intention->also_suspended = true;  // the action itself suspends it
    } else if (intention->state == Intention::State::running) {
      erase(c.running, intention);
      if (c.atomic == intention) c.atomic = nullptr;
      agent_.suspend(*intention, Intention::State::suspended, "suspend_ia");
    } else if (intention->state != Intention::State::suspended) {
      intention->also_suspended = true;
    }
    if (intention != agent_.executing_) agent_.signal_top_state(*intention, "suspended", reason);
  }
  for (const Event& event : take_events_of(c.events, goal)) {
    c.pending_events.push_back(event);
    if (event.op == TriggerOperator::add) {
      agent_.signal_goal_state(event.kind, event.literal, "suspended", reason);
    }
  }
}

// Removes the events for a goal, and those of intentions that have it.
template <class Queue>
std::vector<Event> Goals::take_events_of(Queue& queue, Value goal) {
  std::vector<Event> taken;
  erase_if(queue, [&](const Event& event) {
    const bool is_goal = event.kind == TriggerKind::achieve && event.op == TriggerOperator::add;
    const bool found = (is_goal && agent_.machine().unifier().unify(goal, event.literal)) ||
                       (event.intention != nullptr && has(*event.intention, goal));
    if (found) taken.push_back(event);
    return found;
  });
  return taken;
}

void Goals::resume(Value goal) {
  Circumstance& c = agent_.circumstance_;
  const Value reason = Value::atom(agent_.symbols_.predicate("resume_ia", 0));
  for (Intention* const intention : intentions_to_suspend()) {
    if (!intention->is_suspended() || !has(*intention, goal)) continue;
    agent_.signal_top_state(*intention, "resumed", reason);
    if (intention->also_suspended) {
      intention->also_suspended = false;
      const Value action = Waits(agent_).pending_action(*intention);
      agent_.signal_top_state(*intention, "waiting",
                              action.is_unset() ? Waits(agent_).reason(*intention) : action);
      continue;
    }
    agent_.signal_top_state(*intention, "executing", Value());
    if (intention->suspended_itself) intention->advance();
    intention->suspended_itself = false;
    agent_.make_ready(*intention);
    agent_.clear_intention(*intention);
  }
  for (const Event& event : take_events_of(c.pending_events, goal)) {
    if (event.op == TriggerOperator::add) {
      agent_.signal_goal_state(event.kind, event.literal, "resumed", reason);
      agent_.signal_goal_state(TriggerKind::achieve, event.literal, "pending");
    }
    c.events.push_back(event);
  }
}

// A goal whose condition cannot be decided fails. Otherwise it would be tried in every cycle, in
// silence and for as long as it takes to meet the limit.
void Goals::fail_at_limit(Intention& intention, std::size_t depth, const ActionError& error) {
  const MemoryReserve reserve(agent_.heap_);
  agent_.report_limit(error, formula_place(intention));
  const Value goal = agent_.goal_of(intention, intention.stack[depth]);
  agent_.log(fmt::format("the goal {} fails, since its condition cannot be decided: {}",
                         brief_text(goal, agent_.symbols_), error.message));
  end_means(intention, depth, End::fail, Value(), &error);
}

void Goals::check_conditions() {
  std::vector<Intention*> intentions = all_intentions();
  for (Intention* const intention : intentions) {
    for (std::size_t i = 0; i < intention->stack.size(); ++i) {
      const IntendedMeans& means = intention->stack[i];
      if (!means.plan->has_goal_condition) continue;
      std::unique_ptr<ActionError> error;
      agent_.machine().unifier().set_slot_names(means.plan->slot_names);
      const std::size_t trail = agent_.machine().unifier().mark();
      const bool holds = guarded(error, [&] {
        return agent_.machine().solve(means.plan->goal_condition, intention->frame(means));
      });
      agent_.machine().unifier().commit(trail);
      if (error != nullptr && error->limit != ReachedLimit::none) {
        fail_at_limit(*intention, i, *error);
        break;
      }
      if (!holds) continue;
      end_means(*intention, i, End::succeed);
      break;
    }
  }
}

}  // namespace jaywalk
