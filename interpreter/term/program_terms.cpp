// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/program_terms.h"

#include <array>
#include <vector>

namespace jaywalk {
namespace {

struct OperatorName {
  Symbol written;
  std::string_view functor;
};

// `+<b` is `+b`; formulas without an operator are named by their kind.
constexpr std::array kBodyFunctors{
    OperatorName{names::achieve, "achieve"},
    OperatorName{names::achieve_new_focus, "achieveNF"},
    OperatorName{names::test, "test"},
    OperatorName{names::plus, "addBel"},
    OperatorName{names::add_begin, "addBel"},
    OperatorName{names::add_new_focus, "addBelNewFocus"},
    OperatorName{names::add_end, "addBelEnd"},
    OperatorName{names::minus, "delBel"},
    OperatorName{names::remove_new_focus, "delBelNewFocus"},
    OperatorName{names::replace, "delAddBel"},
};

constexpr std::array kFormulaFunctors{
    OperatorName{names::not_text, "not "},
    OperatorName{names::and_text, " & "},
    OperatorName{names::or_text, " | "},
    OperatorName{names::less_text, " < "},
    OperatorName{names::less_equal_text, " <= "},
    OperatorName{names::greater_text, " > "},
    OperatorName{names::greater_equal_text, " >= "},
    OperatorName{names::equal_text, " == "},
    OperatorName{names::not_equal_text, " \\== "},
    OperatorName{names::unify_text, " = "},
    OperatorName{names::univ_text, " =.. "},
};

template <class Table>
std::string_view found_in(const Table& table, Symbol written) {
  for (const OperatorName& each : table) {
    if (each.written == written) return each.functor;
  }
  return "";
}

// The first formula, and what comes behind it.
std::vector<Value> body_parts(Heap& heap, SymbolTable& symbols, const Structure& body) {
  std::vector<Value> parts;
  if (body.arity == 0) return parts;
  parts.push_back(without_operator(body.arg(0)));
  if (body.arity == 1) return parts;
  const auto left = static_cast<std::uint16_t>(body.arity - 1);
  const Value rest =
      heap.structure(symbols.predicate(Signature{.functor = names::body_text, .arity = left}),
                     body.arg_span().subspan(1), Value::empty_list(), Form::body);
  rest.structure()->info |= body.info & Structure::kBare;
  parts.push_back(rest);
  return parts;
}

std::vector<Value> plan_parts_as_data(SymbolTable& symbols, const Structure& plan) {
  std::vector<Value> parts;
  for (std::size_t i = 0; i < 4; ++i) parts.push_back(deref(plan.arg(i)));
  if (parts[0].is_unset()) parts[0] = Value::atom(symbols.predicate("nolabel", 0));
  if (parts[2].is_unset()) parts[2] = Value::atom(predicates::truth);
  return parts;
}

}  // namespace

bool is_program(Value value) {
  if (!value.is_structure()) return false;
  switch (value.structure()->form()) {
    case Form::relation:
    case Form::logical:
    case Form::body:
    case Form::trigger:
    case Form::plan:
    case Form::rule:
      return true;
    default:
      return false;
  }
}

std::string_view formula_functor(Value step, const SymbolTable& symbols) {
  step = deref(step);
  if (!is_form(step, Form::step)) return "action";
  const Symbol op = symbols.signature(step.structure()->predicate()).functor;
  if (op != names::empty) return found_in(kBodyFunctors, op);
  const Value formula = without_operator(step);
  if (is_form(formula, Form::relation)) return "constraint";
  const bool is_named = formula.is_structure() && formula.structure()->form() <= Form::function;
  const bool is_internal = (formula.is_atom() && symbols.signature(formula.atom_id()).dotted) ||
                           (is_named && symbols.signature(formula.structure()->predicate()).dotted);
  return is_internal ? "internalAction" : "action";
}

Value without_operator(Value step) {
  step = deref(step);
  return is_form(step, Form::step) ? deref(step.structure()->arg(0)) : step;
}

std::string_view program_functor(const Structure& program, const SymbolTable& symbols) {
  switch (program.form()) {
    case Form::body:
      return program.arity == 0 ? "none" : formula_functor(program.arg(0), symbols);
    case Form::trigger:
      return "te";
    case Form::plan:
      return "plan";
    default:
      return found_in(kFormulaFunctors, symbols.signature(program.predicate()).functor);
  }
}

Value program_structure(Heap& heap, SymbolTable& symbols, Value program) {
  const Structure& s = *program.structure();
  if (s.form() == Form::rule) return deref(s.arg(0));
  std::vector<Value> parts(s.arg_span().begin(), s.arg_span().end());
  if (s.form() == Form::body) parts = body_parts(heap, symbols, s);
  if (s.form() == Form::plan) parts = plan_parts_as_data(symbols, s);
  if (s.form() == Form::trigger) {
    parts.insert(parts.begin(), heap.text(symbols.functor(s.predicate())));
  }
  const Predicate predicate =
      symbols.predicate(program_functor(s, symbols), static_cast<std::uint16_t>(parts.size()));
  return heap.structure(predicate, parts);
}

}  // namespace jaywalk
