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
  double a = 0;
  double b = 0;
  if (!find_number(goal.left, frame, a) || !find_number(goal.right, frame, b)) return false;
  if (a != a || b != b) return false;
  result = relation_holds(goal.predicate, a, b);
  return true;
}

}  // namespace jaywalk
