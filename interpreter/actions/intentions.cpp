// SPDX-License-Identifier: Apache-2.0
// Goals and intentions: asked for, ended, suspended.

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/goals.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

// One answer for each event, and each intended means of an intention, the topmost first, that has
// the goal.
class GoalSolutions : public Solutions {
 public:
  GoalSolutions(std::vector<Event> events, std::vector<Intention*> intentions)
      : events_(std::move(events)), intentions_(std::move(intentions)) {}

  bool next(ActionCall& call) override {
    while (event_ < events_.size()) {
      const Event& event = events_[event_++];
      const std::size_t trail = call.unifier().mark();
      // An external event has no intention to name.
      if (call.unify(0, event.literal) && (call.count() < 2 || event.intention == nullptr ||
                                           call.unify(1, Value::number(event.intention->id)))) {
        return true;
      }
      call.unifier().undo(trail);
    }
    for (; intention_ < intentions_.size(); ++intention_, means_ = 0) {
      const Intention& intention = *intentions_[intention_];
      while (means_ < intention.stack.size()) {
        const IntendedMeans& means = intention.stack[intention.stack.size() - ++means_];
        const std::size_t trail = call.unifier().mark();
        if (means.kind == TriggerKind::achieve && means.op == TriggerOperator::add &&
            call.unify(0, call.agent()->goal_of(intention, means)) &&
            (call.count() < 2 || call.unify(1, Value::number(intention.id)))) {
          return true;
        }
        call.unifier().undo(trail);
      }
    }
    return false;
  }

 private:
  std::vector<Event> events_;
  std::vector<Intention*> intentions_;
  std::size_t event_ = 0;
  std::size_t intention_ = 0;
  std::size_t means_ = 0;  // of the current intention, that have been looked at
};

bool is_goal(const Event& event) {
  return event.kind == TriggerKind::achieve && event.op == TriggerOperator::add;
}

bool has_future_goal(Agent& agent, Intention& intention, Value goal) {
  Unifier& unifier = agent.machine().unifier();
  for (std::size_t i = 0; i < intention.stack.size(); ++i) {
    const IntendedMeans& means = intention.stack[i];
    unifier.set_slot_names(means.plan->slot_names);
    const bool is_top = i + 1 == intention.stack.size();
    const Step* step = means.current;
    // Below the top the current step is under way: it waits for the means above it.
    if (!is_top && step != nullptr) step = step->next;
    for (; step != nullptr; step = step->next) {
      if (step->kind != Step::Kind::achieve && step->kind != Step::Kind::achieve_new_focus)
        continue;
      const std::size_t trail = unifier.mark();
      const bool found =
          unifier.unify(goal, unifier.instantiate(step->term, intention.frame(means)));
      unifier.undo(trail);
      if (found) return true;
    }
  }
  return false;
}

// Drops the intentions; the one that executes the action last.
Outcome drop_all(ActionCall& call, const std::vector<Intention*>& intentions) {
  bool own = false;
  const bool tells_states = call.agent()->library().has_goal_state_plans();
  for (Intention* const intention : intentions) {
    // Within a query of the executing intention, that one has to stay.
    if (call.intention() == nullptr && intention == call.agent()->executing()) continue;
    for (std::size_t i = intention->stack.size(); i > 0; --i) {
      const IntendedMeans& means = intention->stack[i - 1];
      if (!means.is_goal_addition() || !tells_states) continue;
      const Value goal = call.agent()->goal_of(*intention, means);
      call.agent()->signal_goal_state(means.kind, goal, "dropped");
      call.agent()->signal_goal_state(means.kind, goal, "finished");
    }
    if (intention == call.intention()) {
      own = true;
    } else {
      call.agent()->drop(*intention);
    }
  }
  // The executing intention last, since the action's arguments end with it.
  if (!own) return Outcome::succeeded;
  call.agent()->drop(*call.intention());
  return Outcome::suspended;
}

