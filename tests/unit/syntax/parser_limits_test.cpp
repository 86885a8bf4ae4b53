// SPDX-License-Identifier: Apache-2.0
// Texts of hundreds of thousands of brackets or formulas: the parser's stack does not grow with
// them, and what is nested less deeply than the limit is read.

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/syntax/parser.h"
#include "tests/unit/syntax/outline.h"

namespace jaywalk {
namespace {

SourcePtr source_of(std::string text) {
  return std::make_shared<const Source>("test", std::move(text));
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

// A program with something nested so deep.
std::string nested(const std::string& open, const std::string& inside, const std::string& close,
                   int depth) {
  return "+!g <- " + repeated(open, depth) + inside + repeated(close, depth) + ".\nafter.";
}

TEST(ParserLimits, RefusesWhatIsNestedTooDeeplyAndGoesOn) {
  constexpr int kHostile = 100'000;
  const std::string after = ".\nafter.";
  for (const std::string& text :
       {nested("f(", "x", ")", kHostile), nested("[", "x", "]", kHostile),
        nested("a = (", "x", ")", kHostile), nested("if (x) {", "a", "}", kHostile),
        nested("+{", "a", "}", kHostile), nested("(a;", "b", ")", kHostile),
        "+!g <- if (x) {a}" + repeated(" elif (x) {a}", kHostile) + after,
        "+!g : X = 1" + repeated("+1", kHostile) + after,
        "+!g : a" + repeated(" & a", kHostile) + after,
        "+!g : X = 2" + repeated("**2", kHostile) + after}) {
    Diagnostics diagnostics;
    const ast::File file = parse_agent(source_of(text), diagnostics);
    ASSERT_EQ(diagnostics.error_count(), 1U) << text.substr(0, 40);
    EXPECT_EQ(diagnostics.items().front().message, "nested deeper than 1000 levels");
    EXPECT_EQ(outline(file), "belief after\n") << text.substr(0, 40);
  }
}

TEST(ParserLimits, SurvivesBracketsThatAreNeverClosed) {
  constexpr int kHostile = 100'000;
  for (const std::string open : {"(", "[", "{", "f(", "{ begin x } ", "+!g <- {", "@"}) {
    Diagnostics diagnostics;
    const ast::File file = parse_agent(source_of(repeated(open, kHostile)), diagnostics);
    EXPECT_TRUE(diagnostics.has_errors()) << open;
  }
}

TEST(ParserLimits, AcceptsWhatIsNestedAsDeeplyAsAllowed) {
  constexpr int kDeep = kMaxNesting - 10;
  for (const std::string& text :
       {nested("f(", "x", ")", kDeep), nested("(a;", "b", ")", kDeep),
        nested("if (x) {", "a", "}", kDeep), nested("x = {", "a", "}", kDeep / 2),
        nested("+{+!g <- ", "a", "}", kDeep)}) {
    Diagnostics diagnostics;
    const ast::File file = parse_agent(source_of(text), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
    EXPECT_EQ(file.components.size(), 2U);
  }
}

TEST(ParserLimits, ReadsLongBodiesListsAndProgramsWithoutNesting) {
  constexpr int kLong = 20'000;
  for (const std::string& text :
       {"+!g <- a" + repeated("; a", kLong) + ".", "b([1" + repeated(",1", kLong) + "]).",
        "b(1" + repeated(",1", kLong) + ").", repeated("b. ", kLong),
        "+!g <- " + repeated("if (x) {a} ", kLong) + ".",
        "+!g <- a" + repeated(" |&| a", kLong) + "."}) {
    Diagnostics diagnostics;
    const ast::File file = parse_agent(source_of(text), diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << diagnostics.render();
  }
}

}  // namespace
}  // namespace jaywalk
