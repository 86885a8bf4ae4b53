// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/term_reader.h"

#include <string>

#include "interpreter/compile/translator.h"
#include "interpreter/logic/machine.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/parser.h"

namespace jaywalk {

std::optional<Value> read_term(std::string_view text, ActionCall& call) {
  call.machine().texts().require_room(call.heap(), text.size());
  ast::Arena arena;
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("a string", std::string(text));
  const ast::Node* const node = parse_term(source, arena, diagnostics);
  if (node == nullptr) return std::nullopt;
  VariableScope scope(VariableScope::Kind::variables, call.heap(), call.symbols());
  Translator translator(call.heap(), call.symbols(), call.machine().actions());
  const Value term = translator.term(*node, scope);
  const std::span<const Symbol> names = call.unifier().slot_names();
  for (std::size_t i = 0; i < names.size() && call.slots() != nullptr; ++i) {
    const Value read = scope.find(call.symbols().text(names[i]));
    if (read.is_unset() || names[i] == names::unnamed) continue;
    const Value known = Value::slot(static_cast<std::uint32_t>(i));
    (void)call.unifier().unify(read, call.unifier().instantiate(known, call.slots()));
  }
  return term;
}

bool read_trigger(Value term, ActionCall& call, TriggerParts& parts) {
  if (!term.is_text()) return trigger_parts(term, call.symbols(), parts);
  const std::string text(term.text()->view());
  const std::optional<Value> read = read_term("{" + text + "}", call);
  return read && trigger_parts(*read, call.symbols(), parts);
}

}  // namespace jaywalk
