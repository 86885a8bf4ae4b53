// A context is nearly always a chain of queries over facts with tests between them:
//
//   at(X, L) & speed(V) & L > 0 & Next = X + V
//
// Each query is a loop over the rows of its relation; for each row that matches, the rest of the
// chain is proved by a call of the same function. So the depth of calls is that of the text, and a
// solution is found in the order in which the machine finds it. What a row binds are slots of the
// frame, noted in a little array of their own for when the next row is tried.
//
// A query whose relation has one row needs no loop and no call. A rule is proved the same way, over
// a frame of its own; at the end of its body the chain goes on behind the query, in the frame of
// who asked:
//
//   danger(X, D) & lane(K)                      frame of the plan
//        |            ^
//        v            | D
//   hazard(H) & D = H - X & D > 0               frame of danger(X, D) :- ...
//
// A third decision, `open`, says that a goal is of another kind: an internal action, a term with
// variables, annotations, a rule that asks for more than there is room for. Then the machine has to
// be asked, and where it has to begin follows from the order of solutions: as long as no query
// before the goal can have another row (choices_ is 0), what has been proved stands, and the
// machine goes on at the goal; else it begins at the first query that can. Work that is done twice
// is bounded by kMostRows.

#include "interpreter/agent/context.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "interpreter/agent/numbers.h"
#include "interpreter/agent/operands.h"

