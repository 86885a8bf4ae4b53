// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/print.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

struct PrintRow {
  std::string written;
  std::string printed;
};

void expect_printed(const std::vector<PrintRow>& rows) {
  for (const PrintRow& row : rows) {
    test::Terms terms;
    EXPECT_EQ(term_text(terms.term(row.written), terms.symbols), row.printed) << row.written;
  }
}

TEST(Print, LiteralsAndLists) {
  expect_printed({
      {"a", "a"},
      {"~a", "~a"},
      {"'Quoted atom'", "'Quoted atom'"},
      {"\"text\"", "\"text\""},
      {"\"\"", "\"\""},
      {"f(a, 1, \"s\")", "f(a,1,\"s\")"},
      {"ns::f(a)", "ns::f(a)"},
      {"ns::~f(a)", "ns::~f(a)"},
      {"f(a)[ b, a, b ]", "f(a)[a,b]"},
      {"f[source(x)]", "f[source(x)]"},
      {"[]", "[]"},
      {"[ 1, a, [2] ]", "[1,a,[2]]"},
      {"[a|T]", "[a|T]"},
      {"[a|[b,c]]", "[a,b,c]"},
      {"X", "X"},
      {"true", "true"},
      {".print", ".print"},
  });
}

// Not by when they were made: that depends on how the engine came to them.
TEST(Print, NumbersWhatHasNoNameInTheOrderOfTheText) {
  expect_printed({
      {"f(_, X, [_, a])", "f(_1,X,[_2,a])"},
      {"_", "_1"},
  });
}

TEST(Print, ExpressionsAndFormulas) {
  expect_printed({
      {"X + 1", "(X+1)"},
      {"X - 1 - 2", "((X-1)-2)"},
      {"X * 2 + 1", "((X*2)+1)"},
      {"-X", "(-X)"},
      {"X mod 2", "(X mod 2)"},
      {"X div 2", "(X div 2)"},
      {"X ** 2", "(X**2)"},
      {"X > 1", "(X > 1)"},
      {"X \\== y", "(X \\== y)"},
      {"X =.. Y", "(X =.. Y)"},
      {"a & b", "(a & b)"},
      {"a | b & c", "(a | (b & c))"},
      {"not a", "not (a)"},
  });
}

TEST(Print, ProgramsAsData) {
  expect_printed({
      {"{}", "{ }"},
      {"{ !g }", "{ !g }"},
      {"{ !g(1); ?t; +a; -b; .print(1); act; -+c; !!h; X = 1 }",
       "{ !g(1); ?t; +a; -b; .print(1); act; -+c; !!h; (X = 1) }"},
      {"{ +!g }", "{ +!g }"},
      {"{ -?t(X) }", "{ -?t(X) }"},
      {"{ ^!g[state(S)] }", "{ ^!g[state(S)] }"},
      {"{ @l[atomic] +!g(X) : c & d <- b1; b2 }", "{ @l[atomic] +!g(X) : (c & d) <- b1; b2 }"},
      {"{ +!g(X) <- b1 }", "{ +!g(X) <- b1 }"},
      {"{ h(X) :- b(X) & X > 1 }", "{ h(X) :- (b(X) & (X > 1)) }"},
  });
}

TEST(Print, StatementsAsTheInternalActionsThatTheyAre) {
  expect_printed({
      {"{ if (a) { b } }", "{ .if_then_else(a,b) }"},
      {"{ if (a) { b } else { c } }", "{ .if_then_else(a,b,c) }"},
      {"{ while (a) { b } }", "{ .loop(a,b) }"},
      {"{ for (a(X)) { b(X) } }", "{ .foreach(a(X),b(X)) }"},
      {"{ a |&| b }", "{ .fork(and,a,b) }"},
      {"{ a ||| b ||| c }", "{ .fork(or,a,b,c) }"},
  });
}

TEST(Print, FollowsBoundVariables) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "f(Y)"));
  ASSERT_TRUE(terms.unify("Y", "1"));
  EXPECT_EQ(term_text(terms.term("g(X)"), terms.symbols), "g(f(1))");
}

TEST(Print, NumbersUnnamedVariables) {
  test::Terms terms;
  const std::string text = term_text(terms.term("f(_,_)"), terms.symbols);
  EXPECT_EQ(text.substr(0, 3), "f(_");
  const std::size_t comma = text.find(',');
  EXPECT_NE(text.substr(2, comma - 2), text.substr(comma + 1, text.size() - comma - 2));
}

