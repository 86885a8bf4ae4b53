// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>

#include "interpreter/syntax/lexer.h"

namespace jaywalk {
namespace {

using enum TokenKind;

// The names of tokens in diagnostics, in the order of TokenKind.
constexpr std::array<std::string_view, static_cast<std::size_t>(power) + 1> kNames = {
    "the end of the text",
    "something else",
    "a name",
    "a variable",
    "a number",
    "a string",
    "'true'",
    "'false'",
    "'not'",
    "'div'",
    "'mod'",
    "'if'",
    "'elif'",
    "'else'",
    "'for'",
    "'while'",
    "'begin'",
    "'end'",
    "'('",
    "'('",
    "')'",
    "'['",
    "']'",
    "'{'",
    "'}'",
    "'~'",
    "'@'",
    "':'",
    "'<:'",
    "'<-'",
    "':-'",
    "'::'",
    "'.'",
    "','",
    "';'",
    "'|'",
    "'&'",
    "'|&|'",
    "'|||'",
    "'!'",
    "'!!'",
    "'?'",
    "'+'",
    "'-'",
    "'++'",
    "'--'",
    "'-+'",
    "'+<'",
    "'+>'",
    "'^'",
    "'<'",
    "'<='",
    "'>'",
    "'>='",
    "'=='",
    "'\\=='",
    "'='",
    "'=..'",
    "'*'",
    "'/'",
    "'**'"};
static_assert(!kNames.back().empty(), "every kind has a name");

constexpr std::array kTypographic = {
    Typographic{"\u201C", "\"", "write straight quotes, as in \"text\""},
    Typographic{"\u201D", "\"", "write straight quotes, as in \"text\""},
    Typographic{"\u201E", "\"", "write straight quotes, as in \"text\""},
    Typographic{"\u201F", "\"", "write straight quotes, as in \"text\""},
    Typographic{"\u00AB", "\"", "write straight quotes, as in \"text\""},
    Typographic{"\u00BB", "\"", "write straight quotes, as in \"text\""},
    Typographic{"\u2018", "'", "write straight quotes, as in 'name'"},
    Typographic{"\u2019", "'", "write straight quotes, as in 'name'"},
    Typographic{"\u201A", "'", "write straight quotes, as in 'name'"},
    Typographic{"\u2013", "", "write a plain '-'"},
    Typographic{"\u2014", "", "write a plain '-'"},
    Typographic{"\u2212", "", "write a plain '-'"},
    Typographic{"\u2190", "", "write '<-'"},
    Typographic{"\u2192", "", "write '<-', the body of a plan on its right"},
    Typographic{"\u2264", "", "write '<='"},
    Typographic{"\u2265", "", "write '>='"},
    Typographic{"\u2260", "", "write '\\=='"},
    Typographic{"\u00AC", "", "write 'not'"},
    Typographic{"\u2227", "", "write '&'"},
    Typographic{"\u2228", "", "write '|'"},
    Typographic{"\u00A0", "", "write a plain blank: this one keeps lines together"},
    Typographic{"\u200B", "", "delete it: this blank has no width"},
};

}  // namespace

std::string_view name_of(TokenKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

const Typographic* typographic_at(std::string_view text) {
  const auto found = std::ranges::find_if(
      kTypographic, [text](const Typographic& each) { return text.starts_with(each.text); });
  return found == kTypographic.end() ? nullptr : &*found;
}

}  // namespace jaywalk
