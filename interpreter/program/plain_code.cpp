#include "interpreter/program/plain_code.h"

#include <algorithm>

#include "interpreter/logic/unifier.h"

namespace jaywalk {
namespace {

// A slot or number as a side of a sum.
bool read_side(Value term, std::uint32_t& slot, Value& number) {
  if (term.is_slot()) {
    slot = term.slot_index();
    return true;
  }
  number = term;
  return term.is_number();
}

Operand::Kind kind_of(Predicate op) {
  switch (op) {
    case predicates::add:
      return Operand::Kind::add;
    case predicates::subtract:
      return Operand::Kind::subtract;
    case predicates::multiply:
      return Operand::Kind::multiply;
    default:
      return Operand::Kind::other;
  }
}

// Of a formula that is a conjunction of such tests; else none.
std::vector<PlainTest> plain_tests(const Goal* formula) {
  std::vector<PlainTest> tests;
  for (; formula != nullptr; formula = formula->next) {
    if (formula->kind != Goal::Kind::compare && formula->kind != Goal::Kind::unify) return {};
    const std::span<const Value> sides = formula->args();
    const PlainTest test{formula->predicate, Operand::of(sides[0]), Operand::of(sides[1])};
    if (test.left.kind == Operand::Kind::other || test.right.kind == Operand::Kind::other) {
      return {};
    }
    tests.push_back(test);
  }
  return tests;
}

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

Operand Operand::of(Value term) {
  Operand made;
  const bool is_cell = term.is_structure() || term.is_pair() || term.is_text();
  if (term.is_number() || term.is_atom() || term.is_empty_list() ||
      (is_cell && term.is_closed() && term.is_static())) {
    made.kind = Kind::constant;
    made.left = term;
  } else if (term.is_slot()) {
    made.kind = Kind::slot;
    made.left_slot = term.slot_index();
  } else if (is_form(term, Form::expression) && term.structure()->arity == 2) {
    const Structure& sum = *term.structure();
    if (read_side(sum.arg(0), made.left_slot, made.left) &&
        read_side(sum.arg(1), made.right_slot, made.right)) {
      made.kind = kind_of(sum.predicate());
    }
  }
  return made;
}

PlainPlan plain_plan(Value trigger, const Goal* context) {
  PlainPlan made;
  if (is_literal(trigger)) {
    made.predicate = predicate_of(trigger);
    made.has_plain_head = read_head(trigger, made.head);
  }
  made.tests = plain_tests(context);
  made.has_plain_context = context == nullptr || !made.tests.empty();
  return made;
}

PlainStep plain_step(Value term, const Goal* condition) {
  PlainStep made;
  made.tests = plain_tests(condition);
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
