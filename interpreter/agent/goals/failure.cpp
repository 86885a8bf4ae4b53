// SPDX-License-Identifier: Apache-2.0
// What happens when a formula fails or a goal has no plan: Jason looks from the top of the stack
// downwards for a goal that has a plan for its failure, `-!g`, and posts that event on the same
// intention; the failed means stay below until that plan is done. Without one the intention is
// lost.

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/drops.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/text.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

bool Agent::has_failure_plan(TriggerKind kind, Predicate goal, const Scope* scope) {
  const TriggerKey key = trigger_key(TriggerOperator::remove, kind, goal, symbols_);
  for (; scope != nullptr; scope = scope->outer.get()) {
    if (!scope->library->candidates(key).empty()) return true;
  }
  return !library_->candidates(key).empty();
}

// The goal's literal with error(Id), error_msg("..."), code(Formula), code_src and code_line.
Value Agent::failure_literal(Value literal, const ActionError& error, Value code,
                             std::uint32_t line, const Intention* intention) {
  const auto annot = [&](Predicate name, Value arg) {
    return heap_.structure(name, std::span(&arg, 1));
  };
  const Unifier::KeepCircles keep(machine().unifier());
  literal = machine().unifier().apply(literal);
  const bool has_message = std::ranges::any_of(error.annots, [](Value annotation) {
    return annotation.is_structure() &&
           annotation.structure()->predicate() == predicates::error_msg;
  });
  // Goals that come from nowhere in the program have these annotations, too.
  const Value no_code = Value::atom(predicates::no_code);
  const bool has_place = line > 0 && intention != nullptr;
  const Value source = has_place ? heap_.text("file:" + intention->top().plan->file) : no_code;
  // In the order of the set, before `source(self)`, so that little is left to sort.
  std::vector<Value> annots;
  annots.reserve(8);
  annots.push_back(annot(predicates::code, code.is_unset() ? no_code : code));
  annots.push_back(annot(predicates::code_line, has_place ? Value::number(line) : no_code));
  annots.push_back(annot(predicates::code_src, source));
  annots.push_back(annot(predicates::error, Value::atom(symbols_.predicate(error.id, 0))));
  if (!has_message) annots.push_back(annot(predicates::error_msg, heap_.text(error.message)));
  const std::size_t own = annots.size();
  Value rest = append_elements(annots, literal_parts(literal).annots);
  if (annots.size() == own) rest = Value::empty_list();
  annots.insert(annots.end(), error.annots.begin(), error.annots.end());
  return with_annotations(heap_, literal, sorted_set(heap_, std::move(annots), rest, symbols_));
}

namespace {

// Unsets the variables of a term, but not those in their values. Shared parts are visited once,
// since they may occur in very many places.
void free_variables(Value term) {
  std::vector<Value> open{term};
  std::unordered_set<std::uint64_t> seen;
  while (!open.empty()) {
    const Value value = open.back();
    open.pop_back();
    if (value.is_closed() || !seen.insert(value.bits()).second) continue;
    if (value.is_variable()) {
      value.variable()->value = Value();
    } else if (value.is_pair()) {
      open.insert(open.end(), {value.pair()->head, value.pair()->tail});
    } else if (value.is_structure()) {
      const Structure& structure = *value.structure();
      open.insert(open.end(), structure.args(), structure.args() + structure.arity);
      open.push_back(structure.annots());
    }
  }
}

}  // namespace

void Agent::report_limit(const ActionError& error, std::string where) {
  if (error.limit != ReachedLimit::none) host_.limit_reached(*this, error.limit, std::move(where));
}

// Frees the variables of a goal that the body of its means has bound, for the goal's failure plan,
// whose values are returned instead. Bindings by the head or the context stay in the goal, but are
// not returned.
void Agent::free_goal(Intention& intention, std::size_t depth) {
  const IntendedMeans& goal = intention.stack[depth];
  if (!goal.trigger.is_unset()) {
    free_variables(goal.trigger);
  } else {
    for (const HeadStep& step : goal.plan->head.code.steps()) {
      if (step.kind == HeadStep::Kind::first) {
        free_variables(intention.frame(goal)[step.slot]);
      }
    }
  }
  if (depth == 0) return;
  const IntendedMeans& caller = intention.stack[depth - 1];
  const Value* const pairs = intention.frame(caller) + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    const Value copy = pairs[i + 1];  // in a copied agent perhaps the value itself
    if (copy.is_variable() && !deref(copy).is_variable()) copy.variable()->value = Value();
  }
}

