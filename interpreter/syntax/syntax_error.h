// SPDX-License-Identifier: Apache-2.0
#pragma once

// Makes a readable diagnostic of "the parser expected X at token N", and finds the place where the
// parser can go on. Knows the mistakes that people make, those coming from Prolog above all.

#include <span>
#include <string>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/lexer.h"

namespace jaywalk {

struct SyntaxError {
  SourcePtr source;
  std::span<const Token> tokens;
  /// The first token of the clause in which the parser failed, and the one at which it did.
  const Token* clause = nullptr;
  const Token* found = nullptr;
  /// The token or rule that the grammar expected: `'.'`, `a term`.
  std::string expected;
};

/// Adds one diagnostic (none if the lexer has complained about the token already) and returns the
/// token at which the next clause may begin, which lies behind `clause`.
[[nodiscard]] const Token* report(const SyntaxError& error, Diagnostics& diagnostics);

/// The token behind the next full stop at or behind `from`, or one that begins or ends a block.
/// REQUIRES: `from` is not before `clause`.
[[nodiscard]] const Token* next_clause(std::span<const Token> tokens, const Token* clause,
                                       const Token* from);

}  // namespace jaywalk
