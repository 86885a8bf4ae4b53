// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/unifier/unifier.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

struct UnifierRow {
  std::string a;
  std::string b;
  /// `a` afterwards; empty: they do not unify.
  std::string result;
};

void expect_unified(const std::vector<UnifierRow>& rows) {
  for (const UnifierRow& row : rows) {
    test::Terms terms;
    EXPECT_EQ(terms.unify(row.a, row.b), !row.result.empty()) << row.a << " = " << row.b;
    if (row.result.empty()) continue;
    EXPECT_EQ(terms.text(row.a), row.result) << row.a << " = " << row.b;
  }
}

TEST(Unifier, UnifiesTermsOfAllKinds) {
  expect_unified({
      {"a", "a", "a"},
      {"a", "b", ""},
      {"1", "1.0", "1"},
      {"1", "2", ""},
      {"1", "a", ""},
      {"\"s\"", "\"s\"", "\"s\""},
      {"\"s\"", "s", ""},
      {"f(X)", "f(1)", "f(1)"},
      {"f(X,X)", "f(1,1)", "f(1,1)"},
      {"f(X,X)", "f(1,2)", ""},
      {"f(X)", "g(1)", ""},
      {"f(X)", "f(1,2)", ""},
      {"f(X,b)", "f(a,Y)", "f(a,b)"},
      {"~f(X)", "~f(1)", "~f(1)"},
      {"~f(1)", "f(1)", ""},
      {"n::f(X)", "n::f(1)", "n::f(1)"},
      {"n::f(1)", "m::f(1)", ""},
      {"X", "f(a)", "f(a)"},
  });
}

TEST(Unifier, UnifiesLists) {
  expect_unified({
      {"[]", "[]", "[]"},
      {"[]", "[a]", ""},
      {"[H|T]", "[1,2,3]", "[1,2,3]"},
      {"[H|T]", "[1]", "[1]"},
      {"[H|T]", "[]", ""},
      {"[|T]", "[1,2]", "[1,2]"},
      {"[|T]", "[]", "[]"},
      {"[A,B]", "[1,2,3]", ""},
      {"[A,B|C]", "[1,2,3]", "[1,2,3]"},
      {"[1,2]", "[A|[B]]", "[1,2]"},
      {"[X]", "\"s\"", ""},
  });
}

TEST(Unifier, EvaluatesArithmeticFirst) {
  expect_unified({
      {"1 + 2", "3", "3"},
      {"X", "1 + 2", "3"},
      {"f(2 * 3)", "f(6)", "f(6)"},
      {"1 + 2", "4", ""},
      {"A + 1", "B + 1", "(B+1)"},
  });
}

TEST(Unifier, LeavesNoBindingBehindWhenItFails) {
  for (const auto& [a, b] : std::vector<std::pair<std::string, std::string>>{
           {"f(X,Y,1)", "f(a,b,2)"},
           {"f(X,X)", "f(1,2)"},
           {"[X,Y|Z]", "[1]"},
           {"p(X)[k(Y)]", "p(1)[m(2)]"},
           {"g(X,p[a(Y),b])", "g(1,p[a(2)])"},
           {"f(X,V[k])", "f(1,p)"},
       }) {
    test::Terms terms;
    const std::size_t mark = terms.unifier().mark();
    EXPECT_FALSE(terms.unify(a, b)) << a << " = " << b;
    EXPECT_EQ(terms.unifier().mark(), mark);
    for (const char* const name : {"X", "Y", "Z", "V"}) EXPECT_EQ(terms.text(name), name) << a;
  }
}

TEST(Unifier, UndoesBindingsDownToAMark) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "1"));
  const std::size_t mark = terms.unifier().mark();
  ASSERT_TRUE(terms.unify("f(Y,Z)", "f(2,X)"));
  EXPECT_EQ(terms.text("f(X,Y,Z)"), "f(1,2,1)");
  terms.unifier().undo(mark);
  EXPECT_EQ(terms.text("f(X,Y,Z)"), "f(1,Y,Z)");
}

TEST(Unifier, BindsTwoFreeVariablesToOneAnother) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "Y"));
  ASSERT_TRUE(terms.unify("Y", "a"));
  EXPECT_EQ(terms.text("X"), "a");
}

TEST(Unifier, LetsAVariableContainItself) {
  test::Terms terms;
  EXPECT_TRUE(terms.unify("X", "f(X)"));
  EXPECT_THROW((void)terms.text("X"), TermTooDeep);
}

TEST(Unifier, EndsForTermsThatContainThemselves) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "f(X)"));
  ASSERT_TRUE(terms.unify("Y", "f(f(Y))"));
  EXPECT_TRUE(terms.unify("X", "Y")) << "nothing tells one from the other";
  ASSERT_TRUE(terms.unify("Z", "g(Z)"));
  EXPECT_FALSE(terms.unify("X", "Z"));
}

TEST(Unifier, EndsForListsThatEndInThemselves) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "[a|X]"));
  ASSERT_TRUE(terms.unify("Y", "[a,a|Y]"));
  EXPECT_THROW((void)terms.unify("X", "Y"), TermTooDeep);
  EXPECT_THROW((void)terms.text("X"), TermTooDeep);
}

TEST(Unifier, WalksLongListsInALoop) {
  test::Terms terms;
  std::vector<Value> elements(300'000, Value::number(1));
  const Value a = terms.heap.list(elements);
  elements.back() = terms.term("X");
  const Value b = terms.heap.list(elements);
  EXPECT_TRUE(terms.unifier().unify(a, b));
  EXPECT_EQ(terms.text("X"), "1");
}

TEST(Unifier, UnifiesPlanBodiesFormulaByFormula) {
  expect_unified({
      {"{ !g(X); +b }", "{ !g(1); +b }", "{ !g(1); +b }"},
      {"{ !g }", "{ ?g }", ""},
      {"{ !g }", "{ !g; !h }", ""},
      {"{ }", "{ }", "{ }"},
      {"{ !g; R }", "{ !g; +b; -c }", "{ !g; +b; -c }"},
      {"{ !G }", "{ !walk(3) }", "{ !walk(3) }"},
  });
}

TEST(Unifier, UnifiesTriggersAndPlans) {
  expect_unified({
      {"{ +!g(X) }", "{ +!g(1) }", "{ +!g(1) }"},
      {"{ +!g(X) }", "{ -!g(1) }", ""},
      {"{ +!g(X) }", "{ +?g(1) }", ""},
      {"{ @l +!g(X) : c <- b(X) }", "{ @l +!g(1) : c <- b(1) }", "{ @l +!g(1) : c <- b(1) }"},
      {"{ @l +!g <- b }", "{ @m +!g <- b }", ""},
  });
}

TEST(Unifier, BindsANegatedVariableToANegatedLiteral) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("~X", "~p(1)"));
  EXPECT_EQ(terms.text("X"), "p(1)");
  test::Terms others;
  EXPECT_FALSE(others.unify("~X", "p(1)"));
  EXPECT_FALSE(others.unify("~X", "1"));
}

TEST(Unifier, BindsANamespaceVariable) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("N::X", "shop::price(3)"));
  EXPECT_EQ(terms.text("N"), "shop");
  EXPECT_EQ(terms.text("X"), "price(3)");
}

}  // namespace
}  // namespace jaywalk
