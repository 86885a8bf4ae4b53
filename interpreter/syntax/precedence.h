// SPDX-License-Identifier: Apache-2.0
#pragma once

// How tightly the operators of expressions bind, for the parser and the printer.

#include <cstdint>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

/// From the loosest to the tightest; `primary` needs no parentheses anywhere.
enum class Precedence : std::uint8_t {
  none,
  disjunction,
  conjunction,
  negation,
  relation,
  sum,
  product,
  power,
  sign,
  primary,
};

[[nodiscard]] constexpr Precedence precedence_of(ast::Operator op) {
  using ast::Operator;
  switch (op) {
    case Operator::none:
      return Precedence::none;
    case Operator::logical_or:
      return Precedence::disjunction;
    case Operator::logical_and:
      return Precedence::conjunction;
    case Operator::logical_not:
      return Precedence::negation;
    case Operator::less:
    case Operator::less_equal:
    case Operator::greater:
    case Operator::greater_equal:
    case Operator::equal:
    case Operator::not_equal:
    case Operator::unify:
    case Operator::univ:
      return Precedence::relation;
    case Operator::add:
    case Operator::subtract:
      return Precedence::sum;
    case Operator::multiply:
    case Operator::divide:
    case Operator::int_divide:
    case Operator::modulo:
      return Precedence::product;
    case Operator::power:
      return Precedence::power;
    case Operator::negative:
    case Operator::positive:
      return Precedence::sign;
  }
  return Precedence::none;
}

/// `a & b & c` is `a & (b & c)`; sums and products are left associative, comparisons neither.
[[nodiscard]] constexpr bool is_right_associative(Precedence precedence) {
  return precedence == Precedence::disjunction || precedence == Precedence::conjunction ||
         precedence == Precedence::power;
}

}  // namespace jaywalk
