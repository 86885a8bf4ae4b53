// Queries of the usual kind over a few facts: at(X, Y), lane(First, Last, _), radius(15).
//
// Elsewhere a slot without a value gets a variable, which is handed to the query and bound there.
// But if all arguments are constants and slots (Goal::is_plain), the arguments of a fact can go
// straight into the slots; which of these were free beforehand is noted as a set of bits, so that
// they can be freed again for the next row. Only when a row has matched, and only if somebody may
// go back behind it, are the slots written on the trail.
//
// A row is a candidate if none of its arguments is a number or atom that differs from what is asked
// for. The next candidate is looked for before the present one is tried, so that the last of them
// leaves no choice point. Variables count as made, since they show their numbers.

#include "interpreter/logic/machine.h"

namespace jaywalk {
namespace {

bool is_in(std::uint32_t set, std::size_t argument) { return (set >> argument & 1U) != 0; }

// Evidently different.
bool is_other(Value wanted, Value known) {
  if (wanted.same_as(known)) return false;
  if (wanted.is_number() && known.is_number()) return wanted.as_number() != known.as_number();
  return (wanted.is_number() || wanted.is_atom()) && (known.is_number() || known.is_atom());
}

Value value_of(Value arg, const Value* slots) {
  return deref(arg.is_slot() ? slots[arg.slot_index()] : arg);
}

std::uint32_t free_slots(const Goal& goal, const Value* slots) {
  std::uint32_t free = 0;
  const std::span<const Value> args = goal.args();
  for (std::size_t i = 0; i < args.size(); ++i) {
    if (args[i].is_slot() && slots[args[i].slot_index()].is_unset()) free |= 1U << i;
  }
  return free;
}

}  // namespace

// The next candidate below a row; kNone if there is none.
std::int64_t Machine::next_fact(const Relation& relation, std::int64_t seq, const Goal& goal,
                                SlotSet free) const {
  const std::span<const Value> args = goal.args();
  const Value* const slots = environment_->slots;
  while (--seq >= relation.first_seq()) {
    const Value fact = relation.row(seq).fact;
    if (fact.is_unset()) continue;
    const Value* const known = args.empty() ? nullptr : fact.structure()->args();
    std::size_t i = 0;
    while (i < args.size() && (is_in(free, i) || !is_other(value_of(args[i], slots), known[i])))
      ++i;
    if (i == args.size()) return seq;
  }
  return RowIndex::kNone;
}

// True: the free slots are set, but not recorded. False: nothing has changed.
bool Machine::match_fact(Value fact, const Goal& goal, SlotSet free) {
  const std::span<const Value> args = goal.args();
  if (args.empty()) return true;
  if (!fact.is_closed()) fact = unifier_.fresh_copy(fact);
  const Value* const known = fact.structure()->args();
  Value* const slots = environment_->slots;
  const std::size_t trail = unifier_.mark();
  for (std::size_t i = 0; i < args.size(); ++i) {
    const Value other = deref(known[i]);
    if (is_in(free, i)) {
      slots[args[i].slot_index()] = other;
      continue;
    }
    const Value wanted = value_of(args[i], slots);
    if (wanted.same_as(other)) continue;
    if (wanted.is_variable()) {
      unifier_.bind(wanted.variable(), other);
    } else if (!unifier_.unify_no_undo(wanted, other)) {
      unifier_.undo(trail);
      for (std::size_t k = 0; k < i; ++k) {
        if (is_in(free, k)) slots[args[k].slot_index()] = Value();
      }
      return false;
    }
  }
  return true;
}

void Machine::record_slots(const Goal& goal, SlotSet free, Recorded recorded) {
  const std::span<const Value> args = goal.args();
  Value* const slots = environment_->slots;
  for (std::size_t i = 0; free != 0; ++i, free >>= 1U) {
    if ((free & 1U) == 0) continue;
    Value* const slot = slots + args[i].slot_index();
    recorded == Recorded::always ? unifier_.record_slot(slot) : unifier_.set_slot(slot, *slot);
  }
}

bool Machine::query_facts(const Relation& relation, const Goal& goal) {
  const SlotSet free = free_slots(goal, environment_->slots);
  std::int64_t seq = next_fact(relation, relation.end_seq(), goal, free);
  while (seq != RowIndex::kNone) {
    const std::int64_t next = next_fact(relation, seq, goal, free);
    const std::size_t trail = unifier_.mark();
    const Heap::Mark top = heap().mark();
    if (match_fact(relation.row(seq).fact, goal, free)) {
      if (next != RowIndex::kNone) {
        ChoicePoint& choice = push(ChoicePoint::Kind::facts, goal);
        choice.relation = &relation;
        choice.seq = next;
        choice.trail = trail;
        choice.heap = top;
        record_slots(goal, free, Recorded::always);
      } else {
        record_slots(goal, free, Recorded::if_needed);
      }
      goal_ = goal.next;
      return true;
    }
    heap().release(top);
    seq = next;
  }
  return false;
}

// The choice point stays as long as it has candidates left.
bool Machine::retry_facts() {
  ChoicePoint& choice = choices_.back();
  const Relation& relation = *choice.relation;
  const Goal& goal = *choice.goal;
  const SlotSet free = free_slots(goal, environment_->slots);
  std::int64_t seq = choice.seq;
  while (seq != RowIndex::kNone) {
    const std::int64_t next = next_fact(relation, seq, goal, free);
    choice.seq = next;
    const Value fact = relation.row(seq).fact;
    if (next == RowIndex::kNone) pop();
    if (!fact.is_unset() && match_fact(fact, goal, free)) {
      record_slots(goal, free, Recorded::always);
      goal_ = goal.next;
      return true;
    }
    seq = next;
  }
  return false;
}

}  // namespace jaywalk
