// SPDX-License-Identifier: Apache-2.0
#pragma once

// The inline parts of nearly every query and every trigger of a plan: the head, matched
// step by step (code/head_code.h); the frame of a rule, made and left; the arguments of a query.
// For the files of the machine, and for plan selection.

#include "interpreter/logic/machine.h"

namespace jaywalk {

namespace head_values {

// A value that a variable of a head may take.
[[gnu::always_inline]] inline bool may_be_taken(Value value) {
  return !Unifier::is_of_other_namespace(value);
}

}  // namespace head_values

// The list is taken apart, or made for a variable. Its tail is the first place of a variable.
template <HeadStep::Kind kHead>
[[gnu::always_inline]] inline bool Machine::match_usual_pair(const HeadCode& code,
                                                             const HeadStep* step, Value* slots,
                                                             Value value) {
  constexpr bool kIsNew = kHead == HeadStep::Kind::first;
  if (value.is_pair()) {
    const Pair& pair = *value.pair();
    const Value head = deref(pair.head);
    if constexpr (kIsNew) {
      slots[step[1].slot] = head;
      if (!head_values::may_be_taken(head)) return false;
    } else if (!match_again(code, head, deref(slots[step[1].slot]))) {
      return false;
    }
    const Value tail = deref(pair.tail);
    slots[step[2].slot] = tail;
    return head_values::may_be_taken(tail);
  }
  if (!value.is_variable()) return match_deep_pair(code, step, slots, value);
  const std::span<const Symbol> names = unifier_.slot_names();
  Value& head = slots[step[1].slot];
  head = kIsNew ? heap().variable(names[step[1].slot]) : deref(head);
  const Symbol name = names[step[2].slot];
  unifier_.bind_young(value.variable(), heap().pair_before(slots[step[2].slot], head, name));
  return true;
}

[[gnu::always_inline]] inline bool Machine::match_steps(const HeadCode& code, Value* slots,
                                                        const Value* args) {
  using enum HeadStep::Kind;
  for (const HeadStep* step = code.begin();; ++step) {
    // Not before it is known that there is one.
    const auto value = [&]() __attribute__((always_inline)) { return deref(args[step->argument]); };
    bool matches = false;
    switch (step->kind) {
      case any:
        matches = head_values::may_be_taken(value());
        break;
      case first:
        matches = head_values::may_be_taken(slots[step->slot] = value());
        break;
      case again:
        matches = match_again(code, value(), deref(slots[step->slot]));
        break;
      case constant: {
        const Value given = value();
        matches = given.same_as(step->term) || match_constant(code, *step, slots, given);
        break;
      }
      case new_pair:
        matches = match_usual_pair<first>(code, step, slots, value());
        step += 2;
        break;
      case known_pair:
        matches = match_usual_pair<again>(code, step, slots, value());
        step += 2;
        break;
      case pair:
        matches = match_pair(code, step, slots, value());
        step += 2;
        break;
      case term:
        matches = match_term(code, *step, slots, value());
        break;
      case end:
        return true;
    }
    if (!matches) return false;
  }
}

// Like match_head(), for a head of variables and constants; the result is open if a constant meets
// another value than a variable, number or atom. So no limit can be met.
[[gnu::always_inline]] inline HeadMatch Machine::match_head_at_once(const HeadCode& code,
                                                                    Value* slots,
                                                                    const Value* args) {
  for (const HeadStep* step = code.begin(); step->kind != HeadStep::Kind::end; ++step) {
    const Value value = deref(args[step->argument]);
    if (step->kind == HeadStep::Kind::first) {
      slots[step->slot] = value;
      if (!head_values::may_be_taken(value)) return HeadMatch::fails;
    } else if (step->kind != HeadStep::Kind::constant) {
      return HeadMatch::open;
    } else if (value.is_variable()) {
      (void)match_constant(code, *step, slots, value);
    } else if (!value.same_as(step->term)) {
      return value.is_number() || value.is_atom() ? HeadMatch::fails : HeadMatch::open;
    }
  }
  return HeadMatch::holds;
}

[[gnu::always_inline]] inline void Machine::clear(const RuleCode& rule, Value* slots) {
  for (std::uint32_t i = rule.head_code.first_to_clear(); i < rule.slot_count; ++i) {
    slots[i] = Value();
  }
}

// Nobody asks for the slots of a frame any more, unless a choice point goes back to it.
[[gnu::always_inline]] inline void Machine::give_up(const Environment& frame) {
  if (frame.choice_points != choice_count_) return;
  if (unifier_.slots_recorded() != frame.slots_recorded) {
    unifier_.forget(frame.trail, {frame.slots, frame.slot_count});
  }
  frames_.release(reinterpret_cast<FrameStack::Mark>(const_cast<Environment*>(&frame)));
}

// Values set in a frame that no choice point goes back to need not be undone.
[[gnu::always_inline]] inline void Machine::use_frame(const Environment& frame) {
  unifier_.set_slot_names({frame.names, frame.slot_count});
  if (frame.choice_points == choice_count_) {
    unifier_.begin_fresh_frame({frame.slots, frame.slot_count});
  } else {
    unifier_.end_fresh_frame();
  }
}

// The goals of a frame's rule have been solved.
[[gnu::always_inline]] inline void Machine::leave_frame() {
  const Environment& done = *environment_;
  goal_ = done.continuation;
  environment_ = done.parent;
  give_up(done);
  use_frame(*environment_);
}

// The last goal of a rule replaces the rule's frame.
[[gnu::always_inline]] inline bool Machine::enter_framed(const RuleCode& rule, const Goal& goal,
                                                         const Value* args) {
  Environment* parent = environment_;
  const Goal* continuation = goal.next;
  if (continuation == nullptr && parent != root_) {
    const Environment& caller = *parent;
    continuation = caller.continuation;
    parent = caller.parent;
    give_up(caller);
  }
  Environment* const made =
      make_environment(parent, continuation, {rule.slot_names.data(), rule.slot_count});
  clear(rule, made->slots);
  unifier_.set_slot_names({rule.slot_names.data(), rule.slot_count});
  unifier_.begin_fresh_frame({made->slots, rule.slot_count});
  if (!match_steps(rule.head_code, made->slots, args)) return false;
  environment_ = made;
  goal_ = rule.body.entry;
  return true;
}

// Room for the arguments of a query. One within an argument has other registers.
[[gnu::always_inline]] inline Value* Machine::registers_for(const Goal& goal) {
  if (registers_.size() < goal.args().size()) registers_.resize(goal.args().size());
  return registers_.data();
}

[[gnu::always_inline]] inline const Value* Machine::make_arguments(const Goal& goal) {
  const std::span<const Value> terms = goal.args();
  Value* const registers = registers_for(goal);
  Value* const slots = environment_->slots;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    Value made = terms[i];
    if (made.is_slot()) {
      const Value value = slots[made.slot_index()];
      made = value.is_unset() ? unifier_.make_variable(slots, made.slot_index()) : value;
    } else if (!made.is_closed()) {
      made = unifier_.build_term(made, slots);
    }
    registers[i] = made;
  }
  return registers;
}

[[gnu::always_inline]] inline bool Machine::query(const Goal& goal) {
  Relation* const relation = beliefs_->find(goal.predicate);
  if (relation == nullptr) return false;
  if (goal.is_plain && relation->has_few_facts()) return query_few(*relation, goal);
  if (relation->is_folded() && asks_for_all(goal)) {
    return query_answers(*relation->rule_table()->answers(), goal);
  }
  const Value* const args = make_arguments(goal);
  const RuleTable* const table = relation->rule_table();
  if (table == nullptr) return try_rows(*relation, goal, args);
  const RuleCode* const rule = table->only(goal.args().empty() ? Value() : deref(args[0]));
  if (rule == nullptr) return choose_rule(*relation, *table, goal, args);
  return rule->body.entry == nullptr ? match_bodiless(*rule, goal, args)
                                     : enter_framed(*rule, goal, args);
}

}  // namespace jaywalk
