// SPDX-License-Identifier: Apache-2.0
#pragma once

// How operators and reserved words are written.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "interpreter/syntax/lexer.h"

namespace jaywalk {

struct Spelling {
  std::string_view text;
  TokenKind kind;
};

// Grouped by their first character, longer ones before those that they begin with.
inline constexpr std::array kOperators = {
    Spelling{"|||", TokenKind::fork_or},
    Spelling{"|&|", TokenKind::fork_and},
    Spelling{"|", TokenKind::bar},
    Spelling{"&", TokenKind::ampersand},
    Spelling{"\\==", TokenKind::not_equal},
    Spelling{"=..", TokenKind::univ},
    Spelling{"==", TokenKind::equal},
    Spelling{"=", TokenKind::unify},
    Spelling{"<:", TokenKind::goal_condition},
    Spelling{"<-", TokenKind::arrow},
    Spelling{"<=", TokenKind::less_equal},
    Spelling{"<", TokenKind::less},
    Spelling{">=", TokenKind::greater_equal},
    Spelling{">", TokenKind::greater},
    Spelling{":-", TokenKind::rule},
    Spelling{"::", TokenKind::double_colon},
    Spelling{":", TokenKind::colon},
    Spelling{"!!", TokenKind::double_bang},
    Spelling{"!", TokenKind::bang},
    Spelling{"?", TokenKind::question},
    Spelling{"++", TokenKind::plus_plus},
    Spelling{"+<", TokenKind::plus_less},
    Spelling{"+>", TokenKind::plus_greater},
    Spelling{"+", TokenKind::plus},
    Spelling{"--", TokenKind::minus_minus},
    Spelling{"-+", TokenKind::minus_plus},
    Spelling{"-", TokenKind::minus},
    Spelling{"**", TokenKind::power},
    Spelling{"*", TokenKind::times},
    Spelling{"/", TokenKind::divide},
    Spelling{"(", TokenKind::open},
    Spelling{")", TokenKind::close},
    Spelling{"[", TokenKind::open_list},
    Spelling{"]", TokenKind::close_list},
    Spelling{"{", TokenKind::open_brace},
    Spelling{"}", TokenKind::close_brace},
    Spelling{"~", TokenKind::tilde},
    Spelling{"@", TokenKind::at},
    Spelling{".", TokenKind::stop},
    Spelling{",", TokenKind::comma},
    Spelling{";", TokenKind::semicolon},
    Spelling{"^", TokenKind::caret},
};

// The index in the table above of the first operator with a first character.
inline constexpr auto kFirstOperator = [] {
  std::array<std::uint8_t, 256> first{};
  first.fill(kOperators.size());
  for (std::size_t i = kOperators.size(); i-- > 0;) {
    first[static_cast<unsigned char>(kOperators[i].text.front())] = static_cast<std::uint8_t>(i);
  }
  return first;
}();

inline constexpr std::array kWords = {
    Spelling{"true", TokenKind::true_word},   Spelling{"false", TokenKind::false_word},
    Spelling{"not", TokenKind::not_word},     Spelling{"div", TokenKind::div_word},
    Spelling{"mod", TokenKind::mod_word},     Spelling{"if", TokenKind::if_word},
    Spelling{"elif", TokenKind::elif_word},   Spelling{"else", TokenKind::else_word},
    Spelling{"for", TokenKind::for_word},     Spelling{"while", TokenKind::while_word},
    Spelling{"begin", TokenKind::begin_word}, Spelling{"end", TokenKind::end_word},
};

inline constexpr std::size_t kLongestWord = 5;

}  // namespace jaywalk
