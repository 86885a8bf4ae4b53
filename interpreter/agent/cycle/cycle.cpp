// SPDX-License-Identifier: Apache-2.0
// The reasoning cycle. The functions stand in the order of Jason's semantic rules (Bordini,
// Huebner, Wooldridge 2007, ch. 10) and bear their names; where Jason's interpreter differs from
// the book, it is Jason that is followed:
//
//   sense       ProcMsg
//   deliberate  SelEv → RelPl, ApplPl, SelAppl (found in one go: FindOp) → AddIM
//   act         ProcAct → SelInt → ExecInt (execute.cpp) → ClrInt (clear.cpp)
//
// (The rules from RelPl to SelAppl are in choose_plan.cpp, AddIM in add_means.cpp.) There is one
// shortcut, which leaves nothing out: while an intention is alone (no other is ready, E is empty,
// there is no mail, nothing waits), all of the next cycle up to SelInt is settled. Then that cycle
// goes on with this intention, and the event of its formula goes straight from the formula to the
// plans without passing through E (go_on_alone in execute.cpp):
//
//   cycle n      SelInt   ExecInt  !g(X)           → E
//   cycle n + 1                             SelEv ←┘  RelPl ApplPl SelAppl AddIM, SelInt, ExecInt …
//                                  └──────── next event ───────┘

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/drops.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/agent/goals/goals.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/agent/next_cycle.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/text.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

std::uint64_t Agent::reason(std::uint64_t most) {
  const std::uint64_t first = cycles_;
  last_cycle_ = first + most;
  const bool is_in_nursery = begin_first_cycles();
  (void)work();
  do {
    cycle();
  } while (cycles_ < last_cycle_ && !turn_->has_business && is_active());
  if (is_in_nursery) end_first_cycles();
  rest();
  return cycles_ - first;
}

void Agent::cycle() {
  ++cycles_;
  std::unique_ptr<ActionError> error;
  const bool completed = guarded(error, [&] {
    sense();
    deliberate();
    act();
    return true;
  });
  if (!completed) abandon_cycle(*error);
  tidy_up();
}

void Agent::abandon_cycle(const ActionError& error) {
  log(shortened(error.message, kLongestLogged));
  report_limit(error, executing_ == nullptr ? std::string() : formula_place(*executing_));
  if (executing_ != nullptr && executing_->state != Intention::State::finished) {
    ActionError ignored;  // a goal may be nested too deeply to be printed
    (void)guarded(ignored, [&] {
      (void)note_drop(executing_, error, Value());
      return true;
    });
    drop(*executing_);
  }
  executing_ = nullptr;
  selected_event_ = nullptr;
  if (held_ != nullptr) hold_back(*held_);
  held_ = nullptr;
}

bool Agent::intervene(const std::function<void()>& work, std::string& problem) {
  start_if_due();
  ActionError error;
  const bool completed = guarded(error, [&] {
    work();
    return true;
  });
  if (!completed) {
    machine().unifier().undo(0);
    problem = error.message;
  }
  changed_ = true;
  if (workspace_ == nullptr) borrow_workspace();
  tidy_up();
  rest();
  return completed;
}

// Nothing holds a Value any more but the circumstance and the beliefs.
void Agent::tidy_up() {
  end_cycle();
  if (heap_.wants_collection() || heap_.wants_count()) clean_up();
}

void Agent::sense() {
  // Belief update, then rule ProcMsg: one message a cycle (messages.cpp).
  if (++cycles_since_look_ >= settings_.cycles_per_look) {
    cycles_since_look_ = 0;
    perceive_now();
    seen_mail_ = static_cast<std::uint32_t>(circumstance_.mailbox.size());
  }
  if (seen_mail_ == 0 || circumstance_.mailbox.empty()) return;
  --seen_mail_;
  process_message();
}

void Agent::deliberate() {
  Circumstance& c = circumstance_;
  if (!c.tasks.empty()) Waits(*this).run_tasks();
  if (changed_ && formula_waits_ > 0) Waits(*this).check_formulas();
  // Rule SelEv, for atomic: while an atomic intention exists, only its own events are selected.
  if (c.atomic != nullptr || c.atomic_suspended) return;
  if (c.atomic_event) {
    const Event event = *c.atomic_event;
    c.atomic_event.reset();
    if (event.has_means) {
      make_ready(*event.intention);
    } else if (!find_option(event))
      (void)no_plan(event);
    return;
  }
  // Rule SelEv1: the oldest event. External events without a plan do not cost a cycle.
  while (!c.events.empty()) {
    Event event;
    if (customisation_ != nullptr && customisation_->select_event) {
      if (!take_selected_event(event)) return;
    } else {
      event = c.events.front();
      c.events.pop_front();
    }
    if (event.intention != nullptr) event.intention->has_event = false;
    if (event.has_means) {
      make_ready(*event.intention);
      return;
    }
    if ((unusual_ & kSubplans) != 0) start_branches(event);
    if (find_option(event) || no_plan(event)) return;
  }
  // Rule SelEv2: no event.
}

