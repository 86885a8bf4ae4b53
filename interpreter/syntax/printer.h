// SPDX-License-Identifier: Apache-2.0
#pragma once

// Syntax tree to text, in Jason's notation: what is printed parses back to the same tree. Read
// ast.h first. (What running agents print of their values is the engine's concern.)

#include <string>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

/// A term or formula on one line, with the parentheses that were written and those that it needs.
[[nodiscard]] std::string print(const ast::Node& node);

/// A formula of a body; statements as `if (c) { a } else { b }`.
[[nodiscard]] std::string print(const ast::Formula& formula);

[[nodiscard]] std::string print(const ast::Trigger& trigger);

/// A plan on one line, with its full stop and, behind it, its sub-plans.
[[nodiscard]] std::string print(const ast::Plan& plan);

/// A component of a program; those within a block are on lines of their own.
[[nodiscard]] std::string print(const ast::Component& component);

/// A whole program, a component on each line. Comments are not part of the tree.
[[nodiscard]] std::string print(const ast::File& file);

}  // namespace jaywalk
