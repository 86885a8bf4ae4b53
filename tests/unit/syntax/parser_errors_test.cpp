// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/syntax/parser.h"
#include "tests/unit/syntax/outline.h"

namespace jaywalk {
namespace {

// The errors of a program as `line:column: message (hint)`, a line each.
std::string errors_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("test", text);
  const ast::File file = parse_agent(source, diagnostics);
  std::string shown;
  for (const Diagnostic& item : diagnostics.items()) {
    const auto [line, column] = source->position(item.where.span.begin);
    shown += std::to_string(line) + ":" + std::to_string(column) + ": " + item.message;
    if (!item.hint.empty()) shown += " (" + item.hint + ")";
    shown += "\n";
  }
  return shown;
}

struct ParserErrorRow {
  const char* text;
  const char* errors;
};

TEST(ParserErrors, PointBehindTheClauseWhoseFullStopIsMissing) {
  for (const auto& [text, errors] : {
           ParserErrorRow{
               "b(1)\nb(2).",
               "1:5: expected '.' at the end of this clause (the next clause seems to begin on "
               "line 2)\n"},
           ParserErrorRow{
               "+!g <- a; b\n+!h <- c.",
               "1:12: expected '.' at the end of this clause (the next clause seems to begin on "
               "line 2)\n"},
           ParserErrorRow{
               "+!g <- a; b(X)\n\n// h\n@l +!h <- c.",
               "1:15: expected '.' at the end of this clause (the next clause seems to begin on "
               "line 4)\n"},
           ParserErrorRow{
               "+!g <- a\n+b : c <- d.",
               "1:9: expected '.' at the end of this clause (the next clause seems to begin on "
               "line 2)\n"},
           ParserErrorRow{
               "!go\n!come.",
               "1:4: expected '.' at the end of this clause (the next clause seems to begin on "
               "line 2)\n"},
           ParserErrorRow{
               "b :- c\n{ include(\"x\") }",
               "1:7: expected '.' at the end of this clause (the next clause seems to begin on "
               "line 2)\n"},
       }) {
    EXPECT_EQ(errors_of(text), errors) << text;
  }
}

TEST(ParserErrors, KnowTheNotationOfOtherLanguages) {
  for (const auto& [text, errors] : {
           ParserErrorRow{"+!g := a.",
                          "1:5: unexpected ':=' (the body of a plan begins with '<-')\n"},
           ParserErrorRow{"+!g -> a.",
                          "1:5: expected ':', '<-' or '.', found '->' (the body of a plan begins "
                          "with '<-')\n"},
           ParserErrorRow{
               "+!g => a.",
               "1:5: expected ':', '<-' or '.', found '=>' (the body of a plan begins with '<-', "
               "greater or equal is '>=')\n"},
           ParserErrorRow{
               "+!g <- X is 1.",
               "1:10: expected ';' or '.', found 'is' (arithmetic needs no 'is': write X = Y + "
               "1)\n"},
           ParserErrorRow{
               "+!g <- a, b.",
               "1:9: expected ';' or '.', found ',' (the formulas of a body are separated by "
               "';')\n"},
           ParserErrorRow{
               "+!g : a, b <- c.",
               "1:8: expected '&', '|', '<-' or '.', found ',' (conjunctions are written with "
               "'&')\n"},
           ParserErrorRow{
               "h :- a, b.",
               "1:7: expected '&', '|' or '.', found ',' (conjunctions are written with '&')\n"},
           ParserErrorRow{"+!g <- if (a, b) { c }.",
                          "1:13: expected ')', found ',' (conjunctions are written with '&')\n"},
           ParserErrorRow{
               "+!g : X != 1.",
               "1:9: expected '&', '|', '<-' or '.', found '!=' (unequal is written '\\==')\n"},
           ParserErrorRow{"+!g : X =< 1.",
                          "1:9: unexpected '=<' (less or equal is written '<=')\n"},
           ParserErrorRow{"h :- \\+ a.",
                          "1:6: unexpected '\\+' (negation is written 'not', unequal '\\==')\n"},
           ParserErrorRow{"+!g : a && b.",
                          "1:9: unexpected '&&' (conjunctions are written with a single '&')\n"},
           ParserErrorRow{"+!g <- if (a) {b} else if (c) {d}.",
                          "1:24: expected '{', found 'if' ('else if' is written 'elif')\n"},
       }) {
    EXPECT_EQ(errors_of(text), errors) << text;
  }
}

TEST(ParserErrors, NameTheBracketThatIsNotClosed) {
  for (const auto& [text, errors] : {
           ParserErrorRow{
               "b(f(1).",
               "1:7: expected ',' or ')', found '.' (the '(' at line 1, column 2 is not closed)\n"},
           ParserErrorRow{
               "b([1,2).",
               "1:7: expected ',', '|' or ']', found ')' (the '[' at line 1, column 3 is not "
               "closed)\n"},
           ParserErrorRow{
               "b(1)).",
               "1:5: expected ':-' or '.', found ')' (there is no bracket that this ')' could "
               "close)\n"},
           ParserErrorRow{
               "+!g <- { a. ",
               "1:11: expected ';' or '}', found '.' (the '{' at line 1, column 8 is not "
               "closed)\n"},
           ParserErrorRow{
               "b(",
               "1:3: expected a term, found the end of the text (the '(' at line 1, column 2 is "
               "not closed)\n"},
       }) {
    EXPECT_EQ(errors_of(text), errors) << text;
  }
}

TEST(ParserErrors, SayWhatCannotStandWhere) {
  for (const auto& [text, errors] : {
           ParserErrorRow{
               "+!g : a + 1 > 2.",
               "1:7: 'a' is not numeric or a variable, as an operand of '+' must be (variables "
               "begin with an upper-case letter)\n"},
           ParserErrorRow{
               "+!g : X > (a & b) * 2.",
               "1:12: a logical formula is not numeric or a variable, as an operand of '*' must "
               "be\n"},
           ParserErrorRow{
               "+!g : -\"s\" > 1.",
               "1:8: a string is not numeric or a variable, as an operand of '-' must be\n"},
           ParserErrorRow{
               "+!g <- ~.print(1).",
               "1:8: internal actions cannot be strongly negated (write 'not' instead of '~')\n"},
           ParserErrorRow{"+!g <- .print(1)[a].",
                          "1:17: internal actions cannot have annotations\n"},
           ParserErrorRow{
               "+!g : a & not .wait(5).",
               "1:15: .wait cannot be used in the context of a plan (call it in the body)\n"},
           ParserErrorRow{
               "+!g <- !{+!h}.",
               "1:9: expected a literal, found '{' (a term in braces cannot be a goal)\n"},
           ParserErrorRow{"+!g <- 1.",
                          "1:8: a number is not a formula that can be true or false\n"},
           ParserErrorRow{"+!g : \"a\" & b.",
                          "1:7: a string is not a formula that can be true or false\n"},
           ParserErrorRow{"+!g <- +.print(1).",
                          "1:9: an internal action cannot be added or removed as a belief\n"},
           ParserErrorRow{"+!g <- +(a;b).",
                          "1:9: a body in parentheses cannot have an operator before it\n"},
           ParserErrorRow{
               "+!g : 1 < X < 3.",
               "1:13: comparisons cannot be chained (join them with '&', as in X < Y & Y < Z)\n"},
           ParserErrorRow{
               "X.",
               "1:1: the head of a belief or rule must be a literal, not a variable (names begin "
               "with a lower-case letter)\n"},
           ParserErrorRow{
               ".print(1).",
               "1:1: an internal action cannot be a belief (call it in the body of a plan)\n"},
           ParserErrorRow{"b(not not a).",
                          "1:7: expected a term, found 'not' (put the negation in parentheses)\n"},
           ParserErrorRow{"b(X = not a).",
                          "1:7: 'not' cannot stand here (put the negation in parentheses)\n"},
           ParserErrorRow{
               "b([a & b]).",
               "1:6: expected ',', '|' or ']', found '&' (a logical formula in a list needs "
               "parentheses)\n"},
           ParserErrorRow{
               "mod(1).",
               "1:1: expected a belief, goal, plan or directive, found 'mod' ('mod' is a reserved "
               "word)\n"},
           ParserErrorRow{
               "b(1).b(2).",
               "1:5: expected ':-' or '.', found '.b' (put a blank or line break after the full "
               "stop)\n"},
           ParserErrorRow{
               "p().",
               "1:3: expected a term, found ')' (without arguments, there are no parentheses)\n"},
           ParserErrorRow{
               "P(1).",
               "1:2: expected ':-' or '.', found '(' (a variable cannot have arguments; names "
               "begin with a lower-case letter)\n"},
           ParserErrorRow{"{ end }", "1:3: '{ end }' without a '{ begin ... }' before it\n"},
           ParserErrorRow{"{ begin x } a.", "1:15: expected { end }, found the end of the text\n"},
       }) {
    EXPECT_EQ(errors_of(text), errors) << text;
  }
}

TEST(ParserErrors, AreSeveralPerText) {
  EXPECT_EQ(errors_of("a b.\nc.\n+!g <- d e.\n+!h : : <- f.\n"),
            "1:3: expected ':-' or '.', found 'b'\n"
            "3:10: expected ';' or '.', found 'e'\n"
            "4:7: expected a term, found ':'\n");
}

TEST(ParserErrors, CostTheirClauseOnly) {
  Diagnostics diagnostics;
  const ast::File file = parse_agent(
      std::make_shared<const Source>("test", "a. b c. d\ne. { begin n } f g. h. { end } +!i."),
      diagnostics);
  EXPECT_EQ(outline(file), "belief a\nbelief e\nblock n { belief h }\nplan +!i\n");
  EXPECT_EQ(diagnostics.error_count(), 3U);
}

TEST(ParserErrors, InStringsAreNotToldTwice) {
  EXPECT_EQ(errors_of("b(\"abc).\nc."),
            "1:3: this string is not closed on its line (close it with \" and write line breaks as "
            "\\n)\n");
}

TEST(ParserErrors, OfHugeFilesAreShort) {
  std::string text;
  for (int i = 0; i < 5'000; ++i) text += "a b. ";
  Diagnostics diagnostics;
  const ast::File file = parse_agent(std::make_shared<const Source>("test", text), diagnostics);
  EXPECT_EQ(diagnostics.error_count(), 5'000U);
  EXPECT_LT(diagnostics.render().size(), 100'000U) << "each error is a line of 25'000 characters";
}

}  // namespace
}  // namespace jaywalk
