// What happens when a formula fails or a goal has no plan: Jason looks from the top of the stack
// downwards for a goal that has a plan for its failure, `-!g`, and posts that event on the same
// intention; the failed means stay below until that plan is done. Without one the intention is
// lost.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

bool Agent::has_failure_plan(TriggerKind kind, Value literal, const Scope* scope) {
  const TriggerKey key =
      trigger_key(TriggerOperator::remove, kind, literal_parts(literal).predicate, symbols_);
  for (; scope != nullptr; scope = scope->outer.get()) {
    if (!scope->library->candidates(key).empty()) return true;
  }
  return !library_->candidates(key).empty();
}

// The goal's literal with error(Id), error_msg("..."), code(Formula), code_src and code_line.
Value Agent::failure_literal(Value literal, const ActionError& error, Value code,
                             std::uint32_t line) {
  const auto annot = [&](std::string_view name, Value arg) {
    return heap_.structure(symbols_.predicate(name, 1), std::span(&arg, 1));
  };
  std::vector<Value> annots = error.annots;
  annots.push_back(annot("error", Value::atom(symbols_.predicate(error.id, 0))));
  const Predicate message = symbols_.predicate("error_msg", 1);
  const bool has_message = std::any_of(annots.begin(), annots.end(), [&](Value annotation) {
    return annotation.is_structure() && annotation.structure()->predicate() == message;
  });
  if (!has_message) annots.push_back(annot("error_msg", heap_.text(error.message)));
  annots.push_back(
      annot("code", code.is_unset() ? Value::atom(symbols_.predicate("no_code", 0)) : code));
  if (line > 0) {
    annots.push_back(annot("code_src", heap_.text("file:" + program_->name() + ".asl")));
    annots.push_back(annot("code_line", Value::number(line)));
  }
  const Value set = sorted_set(heap_, heap_.list(annots), symbols_);
  literal = machine_.unifier().apply(literal);
  return with_annotations(heap_, literal,
                          union_of(heap_, literal_parts(literal).annots, set, symbols_));
}

// Looks from the top of the stack down to the means number `floor` for a goal with a plan for its
// failure.
bool Agent::post_failure(Intention& intention, std::size_t floor, const ActionError& error,
                         Value code, std::uint32_t line) {
  std::size_t i = intention.stack.size();
  while (i > floor) {
    const IntendedMeans& means = intention.stack[--i];
    if (!means.is_goal()) continue;
    if (means.op == TriggerOperator::remove) {
      i = std::min(means.keeps, i);  // the failed means of that goal are skipped
      continue;
    }
    if (means.op != TriggerOperator::add ||
        !has_failure_plan(means.kind, means.trigger, means.scope.get())) {
      continue;
    }
    add_event({TriggerOperator::remove, means.kind,
               failure_literal(means.trigger, error, code, line), &intention, i});
    return true;
  }
  return false;
}

void Agent::lose(Intention& intention, const ActionError& error, Value code) {
  std::string place;
  std::uint32_t line = 0;
  if (!intention.is_finished() && !intention.top().cursor.at_end()) {
    line = intention.top().step().line;
    place = intention.top().plan->file;
  }
  log(fmt::format("{}{}no failure event was generated: {}{}{}{}",
                  place.empty() ? "" : fmt::format("{}:{}: ", place, line), "", error.id,
                  error.message.empty() ? "" : ": " + error.message, code.is_unset() ? "" : " in ",
                  code.is_unset() ? "" : term_text(code, symbols_)));
  drop(intention);
}

// The current formula of the intention has failed.
void Agent::fail(Intention& intention, const ActionError& error) {
  if (intention.is_atomic()) circumstance_.atomic_suspended = false;
  if (intention.top().is_goal_addition()) {
    signal_goal_state(intention.top().kind, intention.top().trigger, "failed", error.id);
  }
  Value code;
  std::uint32_t line = 0;
  const IntendedMeans& top = intention.top();
  if (!top.cursor.at_end()) {
    const Step& step = top.step();
    line = step.line;
    machine_.unifier().set_slot_names(top.plan->slot_names);
    ActionError ignored;
    try {
      code = machine_.unifier().fresh_copy(
          machine_.unifier().instantiate(step.term, intention.frame(top)));
    } catch (const DivisionByZero&) {
      code = Value();
    } catch (const TermTooDeep&) {
      code = Value();
    } catch (const HeapExhausted&) {
      code = Value();
    }
  }
  fail_stack(intention, error, code, line);
}

void Agent::fail_stack(Intention& intention, const ActionError& error, Value code,
                       std::uint32_t line) {
  const std::size_t floor = intention.fork == nullptr ? 0 : intention.fork->depth;
  if (post_failure(intention, floor, error, code, line)) return;
  if (intention.fork != nullptr && leave_failed_branch(intention)) return;
  if (floor == 0 || !post_failure(intention, 0, error, code, line)) lose(intention, error, code);
}

// No plan for an event.
void Agent::fail_event(const Event& event, const ActionError& error) {
  const bool is_failure = event.op == TriggerOperator::remove;
  if (event.intention == nullptr) {
    if (!is_failure) signal_goal_state(event.kind, event.literal, "failed", error.id);
    if (!is_failure && has_failure_plan(event.kind, event.literal, nullptr)) {
      add_event({TriggerOperator::remove, event.kind,
                 failure_literal(event.literal, error, event.literal, 0), nullptr, 0});
    } else {
      log(error.message);
    }
    return;
  }
  Intention& intention = *event.intention;
  if (is_failure) {  // a plan for the failure exists, but is not applicable
    log("could not finish intention: " + error.message);
    drop(intention);
    return;
  }
  if (intention.is_atomic()) circumstance_.atomic_suspended = false;
  const std::uint32_t line = intention.top().cursor.at_end() ? 0 : intention.top().step().line;
  const Value goal = machine_.unifier().fresh_copy(event.literal);
  signal_goal_state(event.kind, event.literal, "failed", error.id);
  if (has_failure_plan(event.kind, event.literal, intention.top().scope.get())) {
    add_event({TriggerOperator::remove, event.kind,
               failure_literal(event.literal, error, goal, line), &intention,
               intention.stack.size()});
    return;
  }
  fail_stack(intention, error, goal, line);
}

void Agent::fail_waiting(Intention& intention, const ActionError& error) { fail(intention, error); }

}  // namespace jaywalk
