// Queries of the usual kind over a few facts: at(X, Y), lane(First, Last, _), radius(15).
//
// Elsewhere a slot without a value gets a variable, which is handed to the query and bound there.
// But if all arguments are constants and slots (Goal::is_plain), the arguments of a fact can go
// straight into the slots.
//
// A row is a candidate if none of its arguments is a number or atom that differs from what is asked
// for. The next candidate is looked for before the present one is tried, so that the last of them
// leaves no choice point.

#include "interpreter/logic/machine.h"

namespace jaywalk {
namespace {

// Evidently different.
bool is_other(Value wanted, Value known) {
  if (wanted.same_as(known)) return false;
  if (wanted.is_number() && known.is_number()) return wanted.as_number() != known.as_number();
  return (wanted.is_number() || wanted.is_atom()) && (known.is_number() || known.is_atom());
}

// Unset: a slot without a value.
Value value_of(Value arg, const Value* slots) {
  return deref(arg.is_slot() ? slots[arg.slot_index()] : arg);
}

// The next candidate below a row; kNone if there is none.
std::int64_t next_fact(const Relation& relation, std::int64_t seq, const Goal& goal,
                       const Value* slots) {
  const std::span<const Value> args = goal.args();
  while (--seq >= relation.first_seq()) {
    const Value fact = relation.row(seq).fact;
    if (fact.is_unset()) continue;
    const Value* const known = args.empty() ? nullptr : fact.structure()->args();
    std::size_t i = 0;
    while (i < args.size() && !is_other(value_of(args[i], slots), known[i])) ++i;
    if (i == args.size()) return seq;
  }
  return RowIndex::kNone;
}

}  // namespace

// False: something may have been bound.
[[gnu::always_inline]] inline bool Machine::match_fact(Value fact, const Goal& goal, Value* slots) {
  if (!goal.term.is_structure()) return true;
  if (!fact.is_closed()) fact = unifier_.fresh_copy(fact);
  const Structure& wanted = *goal.term.structure();
  const Value* const args = wanted.args();
  const Value* const known = fact.structure()->args();
  for (std::size_t i = 0; i < wanted.arity; ++i) {
    const Value other = deref(known[i]);
    if (args[i].is_slot() && slots[args[i].slot_index()].is_unset()) {
      unifier_.set_slot(slots + args[i].slot_index(), other);
      continue;
    }
    const Value value = value_of(args[i], slots);
    if (value.same_as(other)) continue;
    if (value.is_variable()) {
      unifier_.bind(value.variable(), other);
    } else if (is_other(value, other) || !unifier_.unify_no_undo(value, other)) {
      return false;
    }
  }
  return true;
}

bool Machine::query_facts(const Relation& relation, const Goal& goal) {
  Value* const slots = environment_->slots;
  if (relation.end_seq() - relation.first_seq() == 1) {
    const Value fact = relation.row(relation.first_seq()).fact;
    goal_ = goal.next;
    return !fact.is_unset() && match_fact(fact, goal, slots);
  }
  std::int64_t seq = next_fact(relation, relation.end_seq(), goal, slots);
  while (seq != RowIndex::kNone) {
    const Value fact = relation.row(seq).fact;
    const std::int64_t next = next_fact(relation, seq, goal, slots);
    goal_ = goal.next;
    if (next == RowIndex::kNone) return match_fact(fact, goal, slots);
    ChoicePoint& choice = push(ChoicePoint::Kind::facts, goal);
    choice.relation = &relation;
    choice.seq = next;
    if (match_fact(fact, goal, slots)) return true;
    restore(choices_.back());
    pop();
    seq = next;
  }
  return false;
}

// The same where one row at most may match: then no choice is left, and no frame is needed.
Machine::Tests Machine::query_in_place(const Goal& goal, Value* slots) {
  const Relation* const relation = beliefs_->find(goal.predicate);
  if (relation == nullptr) return Tests::fail;
  if (!goal.is_plain || !relation->has_few_facts()) return Tests::undecided;
  std::int64_t seq = relation->end_seq() - 1;
  if (seq != relation->first_seq()) {
    seq = next_fact(*relation, seq + 1, goal, slots);
    if (seq == RowIndex::kNone) return Tests::fail;
    if (next_fact(*relation, seq, goal, slots) != RowIndex::kNone) return Tests::undecided;
  }
  const Value fact = relation->row(seq).fact;
  if (fact.is_unset()) return Tests::fail;
  return match_fact(fact, goal, slots) ? Tests::hold : Tests::fail;
}

// Where one argument at most is given and each of the others takes anything.
std::optional<std::size_t> Machine::count_facts(const Goal& goal, const Value* slots) {
  Relation* const relation = beliefs_->find(goal.predicate);
  if (relation == nullptr) return 0;
  if (relation->has_rules()) return std::nullopt;
  const std::span<const Value> args = goal.args();
  std::optional<std::size_t> given;
  for (std::size_t i = 0; i < args.size(); ++i) {
    if (value_of(args[i], slots).is_unset()) continue;
    if (given) return std::nullopt;
    given = i;
  }
  return given ? relation->count(*given, value_of(args[*given], slots)) : relation->size();
}

// The choice point stays as long as it has candidates left.
bool Machine::retry_facts() {
  const Relation& relation = *choices_.back().relation;
  const Goal& goal = *choices_.back().goal;
  Value* const slots = environment_->slots;
  std::int64_t seq = choices_.back().seq;
  while (seq != RowIndex::kNone) {
    const std::int64_t next = next_fact(relation, seq, goal, slots);
    choices_.back().seq = next;
    const Value fact = relation.row(seq).fact;
    goal_ = goal.next;
    if (next == RowIndex::kNone) {
      pop();
      return !fact.is_unset() && match_fact(fact, goal, slots);
    }
    if (!fact.is_unset() && match_fact(fact, goal, slots)) return true;
    restore(choices_.back());
    seq = next;
  }
  return false;
}

}  // namespace jaywalk
