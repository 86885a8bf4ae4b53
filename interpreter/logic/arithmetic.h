#pragma once

// The arithmetic operators, on doubles as in Jason.

#include <optional>

#include "interpreter/term/symbol.h"

namespace jaywalk {

/// `op` is one of predicates::add ... predicates::power. `div` truncates both operands to 32-bit
/// integers first; dividing by zero there gives no result (Jason: an exception).
[[nodiscard]] std::optional<double> calculate(Predicate op, double a, double b);

}  // namespace jaywalk
