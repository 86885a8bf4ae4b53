#include "interpreter/program/event_code.h"

#include <algorithm>

#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {
namespace {

// Constants, and slots each of which stands there once. False: there are other terms.
bool read_head(Value trigger, std::vector<HeadArgument>& head) {
  if (trigger.is_atom()) return true;
  if (trigger.structure()->is_annotated()) return false;
  for (const Value arg : trigger.structure()->arg_span()) {
    const bool is_slot = arg.is_slot();
    if (!is_slot && !arg.is_number() && !arg.is_atom()) return false;
    const HeadArgument made{is_slot ? arg.slot_index() : Operand::kNoSlot, is_slot ? Value() : arg};
    const auto is_same = [&](const HeadArgument& other) { return other.slot == made.slot; };
    if (is_slot && std::any_of(head.begin(), head.end(), is_same)) return false;
    head.push_back(made);
  }
  return true;
}

// False: some argument is another term.
bool read_arguments(Value term, std::vector<Operand>& args) {
  if (term.is_atom()) return true;
  const Structure& literal = *term.structure();
  if (literal.is_annotated() || literal.arity > EventCode::kMostArguments) return false;
  for (const Value arg : literal.arg_span()) {
    args.push_back(Operand::of(arg));
    if (args.back().kind == Operand::Kind::other) return false;
  }
  return true;
}

}  // namespace

PlanHead decode_head(Value trigger) {
  PlanHead made;
  if (is_literal(trigger)) {
    made.predicate = predicate_of(trigger);
    made.is_decoded = read_head(trigger, made.args);
    const auto is_set = [&](const HeadArgument& arg) { return arg.slot == made.first_to_clear; };
    while (std::ranges::any_of(made.args, is_set)) ++made.first_to_clear;
  }
  return made;
}

EventCode decode_event(Value term) {
  EventCode made;
  if (is_literal(term)) {
    made.predicate = predicate_of(term);
    made.is_decoded = read_arguments(term, made.args);
  }
  return made;
}

}  // namespace jaywalk
