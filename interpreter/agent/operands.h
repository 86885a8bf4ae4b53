#pragma once

// Operands and tests over a frame (program/plain_code.h), in line: `N-1`, `N > 0`, `Next = X + V`.

#include "interpreter/logic/arithmetic.h"
#include "interpreter/logic/unifier.h"
#include "interpreter/program/plain_code.h"

namespace jaywalk {

/// Of a condition. `open`: it is not decided here, and nothing has changed.
enum class Decision : std::uint8_t { fails, holds, open };

/// A comparison of two values that are known; open if it is not one of numbers or atoms.
[[nodiscard, gnu::always_inline]] inline Decision compare_known(Predicate op, Value left,
                                                                Value right) {
  bool holds = false;
  if (left.is_number() && right.is_number()) {
    const double a = left.as_number();
    const double b = right.as_number();
    if (a != a || b != b) return Decision::open;
    switch (op) {
      case predicates::less:
        holds = a < b;
        break;
      case predicates::less_equal:
        holds = a <= b;
        break;
      case predicates::greater:
        holds = a > b;
        break;
      case predicates::greater_equal:
        holds = a >= b;
        break;
      case predicates::equal:
        holds = a == b;
        break;
      default:
        holds = a != b;
        break;
    }
  } else if (left.is_atom() && right.is_atom() &&
             (op == predicates::equal || op == predicates::not_equal)) {
    holds = left.same_as(right) == (op == predicates::equal);
  } else {
    return Decision::open;
  }
  return holds ? Decision::holds : Decision::fails;
}

/// Whether two values that are known unify; open if they are not numbers or atoms.
[[nodiscard, gnu::always_inline]] inline Decision unify_known(Value left, Value right) {
  bool equal = false;
  if (left.is_number() && right.is_number()) {
    equal = left.as_number() == right.as_number() || left.same_as(right);
  } else if (left.is_atom() && right.is_atom()) {
    equal = left.same_as(right);
  } else {
    return Decision::open;
  }
  return equal ? Decision::holds : Decision::fails;
}

/// The value of an operand, if it has one that is closed.
[[nodiscard, gnu::always_inline]] inline bool find_value(const Operand& operand, const Value* frame,
                                                         Value& value) {
  if (operand.kind == Operand::Kind::slot) {
    value = deref(frame[operand.left_slot]);
    return value.is_closed() && !value.is_unset();
  }
  if (operand.kind == Operand::Kind::constant) {
    value = operand.left;
    return true;
  }
  const auto side = [frame](std::uint32_t slot, Value number) {
    return slot == Operand::kNoSlot ? number : deref(frame[slot]);
  };
  const Value left = side(operand.left_slot, operand.left);
  const Value right = side(operand.right_slot, operand.right);
  if (!left.is_number() || !right.is_number()) return false;
  const double a = left.as_number();
  const double b = right.as_number();
  if (operand.kind == Operand::Kind::subtract) {
    value = Value::number(a - b);
  } else if (operand.kind == Operand::Kind::add) {
    value = Value::number(a + b);
  } else {
    value = Value::number(a * b);
  }
  return operand.kind != Operand::Kind::other;
}

/// A test in a frame that is only being tried: what it sets there need not be undone.
[[nodiscard, gnu::always_inline]] inline Decision decide(const PlainTest& test, Value* frame) {
  Value left;
  Value right;
  if (!find_value(test.right, frame, right)) return Decision::open;
  if (test.op != predicates::unify) {
    return find_value(test.left, frame, left) ? compare_known(test.op, left, right)
                                              : Decision::open;
  }
  if (test.left.kind == Operand::Kind::slot && frame[test.left.left_slot].is_unset()) {
    if (Unifier::is_of_other_namespace(right)) return Decision::open;
    frame[test.left.left_slot] = right;
    return Decision::holds;
  }
  return find_value(test.left, frame, left) ? unify_known(left, right) : Decision::open;
}

}  // namespace jaywalk
