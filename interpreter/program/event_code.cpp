// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/event_code.h"

#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {
namespace {

// Whether nothing that a head is matched with is lost: the frame has all of it.
bool tells_all(const HeadCode& code) {
  using enum HeadStep::Kind;
  const std::span<const HeadStep> steps = code.steps();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const HeadStep::Kind kind = steps[i].kind;
    if (kind == new_pair) {
      i += 2;
    } else if (kind != first && kind != constant) {
      return false;
    }
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

PlanHead decode_head(Value trigger, std::span<const Symbol> slot_names,
                     std::span<const std::uint32_t> inherits) {
  PlanHead made;
  if (!is_literal(trigger)) return made;
  made.predicate = predicate_of(trigger);
  made.is_decoded = trigger.is_atom() || !trigger.structure()->is_annotated();
  if (!made.is_decoded) return made;
  made.code = HeadCode::of_plan(trigger, slot_names, inherits);
  made.tells_goal = tells_all(made.code);
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
