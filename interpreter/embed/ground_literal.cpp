// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include "interpreter/compile/translator.h"
#include "interpreter/logic/action_registry.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/syntax/parser.h"
#include <jaywalk/environment.h>

namespace jaywalk {

GroundLiteral::GroundLiteral(SymbolTable& symbols, const std::function<Value(Terms)>& make)
    : heap_(std::make_unique<Heap>()) {
  const Value literal = make(Terms(*heap_, symbols));
  const LiteralParts parts = literal_parts(literal);
  predicate_ = parts.predicate;
  args_ = parts.args;
  annotations_ = parts.annots;
}
GroundLiteral::GroundLiteral(GroundLiteral&&) noexcept = default;
GroundLiteral& GroundLiteral::operator=(GroundLiteral&&) noexcept = default;
GroundLiteral::~GroundLiteral() = default;

Result<GroundLiteral> GroundLiteral::read(SymbolTable& symbols, const std::string& name,
                                          const std::string& text) {
  const auto source = std::make_shared<const Source>(name, text);
  ast::Arena arena;
  Diagnostics diagnostics;
  const ast::Node* const node = parse_literal(source, arena, diagnostics);
  if (node == nullptr || diagnostics.has_errors()) return diagnostics;
  auto heap = std::make_unique<Heap>();
  const ActionRegistry no_actions;
  VariableScope scope(VariableScope::Kind::variables, *heap, symbols);
  const Value read = Translator(*heap, symbols, no_actions).literal(*node, scope);
  if (!is_literal(read) || !read.is_closed()) {
    diagnostics.error({source, Span{0, static_cast<std::uint32_t>(text.size())}},
                      "expected a literal without variables and sums, as in at(robot,2)");
    return diagnostics;
  }
  GroundLiteral literal(symbols, [&](Terms) { return read; });
  literal.heap_ = std::move(heap);
  return literal;
}

}  // namespace jaywalk
