// SPDX-License-Identifier: Apache-2.0
// Formulas that change beliefs: `+b`, `-b`, `-+b` and their kin.

#include "interpreter/agent/agent.h"
#include "interpreter/agent/execution/goal_arguments.h"

namespace jaywalk {

// The belief that was added last goes if it is a fact of the agent's own and has no other source.
// False: it is something else, and nothing has been done.
bool Agent::forget_one(Predicate predicate) {
  if (customisation_ != nullptr) return false;
  Relation* const relation = beliefs_.find(predicate);
  if (relation == nullptr) return true;
  for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
    const Row& row = relation->row(seq);
    if (row.is_hole()) continue;
    if (!row.fact.is_structure() || !row.fact.is_closed()) return false;
    const Structure& fact = *row.fact.structure();
    if (fact.arity == 0 || !fact.annots().same_as(source_self())) return false;
    const Value forgotten = row.fact;
    beliefs_.erase(*relation, seq);
    add_event({TriggerOperator::remove, TriggerKind::belief, forgotten, nullptr});
    return true;
  }
  return true;
}

// Removes the belief that the literal replaces. Binds no variable of the literal.
void Agent::forget_for(Value literal) {
  const LiteralParts parts = literal_parts(literal);
  if (parts.annots.same_as(source_self()) && forget_one(parts.predicate)) return;
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  (void)remove_belief(any_like(literal), nullptr);
  unifier.undo(trail);
}

// The literal with open arguments.
Value Agent::any_like(Value literal) {
  const LiteralParts parts = literal_parts(literal);
  std::vector<Value> args(parts.args.size());
  for (Value& arg : args) arg = heap_.variable();
  return heap_.structure(parts.predicate, args, parts.annots);
}

// `+b`, `-b` and `-+b` with a ground b that has no other source than the agent itself, without
// belief revision. The next formula waits for the plan for it.
[[gnu::always_inline]] inline void Agent::change_own_belief(Intention& intention, Value literal,
                                                            Step::Kind kind) {
  bool changed = false;
  if (kind == Step::Kind::remove) {
    changed = disbelieve_as_it_is(literal, &intention);
  } else {
    const bool replaces = kind == Step::Kind::replace;
    if (replaces && !forget_one(literal.structure()->predicate())) forget_for(literal);
    changed = believe_as_it_is(literal, Place::front, &intention);
  }
  if (!changed) go_on(intention);
}

// The belief of the formula if it is ground, of the usual form, and the agent's own; else unset.
[[gnu::always_inline]] inline Value Agent::ground_belief(Intention& intention,
                                                         const EventCode& code) {
  if (!code.is_decoded) return {};
  Structure* const made = heap_.blank_literal(code.predicate, code.args.size(), source_self());
  OpenArguments open;
  const Value* const frame = intention.frame(intention.top());
  if (!put_arguments(code, frame, made->args(), open) || open.count > 0) return {};
  return heap_.literal_of(made, true);
}

void Agent::execute_belief(Intention& intention, const Step& step) {
  const Value literal = step.event == nullptr ? Value() : ground_belief(intention, *step.event);
  if (literal.is_unset()) {
    change_belief_by_term(intention, step.term, step.kind);
  } else if (customisation_ != nullptr || !settings_.same_focus) {
    change_belief(intention, literal, step.kind);
  } else {
    change_own_belief(intention, literal, step.kind);
  }
}

void Agent::change_belief_by_term(Intention& intention, Value term, Step::Kind kind) {
  if (execute_plan_or_rule(intention, term, kind)) return;
  const bool new_focus = kind == Step::Kind::add_new_focus || !settings_.same_focus;
  const bool adds = kind == Step::Kind::add || kind == Step::Kind::add_new_focus ||
                    kind == Step::Kind::add_begin || kind == Step::Kind::add_end;
  // Deleting binds the variables of the pattern, so they are not renamed.
  const Value literal =
      adds ? prepare_for_event(intention, term, !new_focus)
           : machine().unifier().instantiate(term, intention.frame(intention.top()));
  if (is_literal(literal)) {
    change_belief(intention, literal, kind);
  } else {
    ActionError error;
    error.id = "body_var_not_literal";
    error.message = "a belief must be a literal";
    fail(intention, error);
  }
}

void Agent::change_belief(Intention& intention, Value literal, Step::Kind kind) {
  if (kind == Step::Kind::replace) {
    execute_replace(intention, literal);
    return;
  }
  const bool new_focus = kind == Step::Kind::add_new_focus ||
                         kind == Step::Kind::remove_new_focus || !settings_.same_focus;
  Intention* const focus = new_focus ? nullptr : &intention;
  const bool removes = kind == Step::Kind::remove || kind == Step::Kind::remove_new_focus;
  if (removes) record_bindings(intention, 0);
  const std::size_t trail = machine().unifier().mark();
  const Place place = kind == Step::Kind::add_end ? Place::back : Place::front;
  const bool changed = removes ? remove_belief(literal, focus) : add_belief(literal, place, focus);
  // Only an intention that handles the event of the deletion keeps its bindings.
  if (removes && focus == nullptr) machine().unifier().undo(trail);
  record_bindings(intention, trail);
  if (!changed || new_focus) go_on(intention);
}

// -+b: one belief of the same name goes, as if deleted by another intention, then b comes.
void Agent::execute_replace(Intention& intention, Value literal) {
  forget_for(literal);
  record_bindings(intention, 0);
  if (!literal.is_closed()) literal = machine().unifier().fresh_copy(literal);
  Intention* const focus = settings_.same_focus ? &intention : nullptr;
  if (!add_belief(literal, Place::front, focus) || focus == nullptr) go_on(intention);
}

}  // namespace jaywalk
