// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/unifier/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace jaywalk {
namespace {

// Java's narrowing of a double to int: towards zero, saturating, NaN to 0.
std::int64_t to_int(double value) {
  if (std::isnan(value)) return 0;
  constexpr double kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int64_t>(std::clamp(std::trunc(value), kLeast, kMost));
}

}  // namespace

std::optional<double> calculate(Predicate op, double a, double b) {
  double usual = 0;
  if (calculate_usual(op, a, b, usual)) return usual;
  switch (op) {
    case predicates::divide:
      return a / b;
    case predicates::modulo:
      return std::fmod(a, b);
    case predicates::power:
      return std::pow(a, b);
    case predicates::int_divide: {
      const std::int64_t divisor = to_int(b);
      if (divisor == 0) return std::nullopt;
      // Java's int division wraps for the least int by -1.
      return static_cast<double>(static_cast<std::int32_t>(to_int(a) / divisor));
    }
    default:
      return std::nullopt;
  }
}

}  // namespace jaywalk