namespace jaywalk {
// A number, an expression, or a function of numbers, `math.abs(Y - A) + R`.
bool Context::evaluate(Value term, double& number) {
  if (is_known_number(term, frame_, number)) return true;
  if (!term.is_structure() || term.structure()->arity > 2) return false;
  const Structure& s = *term.structure();
  std::array<double, 2> operands{};
  for (std::size_t i = 0; i < s.arity; ++i) {
    if (!evaluate(s.arg(i), operands[i])) return false;
  }
  if (s.form() == Form::expression && s.arity == 2) {
    const std::optional<double> value = calculate(s.predicate(), operands[0], operands[1]);
    number = value.value_or(0);
    return value.has_value();
  }
  const std::array<Value, 2> args{Value::number(operands[0]), Value::number(operands[1])};
  Value value;
  if (s.form() != Form::function ||
      !machine_.call_of_numbers(s.predicate(), std::span(args).first(s.arity), value)) {
    return false;
  }
  number = value.is_number() ? value.as_number() : 0;
  return value.is_number();
}

[[gnu::always_inline]] inline bool Context::find_operand(Value term, Value& value) {
  if (known_operand(term, frame_, value)) return true;
  double number = 0;
  if (!term.is_structure() || !evaluate(term, number)) return false;
  value = Value::number(number);
  return true;
}

[[gnu::always_inline]] inline Decision Context::compare(const Goal& goal) {
  const Value* const sides = goal.term.structure()->args();
  Value left;
  Value right;
  if (!find_operand(sides[0], left) || !find_operand(sides[1], right)) return Decision::open;
  return compare_known(goal.predicate, left, right);
}

Decision Context::unify(const Goal& goal) {
  const Value* const sides = goal.term.structure()->args();
  Value right;
  if (!find_operand(sides[1], right)) return Decision::open;
  if (sides[0].is_slot() && frame_[sides[0].slot_index()].is_unset()) {
    if (Unifier::is_of_other_namespace(right) || count_ == kMostSlots) return Decision::open;
    set(frame_ + sides[0].slot_index(), right);
    return Decision::holds;
  }
  Value left;
  if (!known_operand(sides[0], frame_, left)) {
    // An open variable, of the caller perhaps, is bound where nothing will go back behind it but
    // the failure of the whole.
    if (!left.is_variable() || !right.is_number() || choices_ > 0) return Decision::open;
    machine_.unifier().bind(left.variable(), right);
    return Decision::holds;
  }
  return unify_known(left, right);
}

[[gnu::always_inline]] inline Decision Context::test(const Goal& goal) {
  switch (goal.kind) {
    case Goal::Kind::compare:
      return compare(goal);
    case Goal::Kind::unify:
      return unify(goal);
    case Goal::Kind::negation:
      return negation(goal);
    case Goal::Kind::truth:
      return Decision::holds;
    default:
      return Decision::open;
  }
}

// The rest of a chain from some goal on; in a rule's body, what follows the query for the rule,
// too.
Decision Context::prove(const Goal* goal) {
  const std::size_t mark = count_;
  for (; goal != nullptr; goal = goal->next) {
    if (goal->kind == Goal::Kind::negation_done) return Decision::holds;
    bool is_rest_proved = false;
    Decision decision = Decision::open;
    if (goal->kind == Goal::Kind::query) {
      decision = query(*goal, is_rest_proved);
    } else {
      decision = test(*goal);
    }
    if (decision == Decision::holds) {
      if (is_rest_proved) return decision;
      continue;
    }
    if (decision == Decision::open && choices_ == 0 && solve_by_machine(*goal))
      return Decision::holds;
    undo(mark);
    return choices_ == 0 ? Decision::fails : decision;
  }
  if (call_ == nullptr) return Decision::holds;
  const Decision decision = leave_rule();
  if (decision != Decision::holds) undo(mark);
  return decision;
}

bool Context::solve_by_machine(const Goal& goal) { return machine_.solve(&goal, frame_); }

// Within it nothing is left to the machine: that would prove what follows the negation, too.
Decision Context::negation(const Goal& goal) {
  const std::size_t mark = count_;
  ++choices_;
  const Decision inner = prove(goal.inner);
  --choices_;
  undo(mark);
  if (inner == Decision::open) return inner;
  return inner == Decision::holds ? Decision::fails : Decision::holds;
}

// Some row matches; where another one might, too, the rest of the chain holds with it.
[[gnu::always_inline]] inline Decision Context::query(const Goal& goal, bool& is_rest_proved) {
  Relation* const relation = beliefs_.find(goal.predicate);
  if (relation == nullptr) return Decision::fails;
  if (relation->has_rules()) {
    is_rest_proved = true;
    return rule_query(goal, *relation);
  }
  const std::int64_t first = relation->first_seq();
  const std::int64_t end = relation->end_seq();
  if (!goal.term.is_structure()) {  // there is one row at most
    return relation->size() == 0 ? Decision::fails : Decision::holds;
  }
  if (end - first == 1) {
    const Row& row = relation->row(first);
    return row.is_hole() ? Decision::fails : match(row, goal);
  }
  is_rest_proved = true;
  return end - first > kFewRows ? long_query(goal, *relation) : short_query(goal, *relation);
}

Decision Context::short_query(const Goal& goal, const Relation& relation) {
  const std::int64_t first = relation.first_seq();
  const std::size_t mark = count_;
  for (std::int64_t seq = relation.end_seq(); --seq >= first;) {
    const Row& row = relation.row(seq);
    if (row.is_hole()) continue;
    const Decision decision = match_and_go_on(row, goal, seq > first);
    if (decision == Decision::holds) return decision;
    undo(mark);
    if (decision == Decision::open) return decision;
  }
  return Decision::fails;
}

// The same by an index.
Decision Context::long_query(const Goal& goal, Relation& relation) {
  const std::span<const Value> args = goal.args();
  if (args.size() > kMostArguments) return Decision::open;
  std::array<Value, kMostArguments> wanted;  // unset: whatever the slot gets
  for (std::size_t i = 0; i < args.size(); ++i) {
    const bool is_free = args[i].is_slot() && frame_[args[i].slot_index()].is_unset();
    if (!is_free && !known_operand(args[i], frame_, wanted[i])) return Decision::open;
  }
  Relation::Cursor cursor = relation.open(std::span(wanted).first(args.size()));
  const std::size_t mark = count_;
  std::int64_t seq = 0;
  while (const Row* const row = relation.advance(cursor, seq, nullptr)) {
    if (++rows_ > kMostRows) return Decision::open;
    const Decision decision = match_and_go_on(*row, goal, cursor.has_more());
    if (decision == Decision::holds) return decision;
    undo(mark);
    if (decision == Decision::open) return decision;
  }
  return Decision::fails;
}

// The row matches the query.
[[gnu::always_inline]] inline Decision Context::match(const Row& row, const Goal& goal) {
  if (!row.fact.is_closed()) return Decision::open;
  const Value* const known = row.fact.structure()->args();
  const Structure& wanted = *goal.term.structure();
  const Value* const args = wanted.args();
  for (std::size_t i = 0; i < wanted.arity; ++i) {
    if (args[i].is_slot() && frame_[args[i].slot_index()].is_unset()) {
      if (count_ == kMostSlots) return Decision::open;
      set(frame_ + args[i].slot_index(), known[i]);
      continue;
    }
    Value value;
    if (!known_operand(args[i], frame_, value)) return Decision::open;
    if (value.same_as(known[i])) continue;
    if (value.is_number() && known[i].is_number()) {
      if (value.as_number() != known[i].as_number()) return Decision::fails;
    } else if (value.is_atom() && known[i].is_atom()) {
      return Decision::fails;
    } else if (!machine_.unifier().unify(value, known[i])) {
      return Decision::fails;
    }
  }
  return Decision::holds;
}

Decision Context::match_and_go_on(const Row& row, const Goal& goal, bool has_more) {
  Decision decision = match(row, goal);
  if (decision != Decision::holds) return decision;
  choices_ += has_more ? 1U : 0U;
  decision = prove(goal.next);
  choices_ -= has_more ? 1U : 0U;
  return decision;
}

// A query for which there are rules and nothing else, one after another.
Decision Context::rule_query(const Goal& goal, Relation& relation) {
  const RuleTable* const table = relation.rule_table();
  if (table == nullptr || rules_ == kMostRules) return Decision::open;
  const std::span<const RuleTable::Candidate> rules = table->candidates();
  const std::size_t count = rules.size();
  Decision decision = Decision::fails;
  for (std::size_t i = 0; i < count && decision == Decision::fails; ++i) {
    choices_ += i + 1 < count ? 1U : 0U;
    ++rules_;
    decision = rule(goal, *rules[i].rule);
    --rules_;
    choices_ -= i + 1 < count ? 1U : 0U;
  }
  return decision;
}

// The body is proved in a frame of its own, and then, in the caller's, what follows the query.
Decision Context::rule(const Goal& goal, const RuleCode& rule) {
  if (rule.slot_count > kMostRuleSlots || ++entries_ > kMostEntries) return Decision::open;
  std::array<Value, kMostRuleSlots> slots;
  const std::vector<HeadStep>& head = rule.head_code.steps();
  for (const HeadStep& step : head) {
    const Value arg = goal.args()[step.argument];
    const bool is_free = arg.is_slot() && frame_[arg.slot_index()].is_unset();
    Value value;
    if (!is_free && !known_operand(arg, frame_, value)) return Decision::open;
    if (step.kind == HeadStep::Kind::any || step.kind == HeadStep::Kind::first) {
      if (Unifier::is_of_other_namespace(value)) return Decision::fails;
      if (step.kind == HeadStep::Kind::first) slots[step.slot] = value;
    } else if (step.kind == HeadStep::Kind::constant) {
      if (is_free) continue;  // the caller gets it at the end
      const Decision decision = unify_known(step.term, value);
      if (decision != Decision::holds) return decision;
    } else {
      return Decision::open;
    }
  }
  Call call{&goal, &head, frame_, call_};
  const std::size_t mark = count_;
  call_ = &call;
  frame_ = slots.data();
  ++choices_;  // what is open in the body is so for the whole query
  const Decision decision = prove(rule.body.entry);
  --choices_;
  call_ = call.outer;
  frame_ = call.frame;
  if (decision == Decision::holds) {
    forget(mark, slots);  // within a negation, the rest may still be undone
  } else {
    undo(mark);
  }
  return decision;
}

// What has been set since a mark in a frame that is about to go.
void Context::forget(std::size_t mark, std::span<const Value> slots) {
  const auto is_of_frame = [slots](const Value* slot) {
    return !std::less<>()(slot, slots.data()) && std::less<>()(slot, slots.data() + slots.size());
  };
  Value** const end = set_.data() + count_;
  Value** const kept = std::remove_if(set_.data() + mark, end, is_of_frame);
  count_ = static_cast<std::size_t>(kept - set_.data());
}

// The end of a rule's body: the rule's results are copied into the caller's slots.
Decision Context::leave_rule() {
  const Call& done = *call_;
  Value* const slots = frame_;
  const std::size_t mark = count_;
  for (const HeadStep& step : *done.head) {
    const Value arg = done.query->args()[step.argument];
    if (!arg.is_slot() || !done.frame[arg.slot_index()].is_unset()) continue;
    Value found;
    if (step.kind == HeadStep::Kind::first) found = deref(slots[step.slot]);
    if (step.kind == HeadStep::Kind::constant) found = step.term;
    if (found.is_unset() || !found.is_closed() || Unifier::is_of_other_namespace(found) ||
        count_ == kMostSlots || is_twice(*done.query, arg)) {
      undo(mark);
      return Decision::open;
    }
    set(done.frame + arg.slot_index(), found);
  }
  const Call* const call = call_;
  frame_ = done.frame;
  call_ = done.outer;
  --choices_;
  const Decision decision = prove(done.query->next);
  ++choices_;
  call_ = call;
  frame_ = slots;
  return decision;
}

// An argument that stands in a query more than once.
bool Context::is_twice(const Goal& query, Value arg) {
  const std::span<const Value> args = query.args();
  return std::count_if(args.begin(), args.end(), [arg](Value v) { return v.same_as(arg); }) > 1;
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
