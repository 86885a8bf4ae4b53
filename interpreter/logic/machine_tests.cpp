// SPDX-License-Identifier: Apache-2.0
// Goals that hold or not, and leave no choice: comparison and unification; probes.

#include "interpreter/logic/machine_inline.h"
#include "interpreter/logic/unifier/univ.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

// A literal is equal to the body that stands for it, `achieve(a) == {!a}`; as in Jason not the
// other way round.
Value compared_with(Value left, Value right, Heap& heap, SymbolTable& symbols) {
  const bool as_literal = is_literal(left) && is_form(right, Form::body);
  return as_literal ? program_structure(heap, symbols, right) : right;
}

}  // namespace

// Whether a rule unfolded into a context may be used there, and its head matches: arguments without
// a value get a variable, as in a call. An agent with other rules, or with beliefs, asks the query
// itself.
bool Machine::enter_unfolded(const Goal& goal) {
  Relation* const relation = beliefs_->find(goal.predicate);
  if (relation == nullptr || relation->rule_table() != goal.table) return query(goal);
  Value* const slots = environment_->slots;
  bool may_be_taken = true;
  for (const Value arg : goal.args()) {
    if (!arg.is_slot()) continue;
    const Value value = slots[arg.slot_index()];
    if (value.is_unset()) {
      (void)unifier_.make_variable(slots, arg.slot_index());
    } else {
      may_be_taken = may_be_taken && !Unifier::is_of_other_namespace(deref(value));
    }
  }
  goal_ = goal.inner;
  return may_be_taken;
}

bool Machine::unify_sides(const Goal& goal, Value* slots) {
  const Value left = goal.args()[0];
  const Value right = unifier_.build(goal.args()[1], slots);
  const bool foreign = (right.is_atom() && is_foreign(right.atom_id())) ||
                       (right.is_structure() && is_foreign(right.structure()->predicate()));
  if (left.is_slot() && slots[left.slot_index()].is_unset() && !foreign) {
    unifier_.set_slot(slots + left.slot_index(), right);
    return true;
  }
  return unifier_.unify_no_undo(unifier_.build(left, slots), right);
}

bool Machine::compare_sides(const Goal& goal, Value* slots) {
  const Value* const sides = goal.term.structure()->args();
  const Value left = unifier_.build(sides[0], slots);
  return compare_values(goal, left, unifier_.build(sides[1], slots));
}

// Not a number is compared as a term.
bool Machine::compare_values(const Goal& goal, Value left, Value right) {
  if (left.is_number() && right.is_number()) {
    const Orders order = order_of(left.as_number(), right.as_number());
    if (order != 0) return (order & goal.orders) != 0;
  }
  if (left.is_variable() && right.is_variable() && left.same_as(right)) {
    // Unbound variables that have been unified are still two: Jason compares their names.
    const bool one = goal.args()[0].same_as(goal.args()[1]);
    if (goal.predicate == predicates::equal) return one;
    if (goal.predicate == predicates::not_equal) return !one;
  }
  const Value a = unifier_.apply(left);
  const Value b = unifier_.apply(right);
  switch (goal.predicate) {
    case predicates::equal:
      return equal_terms(a, compared_with(a, b, heap(), symbols_));
    case predicates::not_equal:
      return !equal_terms(a, compared_with(a, b, heap(), symbols_));
    default:
      break;
  }
  const int order = compare_terms(a, b, symbols_);
  switch (goal.predicate) {
    case predicates::less:
      return order < 0;
    case predicates::less_equal:
      return order <= 0;
    case predicates::greater:
      return order > 0;
    default:
      return order >= 0;
  }
}

// Holds, and is no inference: an observed query takes as many as any other.
void Machine::probe(const Goal& goal, Value* slots) {
  const std::span<const Value> args = goal.args();
  const auto number = static_cast<std::size_t>(args[0].as_number());
  const Value asking = args[1].is_slot() ? slots[args[1].slot_index()] : args[1];
  if (goal.action->probe == Probe::answered) {
    surroundings_->condition_answered(number, static_cast<std::size_t>(deref(asking).as_number()));
    return;
  }
  std::vector<Value> variables;
  for (const Value each : args.subspan(2)) variables.push_back(unifier_.instantiate(each, slots));
  const std::size_t asked = surroundings_->condition_asked(number, variables);
  if (!asking.is_unset()) return;
  unifier_.set_slot(slots + args[1].slot_index(), Value::number(static_cast<double>(asked)));
}

// An observed comparison by itself. False: nothing was reported to the observer.
bool Machine::decide_between_probes(const Goal& asked, Value* slots, bool& holds) {
  const Goal& test = *asked.next;
  if (test.kind != Goal::Kind::compare || !compare_numbers(test, slots, holds)) return false;
  const Goal* const answered = test.next;
  if (answered == nullptr || answered->kind != Goal::Kind::probe || answered->next != nullptr) {
    return false;
  }
  probe(asked, slots);
  if (holds) probe(*answered, slots);
  return true;
}

bool Machine::univ(const Goal& goal) {
  const Value left = unifier_.instantiate(goal.args()[0], environment_->slots);
  const Value right = unifier_.instantiate(goal.args()[1], environment_->slots);
  return unify_univ(unifier_, texts(), left, right);
}

}  // namespace jaywalk