// The error with annotations that do not change when variables are freed.
ActionError Agent::applied(ActionError error) {
  for (Value& annot : error.annots) annot = machine().unifier().apply(annot);
  return error;
}

// Looks from the top of the stack down to the means number `floor` for a goal with a plan for its
// failure. As in Jason, the search ends at a change of belief for whose deletion, `-b`, there are
// plans; a plan for a failure, `-!g`, in whose body something below fails is tried again; if it
// fails itself, the goal's caller comes next, or, at the bottom of its intention, the goal again.
bool Agent::post_failure(Intention& intention, std::size_t floor, const ActionError& error,
                         Value code, std::uint32_t line) {
  if (intention.is_finished()) return false;
  std::size_t i = intention.stack.size();
  // A goal without a plan is not on the stack: the topmost means only waits for it.
  bool has_failed =
      intention.top().is_finished() || intention.top().step().kind != Step::Kind::achieve;
  while (i > floor) {
    const IntendedMeans& top = intention.stack[--i];
    const bool is_failure = top.is_goal() && top.op == TriggerOperator::remove;
    if (std::exchange(has_failed, false) && is_failure) {
      i = std::min(top.keeps, i);  // the failed means of that goal are skipped
      if (i > 0) continue;
    }
    const IntendedMeans& means = intention.stack[i];
    const bool has_plan = has_failure_plan(means.kind, *means.predicate(), means.scope().get());
    if (!means.is_goal() && has_plan) return false;
    if (!means.is_goal() || means.op == TriggerOperator::goal_state || !has_plan) continue;
    const ActionError settled = applied(error);
    const std::size_t goal = means.op == TriggerOperator::remove ? std::min(means.keeps, i) : i;
    free_goal(intention, goal);
    const Event event{TriggerOperator::remove, means.kind,
                      failure_literal(goal_of(intention, means), settled, code, line, &intention),
                      &intention, goal};
    // Earlier failures are not kept, so that a goal may be retried without end; nor are terms that
    // filled the memory, which is needed to go on.
    const bool is_kept = !is_failure && error.limit != ReachedLimit::memory;
    const std::size_t kept = std::max({i, std::size_t{1}, intention.shared});
    while (!is_kept && intention.stack.size() > kept) pop_means(intention);
    if (!is_kept) intention.shrink();
    add_event(event);
    return true;
  }
  return false;
}

void Agent::lose(Intention& intention, const ActionError& error, Value code) {
  const DropCause& cause = note_drop(&intention, error, code);
  if (host_.keeps_log() && (error.limit != ReachedLimit::memory || tells_of_memory())) {
    log(fmt::format(
        "{}no failure event was generated: {}{}{}{}{}",
        cause.line == 0 ? "" : fmt::format("{}:{}:{}: ", cause.file, cause.line, cause.column),
        error.id, error.message.empty() ? "" : ": " + shortened(error.message, kLongestLogged),
        code.is_unset() ? "" : " in ", code.is_unset() ? "" : brief_text(code, symbols_),
        drop_details(intention, cause)));
  }
  const bool of_belief = !intention.is_finished() && !intention.top().is_goal();
  if (of_belief && settings_.unwanted == ReasoningSettings::Unwanted::requeue) {
    const IntendedMeans& means = intention.top();
    add_event({means.op, means.kind, goal_of(intention, means), nullptr});
  }
  drop(intention);
}

// The current formula of the intention has failed.
void Agent::fail(Intention& intention, const ActionError& error) {
  if (observer_ != nullptr) observer_->formula_failed(*this, intention, error);
  if (intention.is_atomic()) circumstance_.atomic_suspended = false;
  Value code;
  std::uint32_t line = 0;
  const IntendedMeans& top = intention.top();
  if (!top.is_finished()) {
    const Step& step = top.step();
    line = step.place.line;
    machine().unifier().set_slot_names(top.plan->slot_names);
    ActionError ignored;
    try {
      code = machine().unifier().fresh_copy(
          machine().unifier().instantiate(step.term, intention.frame(top)));
    } catch (const DivisionByZero&) {
      code = Value();
    } catch (const TermTooDeep&) {
      code = Value();
    } catch (const HeapExhausted&) {
      code = Value();
    }
  }
  const std::vector<OpenGoal> goals = open_goals(intention);
  const bool is_handled = fail_stack(intention, error, code, line);
  signal_failure(goals, error, is_handled);
}