void end_goal(ActionCall& call, Goals::End end) {
  Intention* const kept = call.intention() == nullptr ? call.agent()->executing() : nullptr;
  Goals(*call.agent()).end(call.arg(0), end, kept);
}

enum class Variables : std::uint8_t { allowed, refused };

// Whether the first argument can be a goal, as Jason checks it.
bool names_goal(ActionCall& call, Variables variables) {
  const Value goal = call.arg(0);
  if (goal.is_variable()) return variables == Variables::allowed;
  return !goal.is_number() && !goal.is_text() && !goal.is_list();
}

Outcome no_literal(ActionCall& call) { return call.wrong_argument(0, "a literal"); }

Outcome no_pattern(ActionCall& call) {
  return call.wrong_arguments(fmt::format("first argument '{}' must be a literal or variable",
                                          brief_text(call.arg(0), call.symbols())));
}

}  // namespace

Outcome fail(ActionCall& call) {
  if (call.count() == 0) return Outcome::failed;
  for (const Value arg : call.args()) call.error().annots.push_back(deref(arg));
  return call.fail("internal_action", "fail");
}

Outcome intend(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) {
    return call.wrong_argument(0, "a literal or variable");
  }
  std::vector<Intention*> active;
  for (Intention* const intention : Goals(*call.agent()).all_intentions()) {
    if (!intention->is_suspended()) active.push_back(intention);
  }
  return call.many(std::make_unique<GoalSolutions>(std::vector<Event>{}, std::move(active)));
}

Outcome desire(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) {
    return call.wrong_argument(0, "a literal or variable");
  }
  Agent& agent = *call.agent();
  std::vector<Event> events;
  const auto add = [&](const Event& event) {
    if (is_goal(event)) events.push_back(event);
  };
  const Circumstance& c = agent.circumstance();
  // The event that is being handled counts: its plan may ask for its own goal.
  if (agent.selected_event() != nullptr) add(*agent.selected_event());
  for (const Event& event : c.events) add(event);
  if (c.atomic_event) add(*c.atomic_event);
  for (const Event& event : c.pending_events) add(event);
  return call.many(
      std::make_unique<GoalSolutions>(std::move(events), Goals(agent).all_intentions()));
}

Outcome drop_intention(ActionCall& call) {
  if (call.count() == 0) {
    return call.intention() == nullptr ? Outcome::failed : drop_all(call, {call.intention()});
  }
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  return drop_all(call, Goals(*call.agent()).intentions_with(call.arg(0)));
}

Outcome drop_desire(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  Goals(*call.agent()).drop_events(call.arg(0));
  return drop_all(call, Goals(*call.agent()).intentions_with(call.arg(0)));
}

Outcome drop_event(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  Goals(*call.agent()).drop_events(call.arg(0));
  return Outcome::succeeded;
}

Outcome drop_all_intentions(ActionCall& call) {
  std::vector<Intention*> others = Goals(*call.agent()).all_intentions();
  std::erase(others, call.intention());
  // Appointments (.at) would bring goals back.
  Waits(*call.agent()).cancel_schedule();
  return drop_all(call, others);
}

Outcome drop_all_desires(ActionCall& call) {
  const Outcome outcome = drop_all_intentions(call);
  Circumstance& c = call.agent()->circumstance();
  erase_if(c.events, [](const Event& event) { return event.kind == TriggerKind::achieve; });
  c.pending_events.clear();
  return outcome;
}

Outcome drop_all_events(ActionCall& call) {
  Circumstance& c = call.agent()->circumstance();
  c.events.clear();
  c.pending_events.clear();
  return Outcome::succeeded;
}

