// The reasoning cycle. The functions stand in the order of Jason's semantic rules (Bordini,
// Huebner, Wooldridge 2007, ch. 10) and bear their names; where Jason's interpreter differs from
// the book, it is Jason that is followed:
//
//   sense       ProcMsg
//   deliberate  SelEv → RelPl, ApplPl, SelAppl (found in one go: FindOp) → AddIM
//   act         ProcAct → SelInt → ExecInt (execute.cpp) → ClrInt (clear.cpp)

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/drops.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/agent/goals.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/agent/waits.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/text.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

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
    ActionError ignored;  // a goal may be nested too deeply to be told
    (void)guarded(ignored, [&] {
      (void)note_drop(executing_, error, Value());
      return true;
    });
    drop(*executing_);
  }
  executing_ = nullptr;
  selected_event_ = nullptr;
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
  tidy_up();
  return completed;
}

void Agent::tidy_up() {
  // Nothing holds a Value any more but the circumstance and the beliefs.
  machine().unifier().commit(0);
  machine().forget_temporary_code();
  if (finished_ > 0) forget_finished();
  beliefs_.compact();
  if (heap_.wants_collection() || heap_.wants_count()) clean_up();
  rest();
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
  bool had_candidates = false;
  if (c.atomic_event) {
    const Event event = *c.atomic_event;
    c.atomic_event.reset();
    if (event.has_means) {
      make_ready(*event.intention);
    } else if (!find_option(event, had_candidates))
      (void)no_plan(event, had_candidates);
    return;
  }
  // Rule SelEv1: the oldest event. External events that nobody wants do not cost a cycle.
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
    if (uses_subplans_) start_branches(event);
    if (find_option(event, had_candidates) || no_plan(event, had_candidates)) return;
  }
  // Rule SelEv2: no event.
}

TriggerKey Agent::key_of(const Event& event) {
  const Predicate predicate =
      is_literal(event.literal) ? predicate_of(event.literal) : predicates::truth;
  return trigger_key(event.op, event.kind, predicate, symbols_);
}

