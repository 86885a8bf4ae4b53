#pragma once

// Operands decoded when a formula is compiled: constants, variables, `N-1`, `X + V`. What is of
// another kind is left to the unifier.

#include <cstdint>

#include "interpreter/term/heap.h"

namespace jaywalk {

/// A constant, the value of a slot, or `N-1`, `X + V`: a sum, difference or product of two
/// slots or numbers. It refers to no cells of a heap but a program's.
struct Operand {
  enum class Kind : std::uint8_t { constant, slot, add, subtract, multiply, other };
  static constexpr std::uint32_t kNoSlot = 0xFFFF'FFFFU;

  /// Of a template; `other` if it is nothing of this kind.
  [[nodiscard]] static Operand of(Value term);

  Kind kind = Kind::other;
  std::uint32_t left_slot = kNoSlot;  // kNoSlot: the number
  std::uint32_t right_slot = kNoSlot;
  Value left;  // a constant itself
  Value right;
};

/// The value of an operand over a frame, if it has one that is closed. False: `value` is what its
/// slot holds, if it is one.
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
  if (operand.kind == Operand::Kind::other) return false;
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
  return true;
}

}  // namespace jaywalk
