// SPDX-License-Identifier: Apache-2.0
// Evaluates arithmetic expressions under a unifier.

#include <array>
#include <limits>

#include "interpreter/logic/unifier/arithmetic.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/print.h"

namespace jaywalk {

// Expressions of numbers, and functions of them that are no queries; deeper terms are left to
// evaluate(), and so is a division by zero.
bool Unifier::is_sum(const Structure& s, const Value* slots, double& result, int depth) {
  constexpr int kDeep = 16;
  if (depth > kDeep) return false;
  if (s.form() == Form::function) return evaluate_function(s, slots, result, depth);
  if (s.form() != Form::expression || s.arity != 2) return false;
  double operands[2];
  for (std::size_t i = 0; i < 2; ++i) {
    Value operand = s.arg(i);
    if (operand.is_slot()) operand = slots[operand.slot_index()];
    operand = deref(operand);
    if (operand.is_number()) {
      operands[i] = operand.as_number();
    } else if (!operand.is_structure() ||
               !is_sum(*operand.structure(), slots, operands[i], depth + 1)) {
      return false;
    }
  }
  if (calculate_usual(s.predicate(), operands[0], operands[1], result)) return true;
  const std::optional<double> value = calculate(s.predicate(), operands[0], operands[1]);
  result = value.value_or(0);
  return value.has_value();
}

// A function of numbers, as most are.
bool Unifier::evaluate_function(const Structure& function, const Value* slots, double& result,
                                int depth) {
  std::array<Value, 2> args;
  if (keep_slots_ || functions_ == nullptr || function.arity > args.size()) return false;
  for (std::size_t i = 0; i < function.arity; ++i) {
    double number = 0;
    if (!is_number(function.arg(i), slots, number, depth + 1)) return false;
    args[i] = Value::number(number);
  }
  Value value;
  if (!functions_->call_of_numbers(function.predicate(), std::span(args).first(function.arity),
                                   value) ||
      !value.is_number()) {
    return false;
  }
  result = value.as_number();
  return true;
}

bool Unifier::is_open(Value term, const Value* slots) const {
  if (term.is_slot() && !keep_slots_) term = slots[term.slot_index()];
  return term.is_unset() || deref(term).is_variable();
}

bool Unifier::evaluate_term(Value term, Value* slots, double& result) {
  if (term.is_slot()) {
    if (keep_slots_) return false;
    term = slots[term.slot_index()];
  }
  term = deref(term);
  if (term.is_slot()) return false;
  if (term.is_number()) {
    result = term.as_number();
    return true;
  }
  if (term.is_variable() || term.is_unset() || term.is_slot()) return false;
  if (is_form(term, Form::function) && functions_ != nullptr) {
    if (evaluate_function(*term.structure(), slots, result, 0)) return true;
    const Value value = instantiate(term, slots);
    if (is_form(value, Form::function)) return false;
    return evaluate(value, slots, result);
  }
  if (!is_form(term, Form::expression)) {
    if (is_form(term, Form::decorated)) return false;
    if (functions_ != nullptr) {
      functions_->warn("arithmetic on " + brief_text(term, symbols_) + ", which is not a number");
    }
    result = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  const TermWalk::Level level(walk_);
  const Structure& s = *term.structure();
  // Nothing is said about the first operand, either, if the second is unknown.
  if (s.arity == 2 && is_open(s.arg(1), slots)) return false;
  double a = 0;
  if (!evaluate(s.arg(0), slots, a)) return false;
  if (s.arity == 1) {
    result = -a;
    return true;
  }
  double b = 0;
  if (!evaluate(s.arg(1), slots, b)) return false;
  if (calculate_usual(s.predicate(), a, b, result)) return true;
  const std::optional<double> value = calculate(s.predicate(), a, b);
  if (!value) throw DivisionByZero{};
  result = *value;
  return true;
}

}  // namespace jaywalk
