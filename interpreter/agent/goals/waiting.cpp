// SPDX-License-Identifier: Apache-2.0
// Intentions that wait: for time, for an event, for a formula to hold (`.wait`); tasks that are put
// off to the beginning of the next deliberation; the states of goals.

#include <algorithm>
#include <array>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/goals.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"

namespace jaywalk {

void Waits::start(Intention& intention, Wait wait, double ms) {
  wait.id = agent_.new_token();
  wait.intention = intention.id;
  wait.start_ms = agent_.host_.now_ms();
  wait.ms = ms;
  if (wait.has_formula) ++agent_.formula_waits_;
  agent_.heap_.note_other_bytes(sizeof(Wait));
  agent_.circumstance_.waits.push_back(wait);
  agent_.attention_ = true;
  if (ms >= 0) agent_.host_.set_timer(agent_, wait.start_ms + ms, wait.id);
  agent_.suspend(intention, Intention::State::waiting, "wait");
  if (agent_.library_->has_goal_state_plans()) {
    agent_.signal_top_state(intention, "waiting", reason(intention));
  }
}

Value Waits::pending_action(const Intention& intention) const {
  const Circumstance& c = agent_.circumstance_;
  for (const PendingAction& action : c.actions) {
    if (action.intention == &intention) return action.literal;
  }
  for (const PendingAction& action : c.acting) {
    if (action.intention == &intention) return action.literal;
  }
  for (const Feedback& feedback : c.feedback) {
    if (feedback.intention == &intention) return feedback.literal;
  }
  return {};
}

Value Waits::reason(const Intention& intention) {
  const auto& waits = agent_.circumstance_.waits;
  const auto wait = std::find_if(waits.begin(), waits.end(),
                                 [&](const Wait& each) { return each.intention == intention.id; });
  if (intention.reason != "wait" || wait == waits.end()) {
    return Value::atom(agent_.symbols_.predicate(intention.reason, 0));
  }
  const auto term = [this](std::string_view name, Value arg) {
    return agent_.heap_.structure(agent_.symbols_.predicate(name, 1), std::span(&arg, 1));
  };
  // A time limit is not reported.
  const Value awaited = wait->has_trigger   ? wait->trigger
                        : wait->has_formula ? wait->formula
                                            : term("time", Value::number(wait->ms));
  return with_annotations(agent_.heap_, term("wait", Value::number(intention.id)),
                          agent_.heap_.pair(awaited, Value::empty_list()));
}

void Waits::cancel_schedule() { agent_.circumstance_.scheduled.clear(); }

void Waits::schedule(Event event, double ms) {
  agent_.heap_.require_room();
  agent_.heap_.note_other_bytes(2 * sizeof(Event));
  const std::uint64_t token = agent_.new_token();
  agent_.circumstance_.scheduled.emplace_back(token, event);
  agent_.host_.set_timer(agent_, agent_.host_.now_ms() + ms, token);
}

void Waits::check_event(const Event& event) {
  auto& waits = agent_.circumstance_.waits;
  for (std::size_t i = 0; i < waits.size();) {
    const Wait wait = waits[i];
    Intention* const intention = agent_.find_intention(wait.intention);
    const std::size_t trail = agent_.machine().unifier().mark();
    if (!wait.has_trigger || wait.op != event.op || wait.kind != event.kind ||
        intention == nullptr || !agent_.machine().unifier().unify(wait.trigger, event.literal)) {
      ++i;
      continue;
    }
    agent_.record_bindings(*intention, trail);
    Task task;
    task.wait = wait;
    agent_.circumstance_.tasks.push_back(task);
    agent_.attention_ = true;
    waits.erase(waits.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void Waits::check_formulas() {
  auto& waits = agent_.circumstance_.waits;
  for (std::size_t i = 0; i < waits.size();) {
    const Wait wait = waits[i];
    Intention* const intention = agent_.find_intention(wait.intention);
    if (!wait.has_formula || intention == nullptr) {
      ++i;
      continue;
    }
    ActionError error;
    const std::size_t trail = agent_.machine().unifier().mark();
    if (!guarded(error, [&] { return agent_.machine().solve_term(wait.formula); })) {
      ++i;
      continue;
    }
    agent_.record_bindings(*intention, trail);
    --agent_.formula_waits_;
    waits.erase(waits.begin() + static_cast<std::ptrdiff_t>(i));
    end(wait, false);
  }
}

void Waits::run_tasks() {
  const std::vector<Task> tasks = agent_.circumstance_.tasks.take();
  std::size_t goal_states = 0;
  for (const Task& task : tasks) {
    if (task.kind == Task::Kind::deadline) {
      Goals(agent_).end_late(task.event.literal);
    } else if (task.kind != Task::Kind::goal_state) {
      end(task.wait, task.kind == Task::Kind::time_out);
    } else if (!agent_.library_->candidates(agent_.key_of(task.event)).empty()) {
      // Goal states are handled before other events, in their own order.
      const auto place =
          std::find_if(agent_.circumstance_.events.begin(), agent_.circumstance_.events.end(),
                       [](const Event& event) { return event.op != TriggerOperator::goal_state; });
      agent_.circumstance_.events.insert(place, task.event);
      ++goal_states;
    }
  }
}

void Waits::end(const Wait& wait, bool timed_out) {
  Intention* const intention = agent_.find_intention(wait.intention);
  if (intention == nullptr || intention->state != Intention::State::waiting) return;
  const bool for_something = wait.has_trigger || wait.has_formula;
  if (timed_out && for_something && wait.elapsed.is_unset()) {
    ActionError error;
    error.id = "wait_timeout";
    error.message = "timeout in .wait";
    intention->also_suspended = false;
    agent_.fail(*intention, error);
    return;
  }
  if (!wait.elapsed.is_unset()) {
    const std::size_t trail = agent_.machine().unifier().mark();
    (void)agent_.machine().unifier().unify(wait.elapsed,
                                           Value::number(agent_.host_.now_ms() - wait.start_ms));
    agent_.record_bindings(*intention, trail);
  }
  agent_.signal_top_state(*intention, "executing", Value());
  agent_.resume(*intention);
}

void Agent::timer_fired(std::uint64_t token) {
  if (ask_timed_out(token)) return;
  auto& scheduled = circumstance_.scheduled;
  for (std::size_t i = 0; i < scheduled.size(); ++i) {
    if (scheduled[i].first != token) continue;
    const Event event = scheduled[i].second;
    scheduled.erase(scheduled.begin() + static_cast<std::ptrdiff_t>(i));
    add_event(event);
    return;
  }
  auto& deadlines = circumstance_.deadlines;
  for (std::size_t i = 0; i < deadlines.size(); ++i) {
    if (deadlines[i].token != token) continue;
    Task task;
    task.kind = Task::Kind::deadline;
    task.event.literal = deadlines[i].goal;
    deadlines.erase(deadlines.begin() + static_cast<std::ptrdiff_t>(i));
    circumstance_.tasks.push_back(task);
    attention_ = true;
    return;
  }
  auto& waits = circumstance_.waits;
  const auto found =
      std::find_if(waits.begin(), waits.end(), [&](const Wait& wait) { return wait.id == token; });
  if (found == waits.end()) return;
  Task task;
  task.kind = Task::Kind::time_out;
  task.wait = *found;
  if (found->has_formula) --formula_waits_;
  waits.erase(found);
  circumstance_.tasks.push_back(task);
  attention_ = true;
}

void Agent::add_goal_state(TriggerKind kind, Value goal, std::string_view state,
                           std::string_view reason) {
  signal_goal_state(kind, goal, state,
                    reason.empty() ? Value() : Value::atom(symbols_.predicate(reason, 0)));
}

// state(S)[reason(R)]; where there is no reason, R is an empty text, as in Jason.
void Agent::signal_goal_state(TriggerKind kind, Value goal, std::string_view state, Value reason) {
  if (!library_->has_goal_state_plans() || !is_literal(goal)) return;
  if (reason.is_unset()) reason = heap_.text("");
  const Value why = heap_.structure(symbols_.predicate("reason", 1), std::span(&reason, 1));
  const Value name = Value::atom(symbols_.predicate(state, 0));
  const Value annot = heap_.structure(symbols_.predicate("state", 1), std::span(&name, 1),
                                      heap_.pair(why, Value::empty_list()));
  const Unifier::KeepCircles keep(machine().unifier());
  goal = machine().unifier().fresh_copy(goal);
  const Value all =
      union_of(heap_, literal_parts(goal).annots, heap_.pair(annot, Value::empty_list()), symbols_);
  Task task;
  task.kind = Task::Kind::goal_state;
  task.event = {TriggerOperator::goal_state, kind, with_annotations(heap_, goal, all), nullptr, 0};
  circumstance_.tasks.push_back(task);
  attention_ = true;
}

void Agent::signal_top_state(const Intention& intention, std::string_view state, Value reason) {
  if (intention.is_finished() || !intention.top().is_goal_addition()) return;
  if (!library_->has_goal_state_plans()) return;
  signal_goal_state(intention.top().kind, goal_of(intention, intention.top()), state, reason);
}

}  // namespace jaywalk
