// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include "interpreter/agent/step_guard.h"
#include "interpreter/compile/translator.h"
#include "interpreter/logic/action_registry.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/syntax/parser.h"
#include <jaywalk/environment.h>

namespace jaywalk {

namespace {

/// The first variable or arithmetic expression in a literal; null if there is none.
const ast::Node* open_part(const ast::Node& node) {
  const bool is_number =
      node.kind == ast::Kind::unary && node.args[0]->kind == ast::Kind::number;  // -1
  if (node.kind == ast::Kind::variable || (ast::is_arithmetic(node) && !is_number)) return &node;
  for (const ast::Node* const arg : node.args) {
    if (const ast::Node* const open = open_part(*arg)) return open;
  }
  for (const ast::Node* const part : {node.tail, node.annots}) {
    if (part == nullptr) continue;
    if (const ast::Node* const open = open_part(*part)) return open;
  }
  return nullptr;
}

}  // namespace

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
  Value read;
  ActionError limit;
  const bool is_read = guarded(limit, [&] {
    read = Translator(*heap, symbols, no_actions).literal(*node, scope);
    return true;
  });
  if (!is_read) {
    diagnostics.error({source, node->span}, limit.message);
  } else if (!is_literal(read) || !read.is_closed() || ast::is_internal(*node)) {
    const ast::Node* const open = open_part(*node);
    diagnostics.error({source, (open != nullptr ? open : node)->span},
                      "expected a literal without variables and sums, as in at(robot,2)");
  }
  if (diagnostics.has_errors()) return diagnostics;
  GroundLiteral literal(symbols, [&](Terms) { return read; });
  literal.heap_ = std::move(heap);
  return literal;
}

}  // namespace jaywalk
