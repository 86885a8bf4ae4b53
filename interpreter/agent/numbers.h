#pragma once

// Arithmetic over a frame with the usual operands in line: `N-1`, `X + V`.

#include "interpreter/logic/arithmetic.h"
#include "interpreter/logic/unifier.h"

namespace jaywalk {

/// A number, or a slot with one.
[[nodiscard, gnu::always_inline]] inline bool is_known_number(Value term, const Value* frame,
                                                              double& number) {
  if (term.is_slot()) term = deref(frame[term.slot_index()]);
  if (!term.is_number()) return false;
  number = term.as_number();
  return true;
}

/// The value of an expression over such operands; false, without a warning, if it has none or is
/// something else. The depth of calls is that of the program's text.
[[nodiscard]] bool evaluate_nested(Value expression, const Value* frame, double& number);
[[nodiscard, gnu::always_inline]] inline bool evaluate_known(Value expression, const Value* frame,
                                                             double& number) {
  if (!is_form(expression, Form::expression)) return false;
  const Structure& s = *expression.structure();
  double a = 0;
  double b = 0;
  if (s.arity == 2 && is_known_number(s.arg(0), frame, a) && is_known_number(s.arg(1), frame, b) &&
      calculate_usual(s.predicate(), a, b, number)) {
    return true;
  }
  return evaluate_nested(expression, frame, number);
}

/// The value of an operand that is a constant, bound to something closed, or a number to be
/// computed; false: it is something else.
[[nodiscard, gnu::always_inline]] inline bool known_operand(Value term, const Value* frame,
                                                            Value& value) {
  if (term.is_slot()) {
    value = deref(frame[term.slot_index()]);
    return value.is_closed() && !value.is_unset();
  }
  if (term.is_closed()) {
    value = term;
    return true;
  }
  double number = 0;
  if (!evaluate_known(term, frame, number)) return false;
  value = Value::number(number);
  return true;
}

}  // namespace jaywalk
