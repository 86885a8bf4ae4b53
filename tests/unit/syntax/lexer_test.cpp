// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/lexer.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

// The texts of the tokens, separated by blanks; '#' stands before numbers, '$' before variables.
std::string tokens_of(const std::string& text) {
  const auto source = std::make_shared<const Source>("test", text);
  Diagnostics diagnostics;
  std::string shown;
  for (const Token& token : tokenize(source, diagnostics)) {
    if (token.kind == TokenKind::end_of_text) break;
    if (!shown.empty()) shown += ' ';
    if (token.kind == TokenKind::number) shown += '#';
    if (token.kind == TokenKind::variable) shown += '$';
    if (token.kind == TokenKind::bad) shown += "BAD";
    shown += source->text(token.span);
  }
  return shown;
}

std::string first_error_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto tokens = tokenize(std::make_shared<const Source>("test", text), diagnostics);
  return diagnostics.empty() ? "none" : diagnostics.items().front().message;
}

TEST(Lexer, TakesTheLongestMatch) {
  struct Row {
    const char* text;
    const char* tokens;
  };
  for (const auto& [text, tokens] : {
           Row{"1.", "#1 ."},
           Row{"1.5.", "#1.5 ."},
           Row{".5", "#.5"},
           Row{".5x", ".5x"},
           Row{".1e-5", "#.1e-5"},
           Row{"1e5 1e 2E+3", "#1e5 #1 e #2E+3"},
           Row{"1..2", "#1 . #.2"},
           Row{"12abc", "#12 abc"},
           Row{"b(1).b(2).", "b ( #1 ) .b ( #2 ) ."},
           Row{"a.b.c .print a. b", "a.b.c .print a . b"},
           Row{"X.foo", "$X .foo"},
           Row{"_ _12abc _X Yz_1", "$_ $_12abc $_X $Yz_1"},
           Row{"x:-y", "x :- y"},
           Row{"X<-1", "$X <- #1"},
           Row{"X<:Y", "$X <: $Y"},
           Row{"a|&|b|||c|d", "a |&| b ||| c | d"},
           Row{"X--1 X- -1; -+b", "$X - - #1 $X - - #1 ; -+ b"},
           Row{"a // b\rc // d\r\ne", "a c e"},
           Row{"X\n--b a--b", "$X -- b a -- b"},
           Row{"++b +<b +>b !!g", "++ b +< b +> b !! g"},
           Row{"X=..L X\\==Y X==Y X=Y", "$X =.. $L $X \\== $Y $X == $Y $X = $Y"},
           Row{"2**3*4", "#2 ** #3 * #4"},
           Row{"true.x truex true", "true.x truex true"},
           Row{"'a b' ''c", "'a b' '' c"},
           Row{"a%b", "a BAD% b"},
       }) {
    EXPECT_EQ(tokens_of(text), tokens) << text;
  }
}

TEST(Lexer, SkipsBlanksAndComments) {
  EXPECT_EQ(tokens_of("a // b\nc /* d\n * e */ f /**/ g//"), "a c f g");
  EXPECT_EQ(tokens_of("a /* b /* c */ d"), "a d") << "comments do not nest";
  EXPECT_EQ(tokens_of(""), "");
  EXPECT_EQ(tokens_of("\"a // b\" '/* c'"), "\"a // b\" '/* c'");
}

TEST(Lexer, EndsStringsAtTheFirstUnescapedQuote) {
  EXPECT_EQ(tokens_of(R"("a\"b" c)"), R"("a\"b" c)");
  EXPECT_EQ(tokens_of(R"("a\\" c)"), R"("a\\" c)");
}

TEST(Lexer, SaysWhatIsNoToken) {
  struct Row {
    const char* text;
    const char* message;
  };
  for (const auto& [text, message] : {
           Row{"\"abc", "this string is not closed on its line"},
           Row{"\"abc\n\"", "this string is not closed on its line"},
           Row{"\"abc\\", "this string is not closed on its line"},
           Row{"\"abc\\\n", "this string is not closed on its line"},
           Row{"\"a\\d\"", "unknown escape in a string"},
           Row{"'abc", "this quoted atom is not closed"},
           Row{"a /* b", "this comment is not closed"},
           Row{"a # b", "unexpected character '#'"},
           Row{"\\+ a", "unexpected '\\+'"},
           Row{"ä", "unexpected character outside of a string or quoted atom"},
           Row{"\x01", "unexpected control character 1"},
       }) {
    EXPECT_EQ(first_error_of(text), message) << text;
  }
}

TEST(Lexer, TellsParenthesesAroundBodiesFromThoseAroundFormulas) {
  const auto kind_of_first = [](const std::string& text) {
    Diagnostics diagnostics;
    return tokenize(std::make_shared<const Source>("test", text), diagnostics).front().kind;
  };
  for (const char* text : {"(a; b)", "(a |&| b)", "((a ||| b))", "(!g)", "(if (x) {a})"}) {
    EXPECT_EQ(kind_of_first(text), TokenKind::body_open) << text;
  }
  for (const char* text :
       {"(a & b)", "(f({a; b}) | c)", "((X + 1) * 2)", "([a; b])", "(a. b; c)"}) {
    EXPECT_EQ(kind_of_first(text), TokenKind::open) << text;
  }
}

}  // namespace
}  // namespace jaywalk
