// SPDX-License-Identifier: Apache-2.0
#pragma once

// Operands decoded when a formula is compiled: constants, variables, `N-1`, `X + V`. What is of
// another kind is left to the unifier.

#include <cstdint>

#include "interpreter/term/heap.h"

namespace jaywalk {

/// A constant, the value of a slot, or `N-1`, `X + V`: a sum, difference or product of two
/// slots or numbers. It refers to no cells of a heap but a program's.
struct Operand {
  enum class Kind : std::uint8_t { constant, slot, add, subtract, multiply, other };  // in order
  static constexpr std::uint32_t kNoSlot = 0xFFFF'FFFFU;

  /// The operand for a template; `other` if it is of another kind.
  [[nodiscard]] static Operand of(Value term);

  Kind kind = Kind::other;
  std::uint32_t left_slot = kNoSlot;  // kNoSlot: the number
  std::uint32_t right_slot = kNoSlot;
  Value left;  // a constant itself
  Value right;
};

/// The number that an operand comes to over a frame. False: it is something else, or not known.
[[nodiscard, gnu::always_inline]] inline bool find_number(const Operand& operand,
                                                          const Value* frame, double& number) {
  Value side = operand.left;
  if (operand.left_slot != Operand::kNoSlot) side = deref(frame[operand.left_slot]);
  if (!side.is_number()) return false;
  number = side.as_number();
  if (operand.kind <= Operand::Kind::slot) return true;
  side = operand.right;
  if (operand.right_slot != Operand::kNoSlot) side = deref(frame[operand.right_slot]);
  if (!side.is_number()) return false;
  if (operand.kind == Operand::Kind::subtract) {
    number -= side.as_number();
  } else if (operand.kind == Operand::Kind::add) {
    number += side.as_number();
  } else {
    number *= side.as_number();
  }
  return true;
}

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
  double number = 0;
  if (!find_number(operand, frame, number)) return false;
  value = Value::number(number);
  return true;
}

}  // namespace jaywalk
