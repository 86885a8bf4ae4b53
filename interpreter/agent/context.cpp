// A context is nearly always a chain of queries over facts with tests between them:
//
//   at(X, L) & speed(V) & L > 0 & Next = X + V
//
// Each query is a loop over the rows of its relation; for each row that matches, the rest of the
// chain is proved by a call of the same function. So the depth of calls is that of the text, and a
// solution is found in the order in which the machine finds it. What a row binds are slots of the
// frame, noted in a little array of their own for when the next row is tried.
//
// A third verdict, `open`, says that a goal is of another kind: a rule, an internal action, a term
// with variables, annotations. Then the machine has to be asked, and where it has to begin follows
// from the order of solutions: as long as no query before the goal can have another row (choices_
// is 0), what has been proved stands, and the machine goes on at the goal; else it begins at the
// first query that can. Work that is done twice is bounded by kMostRows.

#include "interpreter/agent/context.h"

#include <optional>

#include "interpreter/agent/numbers.h"
#include "interpreter/agent/operands.h"

namespace jaywalk {
[[gnu::always_inline]] inline Verdict Context::compare(const Goal& goal) {
  const Value* const sides = goal.term.structure()->args();
  Value left;
  Value right;
  if (!known_operand(sides[0], frame_, left) || !known_operand(sides[1], frame_, right))
    return Verdict::open;
  return compare_known(goal.predicate, left, right);
}

Verdict Context::unify(const Goal& goal) {
  const Value* const sides = goal.term.structure()->args();
  Value right;
  if (!known_operand(sides[1], frame_, right)) return Verdict::open;
  if (sides[0].is_slot() && frame_[sides[0].slot_index()].is_unset()) {
    if (Unifier::is_of_other_namespace(right) || count_ == kMostSlots) return Verdict::open;
    set(sides[0].slot_index(), right);
    return Verdict::holds;
  }
  Value left;
  if (!known_operand(sides[0], frame_, left)) {
    // An open variable, of the caller perhaps, is bound where nothing will go back behind it but
    // the failure of the whole.
    if (!left.is_variable() || !right.is_number() || choices_ > 0) return Verdict::open;
    machine_.unifier().bind(left.variable(), right);
    return Verdict::holds;
  }
  return unify_known(left, right);
}

[[gnu::always_inline]] inline Verdict Context::test(const Goal& goal) {
  switch (goal.kind) {
    case Goal::Kind::compare:
      return compare(goal);
    case Goal::Kind::unify:
      return unify(goal);
    case Goal::Kind::negation:
      return negation(goal);
    case Goal::Kind::truth:
      return Verdict::holds;
    default:
      return Verdict::open;
  }
}

Verdict Context::prove(const Goal* goal) {
  const std::size_t mark = count_;
  for (; goal != nullptr; goal = goal->next) {
    if (goal->kind == Goal::Kind::negation_done) break;
    const bool is_query = goal->kind == Goal::Kind::query;
    const Verdict verdict = is_query ? query(*goal) : test(*goal);
    if (verdict == Verdict::holds) {
      if (is_query) break;  // and so does the rest
      continue;
    }
    if (verdict == Verdict::open && choices_ == 0 && machine_.solve(goal, frame_)) break;
    undo(mark);
    return choices_ == 0 ? Verdict::fails : verdict;
  }
  return Verdict::holds;
}

// Within it nothing is left to the machine: that would prove what follows the negation, too.
Verdict Context::negation(const Goal& goal) {
  const std::size_t mark = count_;
  ++choices_;
  const Verdict inner = prove(goal.inner);
  --choices_;
  undo(mark);
  if (inner == Verdict::open) return inner;
  return inner == Verdict::holds ? Verdict::fails : Verdict::holds;
}

// Some row matches, and the rest of the chain holds with it.
Verdict Context::query(const Goal& goal) {
  Relation* const relation = beliefs_.find(goal.predicate);
  if (relation == nullptr) return Verdict::fails;
  if (relation->has_rules()) return Verdict::open;
  const std::int64_t first = relation->first_seq();
  std::int64_t seq = relation->end_seq();
  if (!goal.term.is_structure()) return seq == first ? Verdict::fails : fact(goal, *relation);
  if (seq - first > kFewRows) return long_query(goal, *relation);
  const std::size_t mark = count_;
  while (--seq >= first) {
    const Row& row = relation->row(seq);
    if (row.is_hole()) continue;
    const Verdict verdict = match(row, goal, seq > first);
    if (verdict == Verdict::holds) return verdict;
    undo(mark);
    if (verdict == Verdict::open) return verdict;
  }
  return Verdict::fails;
}

// Without arguments there is one row at most.
Verdict Context::fact(const Goal& goal, const Relation& relation) {
  return relation.size() == 0 ? Verdict::fails : prove(goal.next);
}

// The same by an index.
Verdict Context::long_query(const Goal& goal, Relation& relation) {
  const std::span<const Value> args = goal.args();
  if (args.size() > kMostArguments) return Verdict::open;
  std::array<Value, kMostArguments> wanted;  // unset: whatever the slot gets
  for (std::size_t i = 0; i < args.size(); ++i) {
    const bool is_free = args[i].is_slot() && frame_[args[i].slot_index()].is_unset();
    if (!is_free && !known_operand(args[i], frame_, wanted[i])) return Verdict::open;
  }
  Relation::Cursor cursor = relation.open(std::span(wanted).first(args.size()));
  const std::size_t mark = count_;
  std::int64_t seq = 0;
  while (const Row* const row = relation.advance(cursor, seq, nullptr)) {
    if (++rows_ > kMostRows) return Verdict::open;
    const Verdict verdict = match(*row, goal, cursor.has_more());
    if (verdict == Verdict::holds) return verdict;
    undo(mark);
    if (verdict == Verdict::open) return verdict;
  }
  return Verdict::fails;
}

// The row matches the query, and the rest of the chain holds.
Verdict Context::match(const Row& row, const Goal& goal, bool has_more) {
  if (!row.fact.is_closed()) return Verdict::open;
  const Value* const known = row.fact.structure()->args();
  const Structure& wanted = *goal.term.structure();
  const Value* const args = wanted.args();
  for (std::size_t i = 0; i < wanted.arity; ++i) {
    if (args[i].is_slot() && frame_[args[i].slot_index()].is_unset()) {
      if (count_ == kMostSlots) return Verdict::open;
      set(args[i].slot_index(), known[i]);
      continue;
    }
    Value value;
    if (!known_operand(args[i], frame_, value)) return Verdict::open;
    if (value.same_as(known[i])) continue;
    if (value.is_number() && known[i].is_number()) {
      if (value.as_number() != known[i].as_number()) return Verdict::fails;
    } else if (value.is_atom() && known[i].is_atom()) {
      return Verdict::fails;
    } else if (!machine_.unifier().unify(value, known[i])) {
      return Verdict::fails;
    }
  }
  choices_ += has_more ? 1U : 0U;
  const Verdict verdict = prove(goal.next);
  choices_ -= has_more ? 1U : 0U;
  return verdict;
}

// The operands are expressions themselves, or the operator is a rarer one.
bool evaluate_nested(Value expression, const Value* frame, double& number) {
  const Structure& s = *expression.structure();
  if (s.arity != 2) return false;
  const auto operand = [frame](Value term, double& value) {
    return is_known_number(term, frame, value) ||
           (!term.is_slot() && evaluate_known(term, frame, value));
  };
  double a = 0;
  double b = 0;
  if (!operand(s.arg(0), a) || !operand(s.arg(1), b)) return false;
  const std::optional<double> value = calculate(s.predicate(), a, b);
  number = value.value_or(0);
  return value.has_value();
}

}  // namespace jaywalk
