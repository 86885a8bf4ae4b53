// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/plan_reader.h"

#include <array>

#include "interpreter/compile/translator.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/syntax/parser.h"

namespace jaywalk {

Value read_plan(const std::string& text, Heap& heap, SymbolTable& symbols,
                const ActionRegistry& actions, TextsRead& texts, std::string& problem) {
  texts.require_room(heap, text.size());
  const auto source = std::make_shared<const Source>("text", text);
  ast::Arena arena;
  Diagnostics diagnostics;
  const ast::Plan* const plan = parse_plan(source, arena, diagnostics);
  if (plan == nullptr) {
    problem = diagnostics.empty() ? "syntax error" : diagnostics.items().front().message;
    return {};
  }
  VariableScope scope(VariableScope::Kind::variables, heap, symbols);
  return Translator(heap, symbols, actions).plan(*plan, scope);
}

Value plan_of_trigger(Value trigger, Heap& heap, SymbolTable& symbols) {
  TriggerParts parts;
  if (!trigger_parts(trigger, symbols, parts)) return {};
  if (trigger.structure()->form() == Form::body) {
    const Structure& step = *deref(trigger.structure()->arg(0)).structure();
    const Value literal = step.arg(0);
    const std::string op(symbols.functor(step.predicate()));
    trigger = heap.structure(symbols.predicate(op, 1), std::span(&literal, 1), Value::empty_list(),
                             Form::trigger);
  }
  const Value body = heap.structure(symbols.predicate(Signature{.functor = names::body_text}), {},
                                    Value::empty_list(), Form::body);
  const std::array<Value, 6> plan{Value(), trigger, Value(), body, Value(), Value()};
  return heap.structure(symbols.predicate(Signature{.functor = names::plan_text, .arity = 6}), plan,
                        Value::empty_list(), Form::plan);
}

}  // namespace jaywalk
