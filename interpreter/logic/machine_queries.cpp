// SPDX-License-Identifier: Apache-2.0
// Queries over facts and rules: the arguments are made, and the candidates among the rows are tried
// one after another.
//
// An argument without a value gets a variable, which is handed to the query and bound there. But if
// only a few facts can answer, and all arguments are constants and slots (Goal::is_plain), it stays
// without one, and the argument of a fact goes straight into the slot.
//
// The next candidate is looked for before the present one is tried, so that the last of them leaves
// no choice point.

#include <algorithm>

#include "interpreter/logic/machine_inline.h"

namespace jaywalk {
namespace {

// An argument's value; unset: a slot without a value.
Value value_of(Value arg, const Value* slots) {
  return deref(arg.is_slot() ? slots[arg.slot_index()] : arg);
}

}  // namespace

// Like make_arguments(), but makes no variables for slots without a value.
[[gnu::always_inline]] inline const Value* Machine::look_at_arguments(const Goal& goal) {
  const std::span<const Value> terms = goal.args();
  Value* const registers = registers_for(goal);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    registers[i] = value_of(terms[i], environment_->slots);
  }
  return registers;
}

// Unifies an argument of a fact with one of the goal; an unset slot of the goal gets its value.
// False: bindings may remain.
[[gnu::always_inline]] inline bool Machine::match_argument(Value known, Value wanted, Value term) {
  if (wanted.is_unset()) {
    unifier_.set_slot(environment_->slots + term.slot_index(), known);
    return true;
  }
  if (wanted.same_as(known)) return true;
  if (wanted.is_variable()) {
    unifier_.bind(wanted.variable(), known);
    return true;
  }
  return !evidently_differ(wanted, known) && unifier_.unify_no_undo(wanted, known);
}

// `argument` gives the value of a term's place.
template <class Argument>
[[gnu::always_inline]] inline bool Machine::match_each(Value fact, std::span<const Value> terms,
                                                       Argument argument) {
  if (terms.empty()) return true;
  if (!fact.is_closed()) fact = unifier_.fresh_copy(fact);
  const Value* const known = fact.structure()->args();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    // A variable of the fact may be known by now.
    if (!match_argument(deref(known[i]), argument(i), terms[i])) return false;
  }
  return true;
}

bool Machine::match_fact(Value fact, const Value* args, std::span<const Value> terms) {
  return match_each(fact, terms, [args](std::size_t i) { return deref(args[i]); });
}

// The only fact need not be looked for.
bool Machine::query_few(Relation& relation, const Goal& goal) {
  const Row* const lone = relation.lone_fact();
  if (lone == nullptr) return try_rows(relation, goal, look_at_arguments(goal));
  goal_ = goal.next;
  const Value* const terms = goal.args().data();
  const Value* const slots = environment_->slots;
  return match_each(lone->fact, goal.args(),
                    [terms, slots](std::size_t i) { return value_of(terms[i], slots); });
}

// Whether each argument takes any value.
bool Machine::asks_for_all(const Goal& goal) const {
  if (!goal.is_plain) return false;
  const std::span<const Value> terms = goal.args();
  const Value* const slots = environment_->slots;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Value value = value_of(terms[i], slots);
    if (value.is_unset()) continue;
    if (!value.is_variable()) return false;
    const auto is_same = [&](Value other) { return value_of(other, slots).same_as(value); };
    if (std::ranges::any_of(terms.first(i), is_same)) return false;
  }
  return true;
}

// Answers a query to folded rules by their stored answers.
bool Machine::query_answers(const Answers& answers, const Goal& goal) {
  count_inferences(answers.inferences[0]);
  if (answers.size() == 0) return false;
  if (answers.may_go_on_after(0)) {
    ChoicePoint& choice = push(ChoicePoint::Kind::answers, goal);
    choice.answers = &answers;
    choice.answer = 1;
  }
  return take_answer(answers.answer(0), goal);
}

// To go back is an inference that has been counted.
bool Machine::retry_answers() {
  --inferences_;
  ChoicePoint& choice = choices_.back();
  const Answers& answers = *choice.answers;
  const Goal& goal = *choice.goal;
  const std::size_t index = choice.answer;
  count_inferences(answers.inferences[index]);
  if (answers.may_go_on_after(index)) {
    choice.answer = static_cast<std::uint16_t>(index + 1);
  } else {
    pop();
  }
  return index < answers.size() && take_answer(answers.answer(index), goal);
}

bool Machine::take_answer(std::span<const Value> answer, const Goal& goal) {
  const std::span<const Value> terms = goal.args();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (!match_argument(answer[i], value_of(terms[i], environment_->slots), terms[i])) return false;
  }
  goal_ = goal.next;
  return true;
}

// The last candidate needs no choice point: if it fails, so does the query.
[[gnu::noinline]] bool Machine::try_rows(Relation& relation, const Goal& goal, const Value* args) {
  Relation::Cursor cursor = relation.open({args, goal.args().size()});
  std::int64_t seq = 0;
  const Row* const row = relation.advance(cursor, seq, args);
  if (row == nullptr) return false;
  if (!cursor.has_more()) return enter_row(*row, goal, args);
  push_rows(relation, cursor, goal, args);
  if (enter_row(*row, goal, args)) return true;
  restore(choices_.back());
  return retry_rows();
}

[[gnu::always_inline]] inline bool Machine::enter_row(const Row& row, const Goal& goal,
                                                      const Value* args) {
  if (row.rule != nullptr) return enter_rule(*row.rule, goal, args);
  goal_ = goal.next;
  return match_fact(row.fact, args, goal.args());
}

// A choice point for the rest of a cursor. Arguments that have been made are kept, others are
// looked at again.
void Machine::push_rows(const Relation& relation, const Relation::Cursor& cursor, const Goal& goal,
                        const Value* args) {
  Value* saved = nullptr;
  if (relation.has_rules() || !goal.is_plain || !relation.has_few_facts()) {
    const std::size_t count = goal.args().size();
    saved = reinterpret_cast<Value*>(allocate_frame(count));
    std::copy_n(args, count, saved);
  }
  ChoicePoint& choice = push(ChoicePoint::Kind::rows, goal);
  choice.relation = &relation;
  choice.cursor = cursor;
  choice.args = saved;
}

// The latest choice point, to which we have gone back, stays as long as it has candidates left.
bool Machine::retry_rows() {
  for (;;) {
    ChoicePoint& choice = choices_.back();
    const Goal& goal = *choice.goal;
    const Value* const saved = choice.args;
    const Value* const args = saved != nullptr ? saved : look_at_arguments(goal);
    std::int64_t seq = 0;
    const Row* const row = choice.relation->advance(choice.cursor, seq, args);
    if (row == nullptr || !choice.cursor.has_more()) return leave_rows(row, goal, saved);
    if (enter_row(*row, goal, args)) return true;
    restore(choices_.back());
  }
}

// Takes the last row, or null, and drops the choice point.
bool Machine::leave_rows(const Row* row, const Goal& goal, const Value* saved) {
  if (saved != nullptr) {
    std::copy_n(saved, goal.args().size(), registers_for(goal));
    frames_.release(reinterpret_cast<FrameStack::Mark>(const_cast<Value*>(saved)));
  }
  pop();
  return row != nullptr && enter_row(*row, goal, registers_.data());
}

// Counts facts without enumerating them, if at most one argument is bound and the others match any
// value.
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

}  // namespace jaywalk
