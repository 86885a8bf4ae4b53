// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/code/operand.h"

#include "interpreter/logic/unifier/unifier.h"

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
  return made.kind == Kind::other ? Operand{} : made;
}

}  // namespace jaywalk
