// SPDX-License-Identifier: Apache-2.0
#pragma once

// Text to tokens, by the longest match. The parser (grammar.cpp) reads a program as a sequence of
// these and sees no blanks and comments.

#include <cstdint>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

enum class TokenKind : std::uint8_t {
  end_of_text,
  bad,  // not a token; already diagnosed
  atom,
  variable,
  number,
  string,
  // reserved words
  true_word,
  false_word,
  not_word,
  div_word,
  mod_word,
  if_word,
  elif_word,
  else_word,
  for_word,
  while_word,
  begin_word,
  end_word,  // which may be atoms, too
  // brackets; body_open is a '(' around a plan body, `(a ||| b)`, not around a formula
  open,
  body_open,
  close,
  open_list,
  close_list,
  open_brace,
  close_brace,
  // ~ @ : <: <- :- :: . , ;
  tilde,
  at,
  colon,
  goal_condition,
  arrow,
  rule,
  double_colon,
  stop,
  comma,
  semicolon,
  // | & |&| |||
  bar,
  ampersand,
  fork_and,
  fork_or,
  // ! !! ? + - ++ -- -+ +< +> ^
  bang,
  double_bang,
  question,
  plus,
  minus,
  plus_plus,
  minus_minus,
  minus_plus,
  plus_less,
  plus_greater,
  caret,
  // < <= > >= == \== = =.. * / **
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  unify,
  univ,
  times,
  divide,
  power,
};

struct Token {
  TokenKind kind = TokenKind::end_of_text;
  Span span;
};

/// The tokens of a text; the last one is end_of_text. What is no token becomes a diagnostic.
[[nodiscard]] std::vector<Token> tokenize(const SourcePtr& source, Diagnostics& diagnostics);

/// The token as a reader of diagnostics calls it: `'<-'`, `a string`, `the end of the text`.
[[nodiscard]] std::string_view name_of(TokenKind kind);

struct Typographic {
  std::string_view text;
  std::string_view meant;  // the quotes; else empty
  std::string_view hint;
};

/// The one that a text begins with, or null.
[[nodiscard]] const Typographic* typographic_at(std::string_view text);

}  // namespace jaywalk
