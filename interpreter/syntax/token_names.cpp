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

}  // namespace

std::string_view name_of(TokenKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

}  // namespace jaywalk
