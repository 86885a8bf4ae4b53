// SPDX-License-Identifier: Apache-2.0
#pragma once

// The arithmetic operators, on doubles as in Jason.

#include <optional>

#include "interpreter/term/symbol.h"

namespace jaywalk {

/// `op` is one of predicates::add ... predicates::power. `div` truncates both operands to 32-bit
/// integers first; dividing by zero there gives no result (Jason: an exception).
[[nodiscard]] std::optional<double> calculate(Predicate op, double a, double b);

/// The usual operators, in line; false: it is one of the others. By reference, so that operands are
/// loaded where they are used.
[[nodiscard, gnu::always_inline]] inline bool calculate_usual(Predicate op, const double& a,
                                                              const double& b, double& result) {
  switch (op) {
    case predicates::add:
      result = a + b;
      return true;
    case predicates::subtract:
      result = a - b;
      return true;
    case predicates::multiply:
      result = a * b;
      return true;
    default:
      return false;
  }
}

}  // namespace jaywalk
