// SPDX-License-Identifier: Apache-2.0
#pragma once

// Comparisons of numbers that are known, in line: most tests of a program are of this kind.

#include "interpreter/logic/code/code.h"

namespace jaywalk {

/// How two numbers stand to each other, a bit for each way.
using Orders = std::uint8_t;
inline constexpr Orders kLess = 1;
inline constexpr Orders kEqual = 2;
inline constexpr Orders kGreater = 4;

/// In which orders a comparison holds.
[[nodiscard]] constexpr Orders orders_of(Predicate relation) {
  switch (relation) {
    case predicates::less:
      return kLess;
    case predicates::less_equal:
      return kLess | kEqual;
    case predicates::greater:
      return kGreater;
    case predicates::greater_equal:
      return kGreater | kEqual;
    case predicates::equal:
      return kEqual;
    default:
      return kLess | kGreater;
  }
}

/// 0: one of them is not a number.
[[nodiscard, gnu::always_inline]] inline Orders order_of(double a, double b) {
  if (a < b) return kLess;
  if (a > b) return kGreater;
  return a == b ? kEqual : 0;
}

/// Whether both sides of a comparison are numbers over this frame; then `result` says whether it
/// holds.
[[nodiscard, gnu::always_inline]] inline bool compare_numbers(const Goal& goal, const Value* frame,
                                                              bool& result) {
  double a = 0;
  double b = 0;
  if (!find_number(goal.left, frame, a) || !find_number(goal.right, frame, b)) return false;
  const Orders order = order_of(a, b);
  result = (order & goal.orders) != 0;
  return order != 0;
}

}  // namespace jaywalk
