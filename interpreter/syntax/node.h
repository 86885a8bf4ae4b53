#pragma once

// Questions about a node of the syntax tree that its kind alone does not answer.

#include <string_view>

#include "interpreter/syntax/ast.h"

namespace jaywalk::ast {

/// `.print`, `my.action`, `math.max`: a literal that is an internal action or a function.
[[nodiscard]] inline bool is_internal(const Node& node) {
  return node.kind == Kind::literal && node.dotted;
}

/// An operation whose value is a number.
[[nodiscard]] bool is_arithmetic(const Node& node);

/// The name of the node in diagnostics: "a number", "an internal action".
[[nodiscard]] std::string_view description_of(const Node& node);

}  // namespace jaywalk::ast
