// SPDX-License-Identifier: Apache-2.0
// Rules: which of them a query may be for, the head, matched with the arguments of the query step
// by step (head_code.h), and the frame.

#include <algorithm>

#include "interpreter/logic/machine_inline.h"

namespace jaywalk {
namespace {

using head_values::may_be_taken;

// For a rule the query's annotations must be among those of the head, for a plan the reverse.
Unifier::Direction direction_of(const HeadCode& code) {
  return code.is_of_plan() ? Unifier::Direction::template_first : Unifier::Direction::value_first;
}

}  // namespace

bool Machine::match_term(const HeadCode& code, const HeadStep& step, Value* slots, Value value) {
  return unifier_.match(step.term, slots, value, direction_of(code));
}

bool Machine::match_head(const HeadCode& code, Value* slots, const Value* args) {
  return match_steps(code, slots, args);
}

// A part of a list.
bool Machine::match_part(const HeadCode& code, const HeadStep& step, Value* slots, Value value) {
  switch (step.kind) {
    case HeadStep::Kind::any:
      return may_be_taken(value);
    case HeadStep::Kind::first:
      slots[step.slot] = value;
      return may_be_taken(value);
    case HeadStep::Kind::again:
      return match_again(code, value, deref(slots[step.slot]));
    case HeadStep::Kind::constant:
      return value.same_as(step.term) || match_constant(code, step, slots, value);
    default:
      break;
  }
  return match_term(code, step, slots, value);
}

bool Machine::match_constant(const HeadCode& code, const HeadStep& step, Value* slots,
                             Value value) {
  if (value.is_variable()) {
    unifier_.bind_young(value.variable(), step.term);
    return true;
  }
  if (value.is_pair() || value.is_atom()) return false;
  if (!match_term(code, step, slots, value)) return false;
  if (code.is_of_plan() && value.is_structure()) head_loses_annotations_ = true;
  return true;
}

bool Machine::match_again(const HeadCode& code, Value value, Value known) {
  if (value.same_as(known)) return true;
  if (value.is_variable() && (known.is_pair() || known.is_number() || known.is_empty_list())) {
    unifier_.bind_young(value.variable(), known);
    return true;
  }
  return code.is_of_plan() ? unifier_.unify_no_undo(known, value)
                           : unifier_.unify_no_undo(value, known);
}

Value Machine::make_part(const HeadStep& step, Value* slots) {
  switch (step.kind) {
    case HeadStep::Kind::any:
      return heap().variable(unifier_.slot_names()[step.slot]);
    case HeadStep::Kind::first:
      return slots[step.slot] = heap().variable(unifier_.slot_names()[step.slot]);
    case HeadStep::Kind::again:
      return deref(slots[step.slot]);
    case HeadStep::Kind::constant:
      return step.term;
    default:
      break;
  }
  return unifier_.build(step.term, slots);
}

bool Machine::match_pair(const HeadCode& code, const HeadStep* step, Value* slots, Value value) {
  if (value.is_pair()) {
    const Pair& pair = *value.pair();
    return match_part(code, step[1], slots, deref(pair.head)) &&
           match_part(code, step[2], slots, deref(pair.tail));
  }
  if (!value.is_variable()) return match_deep_pair(code, step, slots, value);
  const Value head = make_part(step[1], slots);
  const Value tail = make_part(step[2], slots);
  unifier_.bind_young(value.variable(), heap().pair(head, tail));
  return true;
}

// A function may still make a list of it.
bool Machine::match_deep_pair(const HeadCode& code, const HeadStep* step, Value* slots,
                              Value value) {
  for (const HeadStep& part : {step[1], step[2]}) {
    if (part.kind == HeadStep::Kind::first) slots[part.slot] = Value();
  }
  return match_term(code, *step, slots, value);
}

// The kind of the first argument leaves several rules, or none.
bool Machine::choose_rule(Relation& relation, const RuleTable& table, const Goal& goal,
                          const Value* args) {
  const std::span<const RuleTable::Candidate> candidates = table.candidates();
  const std::uint32_t key = goal.args().empty() ? 0 : argument_key(args[0]);
  const auto may_match = [&](const RuleTable::Candidate& candidate) {
    return candidate.may_match(key, args);
  };
  const auto first = std::find_if(candidates.begin(), candidates.end(), may_match);
  if (first == candidates.end()) return false;
  const auto next = std::find_if(first + 1, candidates.end(), may_match);
  if (next != candidates.end()) {
    const std::int64_t seq = relation.end_seq() - 1 - (next - candidates.begin());
    push_rows(relation, Relation::cursor_at(seq, key), goal, args);
  }
  return enter_rule(*first->rule, goal, args);
}

bool Machine::enter_rule(const RuleCode& rule, const Goal& goal, const Value* args) {
  return rule.body.entry == nullptr ? match_bodiless(rule, goal, args)
                                    : enter_framed(rule, goal, args);
}

// The slots of a rule without a body are needed while its head is matched, and no longer.
bool Machine::match_bodiless(const RuleCode& rule, const Goal& goal, const Value* args) {
  const FrameStack::Mark start = frames_.mark();
  const std::size_t trail = unifier_.mark();
  const std::uint32_t recorded = unifier_.slots_recorded();
  auto* const slots = reinterpret_cast<Value*>(allocate_frame(rule.slot_count));
  clear(rule, slots);
  unifier_.set_slot_names({rule.slot_names.data(), rule.slot_count});
  unifier_.begin_fresh_frame({slots, rule.slot_count});
  const bool matches = match_head(rule.head_code, slots, args);
  if (unifier_.slots_recorded() != recorded) unifier_.forget(trail, {slots, rule.slot_count});
  frames_.release(start);
  if (!matches) return false;
  use_frame(*environment_);
  goal_ = goal.next;
  return true;
}

}  // namespace jaywalk