namespace {

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

bool Agent::find_option(const Event& event, bool& had_candidates) {
  const bool has_function = customisation_ != nullptr && customisation_->select_option;
  const Relation* const selecting = beliefs_.find(predicates::select_option);
  const bool by_rules = !has_function && selecting != nullptr && selecting->has_rules();
  selected_event_ = &event;
  if (observer_ != nullptr) observer_->event_selected(*this, event);
  const bool found =
      by_rules ? select_by_rules(event, had_candidates) : find_first_option(event, had_candidates);
  selected_event_ = nullptr;
  // Jason takes the rules one by one for these, and RelPl looks at the triggers.
  const bool is_atomic = event.intention != nullptr && event.intention->is_atomic();
  if (!found && had_candidates && (by_rules || is_atomic)) {
    const TriggerKey key = key_of(event);
    Unifier& unifier = machine().unifier();
    had_candidates = has_relevant(library_->candidates(key), nullptr, event.literal, unifier);
    std::shared_ptr<Scope> scope = is_atomic ? event.intention->top().scope : nullptr;
    for (; scope != nullptr && !had_candidates; scope = scope->outer) {
      had_candidates =
          has_relevant(scope->library->candidates(key), scope.get(), event.literal, unifier);
    }
  }
  if (!found && observer_ != nullptr) observer_->no_plan(*this, event, had_candidates);
  return found;
}

// Rules RelPl, ApplPl and SelAppl: the first plan in the library whose trigger unifies with the
// event's and whose context follows from the beliefs, with the first solution. Goals below a plan
// with sub-plans look there first, then, if none is applicable, further out, last in the agent's
// library.
bool Agent::find_first_option(const Event& event, bool& had_candidates) {
  const TriggerKey key = key_of(event);
  had_candidates = false;
  if (event.intention != nullptr && !event.intention->is_finished()) {
    std::shared_ptr<Scope> scope = event.intention->top().scope;
    for (; scope != nullptr; scope = scope->outer) {
      if (try_plans(scope->library->list(key), event, scope, had_candidates)) return true;
    }
  }
  return try_plans(library_->list(key), event, nullptr, had_candidates);
}

bool Agent::try_plans(const PlanList& plans, const Event& event,
                      const std::shared_ptr<Scope>& scope, bool& had_candidates) {
  if (customisation_ != nullptr && customisation_->select_option) {
    return select_option(plans.plans(), event, scope, had_candidates);
  }
  if (plans.has_learned()) return try_learned(plans, event, scope, had_candidates);
  const Value literal = event.literal;
  const std::uint64_t first_key = literal.is_structure() && literal.structure()->arity > 0
                                      ? argument_key(literal.structure()->arg(0))
                                      : 0;
  had_candidates = had_candidates || !plans.plans().empty();
  return plans.find(first_key, [&](const Plan& plan) { return try_plan(plan, event, scope); });
}

// The frame of a plan before its trigger is matched: a sub-plan has values of the enclosing plan.
void Agent::prepare_scratch(const Plan& plan, std::span<const Value> enclosing) {
  work().frame.assign(plan.slot_count, Value());
  machine().unifier().set_slot_names(plan.slot_names);
  if (enclosing.empty() || plan.inherited.empty()) return;
  const std::vector<Value> values = closed_off(enclosing);
  for (const auto& [own, outer] : plan.inherited) work().frame[own] = values[outer];
}

// Values whose open variables are others: what is bound here is not seen there, nor the reverse.
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

bool Agent::try_plan(const Plan& plan, const Event& event, const std::shared_ptr<Scope>& scope) {
  const std::span<const Value> values = scope == nullptr ? std::span<const Value>() : scope->frame;
  if (!is_applicable(plan, event, values)) return false;
  add_intended_means(plan, event, scope);
  return true;
}

// Rules RelPl and ApplPl for one plan, whose values are in the workspace's frame then.
bool Agent::is_applicable(const Plan& plan, const Event& event, std::span<const Value> enclosing) {
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  const Heap::Mark unused = heap_.mark();
  prepare_scratch(plan, enclosing);
  std::unique_ptr<ActionError> error;
  const bool applicable = guarded(error, [&] {
    return unifier.match(plan.trigger, work().frame.data(), event.literal,
                         Unifier::Direction::template_first) &&
           (observer_ == nullptr ? machine().solve(plan.context, work().frame.data())
                                 : solve_context(plan, event, work().frame.data()));
  });
  if (!applicable) unifier.undo(trail);
  if (error != nullptr) leave_context_at_limit(plan, *error, unused);
  if (!applicable) return false;
  work().binds_event = !event.literal.is_closed() && unifier.mark() != trail;
  unifier.commit(trail);
  return true;
}

// Nothing of what was made while the context was solved is in use.
void Agent::leave_context_at_limit(const Plan& plan, const ActionError& error, Heap::Mark unused) {
  heap_.release(unused);
  const std::string where = "the context of " + plan_name(plan);
  log(fmt::format("in {}: {}", where, shortened(error.message, kLongestLogged)));
  report_limit(error, where);
}

// Rules RelPl and ApplPl for an observer.
bool Agent::solve_context(const Plan& plan, const Event& event, Value* slots) {
  observer_->plan_relevant(*this, plan, event, {slots, plan.slot_count});
  const bool holds = machine().solve(observer_->context_of(plan), slots);
  observer_->plan_tried(*this, plan, holds);
  return holds;
}

// Rule AddIM: a new intention for an external event, else on top of the one that waits for it.
void Agent::add_intended_means(const Plan& plan, const Event& event,
                               const std::shared_ptr<Scope>& scope) {
  Intention& intention = event.intention == nullptr ? new_intention() : *event.intention;
  if (event.intention != nullptr) replace_finished_caller(intention, event);
  if (observer_ != nullptr) observer_->plan_chosen(*this, plan, event, intention);
  push_means(intention, plan, event, scope);
  if (event.op == TriggerOperator::add && event.kind == TriggerKind::achieve) {
    signal_goal_state(event.kind, event.literal, "executing");
  }
  make_ready(intention);
}

void Agent::push_means(Intention& intention, const Plan& plan, const Event& event,
                       const std::shared_ptr<Scope>& scope) {
  heap_.note_beside(sizeof(IntendedMeans));
  IntendedMeans& means = intention.push(plan, work().frame);
  means.op = event.op;
  means.kind = event.kind;
  means.trigger = trigger_of_means(event);
  means.keeps = event.keeps;
  means.scope = scope;
  if (plan.subplans != nullptr) {
    uses_subplans_ = true;
    means.scope =
        std::make_shared<Scope>(Scope{plan.subplans.get(), closed_off(work().frame), scope});
  }
  if (plan.has_goal_condition) {
    ++goal_conditions_;
    changed_ = true;  // it may hold already: then no formula is executed
  }
  if (plan.atomic) circumstance_.atomic_suspended = false;
}

// The event's literal with what the head and the context have given its variables. What is still
// open in it, the body may bind, and a failure frees again (free_goal).
Value Agent::trigger_of_means(const Event& event) {
  if (!work().binds_event) return event.literal;
  work().binds_event = false;
  Value settled;
  try {
    settled = machine().unifier().apply(event.literal);
  } catch (const HeapExhausted&) {
    const MemoryReserve reserve(heap_);
    settled = machine().unifier().apply(event.literal);
  }
  for (GoalDeadline& deadline : circumstance_.deadlines) {
    if (deadline.goal.same_as(event.literal)) deadline.goal = settled;
  }
  return settled;
}

// Tail recursion: a means whose last formula calls the same goal again gives way to the new one.
// Its own caller's open variables live on in the variables that the new means was given.
void Agent::replace_finished_caller(Intention& intention, const Event& event) {
  IntendedMeans& caller = intention.top();
  const bool last = caller.cursor.index + 1 == caller.cursor.body->steps.size() &&
                    caller.outer.empty() && !caller.cursor.is_loop;
  if (!settings_.tail_recursion || !last || event.op != TriggerOperator::add ||
      event.kind == TriggerKind::belief || !caller.is_goal_addition() ||
      caller.kind != event.kind || caller.plan->has_goal_condition ||
      predicate_of(caller.trigger) != predicate_of(event.literal)) {
    return;
  }
  signal_goal_state(caller.kind, caller.trigger, "achieved");
  signal_goal_state(caller.kind, caller.trigger, "finished");
  const Value* const pairs = intention.frame(caller) + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    const Value own = deref(pairs[i]);
    if (own.is_variable()) own.variable()->value = pairs[i + 1];
  }
  intention.pop();
}

