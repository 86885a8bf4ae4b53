// SPDX-License-Identifier: Apache-2.0
#pragma once

// Text to syntax tree. The grammar (Boost.Spirit X3) is in grammar.cpp alone. Every parse collects
// its errors as diagnostics, several per text, since it goes on after the next full stop.

#include <memory>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk {

/// Terms, formulas and bodies nested deeper than this are refused with a diagnostic.
inline constexpr int kMaxNesting = 1000;

/// A whole program, an `.asl` file. What could be parsed is returned even if there are errors.
[[nodiscard]] ast::File parse_agent(SourcePtr source, Diagnostics& diagnostics);

/// The entry points for texts at run time (`.term2string`, `.add_plan`, options of a project,
/// values of a scenario). Each parses the whole text, without a final stop (a plan: with or
/// without), and returns null after adding diagnostics if that is not possible.
/// The node lives in `arena`, its texts in `source` or `arena`; both must outlive it.
[[nodiscard]] const ast::Node* parse_term(const SourcePtr& source, ast::Arena& arena,
                                          Diagnostics& diagnostics);
[[nodiscard]] const ast::Node* parse_literal(const SourcePtr& source, ast::Arena& arena,
                                             Diagnostics& diagnostics);
[[nodiscard]] const ast::Plan* parse_plan(const SourcePtr& source, ast::Arena& arena,
                                          Diagnostics& diagnostics);
/// Literals separated by commas, as in `beliefs="a(1),b"` of a project; a list node.
[[nodiscard]] const ast::Node* parse_literals(const SourcePtr& source, ast::Arena& arena,
                                              Diagnostics& diagnostics);

}  // namespace jaywalk
