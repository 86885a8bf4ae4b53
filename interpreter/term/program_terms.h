// SPDX-License-Identifier: Apache-2.0
#pragma once

// Programs as data are structures, too, as which they are unified with structures, taken apart by
// `=..` and ordered, as in Jason:
//
//   { !g; ?q }              achieve(g, { ?q }), and so on for each kind of formula; { } is none
//   { +!g }                 te("+!", g)
//   { @l +!g : c <- b }     plan(l, { +!g }, c, { b })
//   { h :- b }              h
//   a & b, a > b, not a     ' & '(a, b), ' > '(a, b), 'not '(a)

#include <string_view>

#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

/// Whether a dereferenced value is a program or formula as data.
[[nodiscard]] bool is_program(Value value);

/// The value as a literal: a rule's head; other dereferenced values themselves.
[[nodiscard]] inline Value as_literal(Value value) {
  return is_form(value, Form::rule) ? deref(value.structure()->arg(0)) : value;
}

/// The functor of a program or formula as data. REQUIRES: is_program, and no rule.
[[nodiscard]] std::string_view program_functor(const Structure& program,
                                               const SymbolTable& symbols);

/// The functor of a body that begins with this formula, and the formula without its operator.
[[nodiscard]] std::string_view formula_functor(Value step, const SymbolTable& symbols);
[[nodiscard]] Value without_operator(Value step);

/// A program or formula as data as the literal that it is. REQUIRES: is_program.
[[nodiscard]] Value program_structure(Heap& heap, SymbolTable& symbols, Value program);

}  // namespace jaywalk
