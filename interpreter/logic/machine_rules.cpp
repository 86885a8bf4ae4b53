// Rules: which of them a query may be for, the head, matched with the arguments of the query step
// by step (head_code.h), and the frame.

#include <algorithm>

#include "interpreter/logic/machine.h"

namespace jaywalk {
namespace {

void clear(const RuleCode& rule, Value* slots) {
  for (std::uint32_t i = rule.head_code.first_to_clear(); i < rule.slot_count; ++i) {
    slots[i] = Value();
  }
}

// A value that a variable of a head may take.
bool may_be_taken(Value value) { return !Unifier::is_of_other_namespace(value); }

}  // namespace

// A part of a list.
bool Machine::match_part(const HeadStep& step, Value* slots, Value value) {
  switch (step.kind) {
    case HeadStep::Kind::any:
      return may_be_taken(value);
    case HeadStep::Kind::first:
      slots[step.slot] = value;
      return may_be_taken(value);
    case HeadStep::Kind::again:
      return match_again(value, deref(slots[step.slot]));
    case HeadStep::Kind::constant:
      return value.same_as(step.term) || match_constant(step, slots, value);
    default:
      break;
  }
  return unifier_.match(step.term, slots, value, Unifier::Direction::value_first);
}

bool Machine::match_constant(const HeadStep& step, Value* slots, Value value) {
  if (value.is_variable()) {
    unifier_.bind_young(value.variable(), step.term);
    return true;
  }
  if (value.is_pair() || value.is_atom()) return false;
  return unifier_.match(step.term, slots, value, Unifier::Direction::value_first);
}

bool Machine::match_again(Value value, Value known) {
  if (value.same_as(known)) return true;
  if (value.is_variable() && (known.is_pair() || known.is_number() || known.is_empty_list())) {
    unifier_.bind_young(value.variable(), known);
    return true;
  }
  return unifier_.unify_no_undo(value, known);
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

// The list is taken apart, or made for a variable. Its tail is the first place of a variable.
template <HeadStep::Kind kHead>
[[gnu::always_inline]] inline bool Machine::match_usual_pair(const HeadStep* step, Value* slots,
                                                             Value value) {
  constexpr bool kIsNew = kHead == HeadStep::Kind::first;
  if (value.is_pair()) {
    const Pair& pair = *value.pair();
    const Value head = deref(pair.head);
    if constexpr (kIsNew) {
      slots[step[1].slot] = head;
      if (!may_be_taken(head)) return false;
    } else if (!match_again(head, deref(slots[step[1].slot]))) {
      return false;
    }
    const Value tail = deref(pair.tail);
    slots[step[2].slot] = tail;
    return may_be_taken(tail);
  }
  if (!value.is_variable()) return match_deep_pair(step, slots, value);
  const std::span<const Symbol> names = unifier_.slot_names();
  Value& head = slots[step[1].slot];
  head = kIsNew ? heap().variable(names[step[1].slot]) : deref(head);
  const Symbol name = names[step[2].slot];
  unifier_.bind_young(value.variable(), heap().pair_before(slots[step[2].slot], head, name));
  return true;
}

bool Machine::match_pair(const HeadStep* step, Value* slots, Value value) {
  if (value.is_pair()) {
    const Pair& pair = *value.pair();
    return match_part(step[1], slots, deref(pair.head)) &&
           match_part(step[2], slots, deref(pair.tail));
  }
  if (!value.is_variable()) return match_deep_pair(step, slots, value);
  const Value head = make_part(step[1], slots);
  const Value tail = make_part(step[2], slots);
  unifier_.bind_young(value.variable(), heap().pair(head, tail));
  return true;
}

// A function may still make a list of it.
bool Machine::match_deep_pair(const HeadStep* step, Value* slots, Value value) {
  for (const HeadStep& part : {step[1], step[2]}) {
    if (part.kind == HeadStep::Kind::first) slots[part.slot] = Value();
  }
  return unifier_.match(step->term, slots, value, Unifier::Direction::value_first);
}

[[gnu::always_inline]] inline bool Machine::match_head(const RuleCode& rule, Value* slots,
                                                       const Value* args) {
  using enum HeadStep::Kind;
  const std::vector<HeadStep>& steps = rule.head_code.steps();
  const HeadStep* const end = steps.data() + steps.size();
  for (const HeadStep* step = steps.data(); step != end; ++step) {
    const Value value = deref(args[step->argument]);
    bool matches = false;
    switch (step->kind) {
      case any:
        matches = may_be_taken(value);
        break;
      case first:
        slots[step->slot] = value;
        matches = may_be_taken(value);
        break;
      case again:
        matches = match_again(value, deref(slots[step->slot]));
        break;
      case constant:
        matches = value.same_as(step->term) || match_constant(*step, slots, value);
        break;
      case new_pair:
        matches = match_usual_pair<first>(step, slots, value);
        step += 2;
        break;
      case known_pair:
        matches = match_usual_pair<again>(step, slots, value);
        step += 2;
        break;
      case pair:
        matches = match_pair(step, slots, value);
        step += 2;
        break;
      case term:
        matches = unifier_.match(step->term, slots, value, Unifier::Direction::value_first);
        break;
    }
    if (!matches) return false;
  }
  return true;
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

// The last goal of a rule takes the place of the rule's frame.
bool Machine::enter_framed(const RuleCode& rule, const Goal& goal, const Value* args) {
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
  if (!match_head(rule, made->slots, args)) return false;
  environment_ = made;
  goal_ = rule.body.entry;
  return true;
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
  const bool matches = match_head(rule, slots, args);
  if (unifier_.slots_recorded() != recorded) unifier_.forget(trail, {slots, rule.slot_count});
  frames_.release(start);
  if (!matches) return false;
  use_frame(*environment_);
  goal_ = goal.next;
  return true;
}

}  // namespace jaywalk