Outcome drop_future_intention(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  if (call.arg(0).is_variable()) {
    return call.wrong_arguments(fmt::format("first argument '{}' must be a literal",
                                            brief_text(call.arg(0), call.symbols())));
  }
  std::vector<Intention*> found;
  for (Intention* const intention : Goals(*call.agent()).all_intentions()) {
    if (has_future_goal(*call.agent(), *intention, call.arg(0))) found.push_back(intention);
  }
  return drop_all(call, found);
}

Outcome succeed_goal(ActionCall& call) {
  if (!names_goal(call, Variables::refused)) return no_literal(call);
  end_goal(call, Goals::End::succeed);
  return Outcome::succeeded;
}

Outcome fail_goal(ActionCall& call) {
  if (!names_goal(call, Variables::refused)) return no_literal(call);
  end_goal(call, Goals::End::fail);
  return Outcome::succeeded;
}

// The goal of the executing intention: the current one or the named one. In a branch, which handles
// an event by a sub-plan, that of the intention that it branched from.
Outcome done(ActionCall& call) {
  if (call.count() == 1 && !names_goal(call, Variables::refused)) return no_literal(call);
  Agent& agent = *call.agent();
  Intention* const own = call.intention();
  if (own == nullptr || own->is_finished()) return Outcome::failed;
  const bool is_branch = own->shared > 0;
  // A branch shares the lower part of the stack with the intention that it branched from.
  std::optional<std::size_t> depth = is_branch ? own->shared - 1 : own->stack.size() - 1;
  const Value goal = call.count() == 1 ? call.arg(0) : agent.goal_of(*own, own->stack[*depth]);
  const std::size_t trail = call.unifier().mark();
  if (call.count() == 1) depth = Goals(agent).find(*own, goal);
  Intention* ended = own;
  if (is_branch && depth && *depth < own->shared) {
    ended = agent.find_intention(own->origin);
    depth = ended == nullptr ? std::nullopt : Goals(agent).find(*ended, goal);
  }
  call.unifier().undo(trail);
  // Branches of the goal that ends have nothing to return to.
  if (depth && ended == own) {
    for (Intention* const other : Goals(agent).all_intentions()) {
      if (other->origin == own->id) agent.drop(*other);
    }
  }
  if (depth) Goals(agent).end_means(*ended, *depth, Goals::End::succeed);
  if (ended != own) agent.drop(*own);
  return depth || ended != own ? Outcome::suspended : Outcome::succeeded;
}

Outcome suspend(ActionCall& call) {
  Agent& agent = *call.agent();
  Intention* const own = call.intention();
  if (call.count() == 1) {
    if (!names_goal(call, Variables::refused)) return no_literal(call);
    Goals(agent).suspend(call.arg(0));
  }
  if (own == nullptr) return call.count() == 1 ? Outcome::succeeded : Outcome::failed;
  if (call.count() == 1 && !own->also_suspended) return Outcome::succeeded;
  own->also_suspended = false;
  agent.suspend(*own, Intention::State::suspended, "suspend_ia");
  own->suspended_itself = true;
  agent.signal_top_state(*own, "suspended", Waits(agent).reason(*own));
  return Outcome::suspended;
}

Outcome resume(ActionCall& call) {
  if (!names_goal(call, Variables::refused)) return no_literal(call);
  Goals(*call.agent()).resume(call.arg(0));
  return Outcome::succeeded;
}

Outcome suspended(ActionCall& call) {
  if (!is_jason_literal(call.arg(0))) return call.wrong_argument(0, "a literal");
  for (Intention* const intention : Goals(*call.agent()).all_intentions()) {
    const std::size_t trail = call.unifier().mark();
    const bool waits = intention->is_suspended() || intention->state == Intention::State::waiting ||
                       intention->state == Intention::State::acting;
    if (waits && Goals(*call.agent()).has(*intention, call.arg(0)) &&
        call.unify(1, Waits(*call.agent()).reason(*intention))) {
      return Outcome::succeeded;
    }
    call.unifier().undo(trail);
  }
  return Outcome::failed;
}

}  // namespace jaywalk::actions