namespace {

// The reason that Jason gives for a goal's failure.
std::string_view reason_of(const ActionError& error) {
  if (error.id == "no_relevant") return "no_relevant_plan";
  if (error.id == "no_applicable") return "no_applicable_plan";
  if (error.id.starts_with("body_var")) return "";
  const bool of_formula = error.id == "action_failed" || error.id == "constraint_failed" ||
                          error.id == "test_goal_failed" || error.id == "ask_failed" ||
                          error.id == "wait_timeout" || error.id == "no_option" ||
                          error.id == "belief_revision_failed";
  return of_formula ? std::string_view(error.id) : "ia_failed";
}

}  // namespace

// The goals on the stack, the top first; none if neither observers nor plans need them.
std::vector<Agent::OpenGoal> Agent::open_goals(const Intention& intention) {
  std::vector<OpenGoal> goals;
  if (!library_->has_goal_state_plans()) return goals;
  for (std::size_t i = intention.stack.size(); i > 0; --i) {
    const IntendedMeans& means = intention.stack[i - 1];
    if (means.is_goal_addition()) goals.push_back({means.kind, goal_of(intention, means)});
  }
  return goals;
}

// The first of the goals has failed; the others with it unless some plan is for that.
void Agent::signal_failure(const std::vector<OpenGoal>& goals, const ActionError& error,
                           bool is_handled) {
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const auto& [kind, goal] = goals[i];
    signal_goal_state(kind, goal, "failed", i == 0 ? reason_of(error) : "");
    if (is_handled) {
      signal_goal_state(kind, goal, "executing", "has_failure_plan");
      return;
    }
    signal_goal_state(kind, goal, "finished");
  }
}

bool Agent::fail_stack(Intention& intention, const ActionError& error, Value code,
                       std::uint32_t line) {
  const std::size_t floor = intention.fork == nullptr ? 0 : intention.fork->depth;
  if (post_failure(intention, floor, error, code, line)) return true;
  if (intention.fork != nullptr && leave_failed_branch(intention)) return true;
  if (floor > 0 && post_failure(intention, 0, error, code, line)) return true;
  lose(intention, error, code);
  return false;
}

// No plan for an event.
void Agent::fail_event(const Event& event, const ActionError& error) {
  // Looking for a plan may have used up the memory.
  const MemoryReserve reserve(heap_);
  const bool is_failure = event.op == TriggerOperator::remove;
  if (event.intention == nullptr) {
    const bool is_handled =
        !is_failure && has_failure_plan(event.kind, predicate_of(event.literal), nullptr);
    if (!is_failure) signal_failure({{event.kind, event.literal}}, error, is_handled);
    if (is_handled) {
      add_event({TriggerOperator::remove, event.kind,
                 failure_literal(event.literal, error, event.literal, 0, nullptr), nullptr, 0});
    } else {
      (void)note_drop(nullptr, error, event.literal);
      log(shortened(error.message, kLongestLogged));
    }
    return;
  }
  Intention& intention = *event.intention;
  if (is_failure) {  // a plan for the failure exists, but is not applicable
    (void)note_drop(&intention, error, event.literal);
    log("could not finish intention: " + shortened(error.message, kLongestLogged));
    drop(intention);
    return;
  }
  if (intention.is_atomic()) circumstance_.atomic_suspended = false;
  const std::uint32_t line = intention.top().is_finished() ? 0 : intention.top().step().place.line;
  const Unifier::KeepCircles keep(machine().unifier());
  const Value goal = machine().unifier().fresh_copy(event.literal);
  if (has_failure_plan(event.kind, predicate_of(event.literal), intention.top().scope().get())) {
    signal_failure({{event.kind, event.literal}}, error, true);
    add_event({TriggerOperator::remove, event.kind,
               failure_literal(event.literal, error, goal, line, &intention), &intention,
               intention.stack.size()});
    return;
  }
  std::vector<OpenGoal> goals = open_goals(intention);
  goals.insert(goals.begin(), {event.kind, event.literal});
  const bool is_handled = fail_stack(intention, error, goal, line);
  signal_failure(goals, error, is_handled);
}

void Agent::fail_waiting(Intention& intention, const ActionError& error) { fail(intention, error); }

}  // namespace jaywalk