TEST(Print, ShowsArgumentsOfPrintAsJasonDoes) {
  test::Terms terms;
  const auto shown = [&](std::string_view written) {
    std::string out;
    append_argument(out, terms.term(written), terms.symbols);
    return out;
  };
  EXPECT_EQ(shown("\"no quotes\""), "no quotes");
  EXPECT_EQ(shown("[\"quotes\"]"), "[\"quotes\"]");
  EXPECT_EQ(shown("X"), "X<no-value>");
  EXPECT_EQ(shown("f(X)"), "f(X)");
  EXPECT_EQ(shown("1.50"), "1.5");
}

TEST(Print, RefusesTermsThatAreNestedTooDeeply) {
  test::Terms terms;
  Value term = Value::atom(predicates::self);
  for (int i = 0; i < 100'000; ++i) {
    term = terms.heap.structure(predicates::source, std::span(&term, 1));
  }
  EXPECT_THROW((void)term_text(term, terms.symbols), TermTooDeep);
}

TEST(Print, WritesTermsThatContainThemselvesAsJasonDoes) {
  test::Terms terms;
  const Value variable = terms.term("X");
  variable.variable()->value = terms.heap.structure(predicates::source, std::span(&variable, 1));
  EXPECT_EQ(term_text(variable, terms.symbols), "...source(X)/X");
}

TEST(BriefText, IsTheWholeTextOrItsBeginning) {
  test::Terms terms;
  const Value term = terms.term("f(abc, [1, 2], g(x))");
  EXPECT_EQ(brief_text(term, terms.symbols), "f(abc,[1,2],g(x))");
  EXPECT_EQ(brief_text(term, terms.symbols, 17), "f(abc,[1,2],g(x))");
  EXPECT_EQ(brief_text(term, terms.symbols, 16), "f(abc,[1,2],g(x)...");
  EXPECT_EQ(brief_text(term, terms.symbols, 4), "f(ab...");
}

// Whatever it is made of: what is behind the bound is not printed and then cut off.
TEST(BriefText, EndsWithinAnyKindOfTerm) {
  test::Terms terms;
  std::string elements = "a";
  for (int i = 0; i < 2000; ++i) elements += ",f(" + std::to_string(i) + ")";
  for (const std::string& text :
       {"[" + elements + "]", "f(" + elements + ")", "p[" + elements + "]",
        "{ !a; " + std::string(200, 'b') + "; { !f([" + elements + "]) } }",
        "{ +!g(X) : f([" + elements + "]) <- !h }"}) {
    const Value term = terms.term(text);
    const std::string whole = term_text(term, terms.symbols);
    const std::string brief = brief_text(term, terms.symbols, 100);
    EXPECT_EQ(brief, whole.substr(0, 100) + "...");
  }
}

TEST(BriefText, OfBodiesWithinBodiesIsTheirBeginning) {
  test::Terms terms;
  Value body = terms.term("{ !a }");
  for (int i = 0; i < 900; ++i)
    body = terms.heap.structure(predicates::source, std::span(&body, 1));
  EXPECT_EQ(brief_text(body, terms.symbols, 14), "source(source(...");
  EXPECT_EQ(term_text(body, terms.symbols).size(), 900 * 8 + 6);
}

TEST(BriefText, OfATermWhoseTextNoMemoryHoldsIsShort) {
  test::Terms terms;
  Value term = Value::atom(predicates::self);
  for (int i = 0; i < 60; ++i) {
    term = terms.heap.list(std::vector<Value>{term, term});
  }
  const std::string text = brief_text(term, terms.symbols, 100);
  EXPECT_EQ(text.size(), 103U);
  EXPECT_TRUE(text.starts_with("[[[[")) << text;
}

TEST(Print, WritesListsThatEndInThemselves) {
  test::Terms terms;
  const Value tail = terms.term("T");
  tail.variable()->value = terms.term("[1,2|T]");
  EXPECT_EQ(term_text(tail, terms.symbols), "...[1,2|T]/T");
}

TEST(Print, WritesLongListsInALoop) {
  test::Terms terms;
  const std::vector<Value> elements(1'000'000, Value::number(1));
  const std::string text = term_text(terms.heap.list(elements), terms.symbols);
  EXPECT_EQ(text.size(), 2'000'001U);
}

TEST(Print, RoundsNumbersForReaders) {
  test::Terms terms;
  const auto rounded = [&](const char* text) {
    return rounded_text(terms.term(text), terms.symbols);
  };
  EXPECT_EQ(rounded("av_speed(0.5146125000000004)"), "av_speed(0.5146125)");
  EXPECT_EQ(rounded("f(0.30000000000000004, [1, 0.1], 20000000000000)"),
            "f(0.3,[1,0.1],20000000000000)");
  EXPECT_EQ(rounded("0.00001234567890123456"), "1.23456789012E-5");
}

}  // namespace
}  // namespace jaywalk
