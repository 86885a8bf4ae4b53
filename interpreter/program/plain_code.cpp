#include "interpreter/program/plain_code.h"

#include <algorithm>

#include "interpreter/logic/unifier.h"

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

}  // namespace

PlainPlan plain_plan(Value trigger) {
  PlainPlan made;
  if (is_literal(trigger)) {
    made.predicate = predicate_of(trigger);
    made.has_plain_head = read_head(trigger, made.head);
  }
  return made;
}

PlainStep plain_step(Value term) {
  PlainStep made;
  if (!is_form(term, Form::literal) || term.structure()->is_annotated()) return made;
  for (const Value arg : term.structure()->arg_span()) {
    made.args.push_back(Operand::of(arg));
    if (made.args.back().kind != Operand::Kind::other) continue;
    made.args.clear();
    break;
  }
  return made;
}

}  // namespace jaywalk