// What becomes of an event without a plan. False: another one may be selected in this cycle.
bool Agent::no_plan(const Event& event, bool had_candidates) {
  if (event.kind != TriggerKind::belief && event.op != TriggerOperator::goal_state) {
    ActionError error;
    error.id = had_candidates ? "no_applicable" : "no_relevant";
    error.message = std::string("Found a goal for which there is no ") +
                    (had_candidates ? "applicable" : "relevant") + " plan: " + trigger_text(event);
    fail_event(event, error);
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

void Agent::act() {
  if (changed_ && goal_conditions_ > 0) Goals(*this).check_conditions();
  changed_ = false;
  // Rule ProcAct
  if (!circumstance_.feedback.empty()) process_feedback();
  // Rules SelInt and ExecInt
  Intention* const intention = select_intention();
  if (intention == nullptr) return;
  executing_ = intention;
  execute(*intention);
  changed_ = true;
  // Rule ClrInt; what suspends itself by its last formula is not done before it is resumed.
  if (intention->state != Intention::State::finished &&
      intention->state != Intention::State::suspended) {
    clear_intention(*intention);
  }
  executing_ = nullptr;
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
                      ? "action " + term_text(feedback.literal, symbols_) + " failed"
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
      signal_goal_state(means.kind, means.trigger, "executing", reason);
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

}  // namespace jaywalk
