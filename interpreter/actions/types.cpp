// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/actions.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

// Everything with a functor but arithmetic and variables.
bool is_code(Value value) {
  return value.is_structure() && !is_form(value, Form::expression) &&
         !is_form(value, Form::function) && !is_form(value, Form::decorated);
}

bool is_plain_atom(Value value, const SymbolTable& symbols) {
  return value.is_atom() && !symbols.signature(value.atom_id()).negated &&
         !symbols.signature(value.atom_id()).dotted;
}

bool is_any_literal(Value value) { return value.is_atom() || is_code(value); }

bool is_any_structure(Value value, const SymbolTable& symbols) {
  return value.is_list() || is_code(value) || (value.is_atom() && !is_plain_atom(value, symbols));
}

bool is_kind(Value value, Object::Kind kind) {
  return value.is_object() && value.object()->object->kind() == kind;
}

bool is_numeric(Value value) {
  return value.is_number() || is_form(value, Form::expression) || is_form(value, Form::function);
}

bool is_free(Value value) { return value.is_variable() || is_form(value, Form::decorated); }

}  // namespace

Outcome atom(ActionCall& call) { return when(is_plain_atom(call.arg(0), call.symbols())); }
// As in Jason a rule is never ground.
Outcome ground(ActionCall& call) {
  return when(!is_form(call.arg(0), Form::rule) && is_ground(call.arg(0)));
}
Outcome list(ActionCall& call) { return when(call.arg(0).is_list()); }
Outcome literal(ActionCall& call) { return when(is_any_literal(call.arg(0))); }
Outcome number(ActionCall& call) { return when(is_numeric(call.arg(0))); }
Outcome string(ActionCall& call) { return when(call.arg(0).is_text()); }
Outcome structure(ActionCall& call) { return when(is_any_structure(call.arg(0), call.symbols())); }

Outcome internal_action(ActionCall& call) {
  const Value value = call.arg(0);
  if (!is_literal(value) && !is_form(value, Form::function)) return Outcome::failed;
  const Predicate predicate = value.is_atom() ? value.atom_id() : value.structure()->predicate();
  return when(call.symbols().signature(predicate).dotted);
}

Outcome type(ActionCall& call) {
  const Value value = call.arg(0);
  SymbolTable& symbols = call.symbols();
  std::vector<Value> types;
  const auto add = [&](bool holds, std::string_view name) {
    if (holds) types.push_back(Value::atom(symbols.predicate(name, 0)));
  };
  // From the most primitive types to the less primitive, as Jason has them.
  add(is_numeric(value), "number");
  add(is_plain_atom(value, symbols), "atom");
  add(is_any_literal(value), "literal");
  add(value.is_text(), "string");
  add(value.is_list(), "list");
  add(is_kind(value, Object::Kind::set), "set");
  add(is_kind(value, Object::Kind::map), "map");
  add(is_any_structure(value, symbols), "structure");
  add(is_form(value, Form::rule), "rule");
  add(is_form(value, Form::body), "plan");
  add(is_kind(value, Object::Kind::queue), "queue");
  add(is_ground(value), "ground");
  add(is_free(value), "free");
  return call.many(std::make_unique<ValueSolutions>(1, std::move(types)));
}

}  // namespace jaywalk::actions
