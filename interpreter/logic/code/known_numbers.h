#pragma once

// Comparisons of numbers that are known, in line: most tests of a program are of this kind.

#include "interpreter/logic/code/code.h"

namespace jaywalk {

[[nodiscard, gnu::always_inline]] inline bool relation_holds(Predicate relation, double a,
                                                             double b) {
  switch (relation) {
    case predicates::less:
      return a < b;
    case predicates::less_equal:
      return a <= b;
    case predicates::greater:
      return a > b;
    case predicates::greater_equal:
      return a >= b;
    case predicates::equal:
      return a == b;
    default:
      return a != b;
  }
}

/// Whether both sides of a comparison are numbers over this frame; then `result` says whether it
/// holds.
[[nodiscard, gnu::always_inline]] inline bool compare_numbers(const Goal& goal, const Value* frame,
                                                              bool& result) {
  Value left;
  Value right;
  if (!find_value(goal.left, frame, left) || !find_value(goal.right, frame, right) ||
      !left.is_number() || !right.is_number()) {
    return false;
  }
  const double a = left.as_number();
  const double b = right.as_number();
  if (a != a || b != b) return false;
  result = relation_holds(goal.predicate, a, b);
  return true;
}

}  // namespace jaywalk