// Handles an event without a plan. False: another one may be selected in this cycle.
bool Agent::no_plan(const Event& event) {
  if (event.kind != TriggerKind::belief && event.op != TriggerOperator::goal_state) {
    (void)literal_of(event);
    const Event failed = event;  // another one may replace it in the workspace
    const bool had_candidates = work().had_candidates;
    ActionError error;
    error.id = had_candidates ? "no_applicable" : "no_relevant";
    error.message = std::string("Found a goal for which there is no ") +
                    (had_candidates ? "applicable" : "relevant") + " plan: " + trigger_text(failed);
    fail_event(failed, error);
    return true;
  }
  if (event.intention == nullptr) {
    if (settings_.unwanted == ReasoningSettings::Unwanted::discard) return false;
    circumstance_.events.push_back(event);
    return true;
  }
  // The change of belief was all that was wanted.
  go_on(*event.intention);
  clear_intention(*event.intention);
  return true;
}

// Puts the intention's next event into E, before events that have come since.
void Agent::queue_next_event(Intention& intention) {
  NextEvent& next = work().next;
  next.is_pending = false;
  intention.has_event = true;
  try {
    (void)literal_of(next.event);
  } catch (const HeapExhausted&) {
    // The goal's first formula fails for want of memory, where plans for its failure are found.
    const MemoryReserve reserve(heap_);
    (void)literal_of(next.event);
  }
  circumstance_.events.push_front(next.event);
}

// The held intention returns to I if it is ready.
void Agent::release_held() {
  if (!std::exchange(goes_on_, false)) return;
  circumstance_.running.push_back(held_);
  released_ = true;
}

// The intention that is held is not ready any more, and its event is off.
void Agent::hold_back(const Intention& intention) {
  if (&intention != held_) return;
  goes_on_ = false;
  work().next.is_pending = false;
}

void Agent::process_feedback() {
  const Feedback feedback = std::move(circumstance_.feedback.front());
  circumstance_.feedback.pop_front();
  Intention& intention = *feedback.intention;
  if (intention.state != Intention::State::acting) return;
  if (feedback.succeeded) {
    if (intention.also_suspended) {
      resume(intention);
      return;
    }
    go_on(intention);
    clear_intention(intention);
    signal_action_executed(intention, feedback.literal);
    return;
  }
  ActionError error;
  error.id = "action_failed";
  error.message = feedback.reason.empty()
                      ? "action " + brief_text(feedback.literal, symbols_) + " failed"
                      : feedback.reason;
  fail(intention, error);
}

void Agent::signal_action_executed(const Intention& intention, Value action) {
  if (!library_->has_goal_state_plans()) return;
  const Value reason =
      heap_.structure(symbols_.predicate("action_executed", 1), std::span(&action, 1));
  for (std::size_t i = intention.stack.size(); i > 0; --i) {
    const IntendedMeans& means = intention.stack[i - 1];
    if (means.is_goal_addition()) {
      signal_goal_state(means.kind, goal_of(intention, means), "executing", reason);
    }
  }
}

// Rule SelInt: the atomic intention, else the one that has waited longest.
Intention* Agent::select_intention() {
  Circumstance& c = circumstance_;
  if (c.atomic != nullptr) {
    Intention* const atomic = c.atomic;
    c.atomic = nullptr;
    return atomic;
  }
  if (c.atomic_suspended || c.running.empty()) return nullptr;
  if (customisation_ != nullptr && customisation_->select_intention) {
    return take_selected_intention();
  }
  Intention* const first = c.running.front();
  c.running.pop_front();
  return first;
}

void Agent::act() {
  do {
    if (changed_ && goal_conditions_ > 0) Goals(*this).check_conditions();
    changed_ = false;
    // Rule ProcAct
    if (!circumstance_.feedback.empty()) process_feedback();
    // Rule SelInt
    held_ = select_intention();
    released_ = false;
  } while (held_ != nullptr && run(*held_) == Next::selection);
}

}  // namespace jaywalk
