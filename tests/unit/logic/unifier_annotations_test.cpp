// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/logic/unifier/unifier.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

struct AnnotationRow {
  std::string a;
  std::string b;
  bool unify = false;
};

// The annotations of the first must be among those of the second, in arguments as well.
TEST(UnifierAnnotations, AreAsymmetric) {
  const std::vector<AnnotationRow> rows{
      {"p", "p", true},
      {"p", "p[a]", true},
      {"p[a]", "p", false},
      {"p[a]", "p[a]", true},
      {"p[a]", "p[b,a]", true},
      {"p[a,b]", "p[a]", false},
      {"p[a,b]", "p[c,b,a]", true},
      {"p(1)[a]", "p(1)[b]", false},
      {"p[k(X)]", "p[k(1)]", true},
      {"p[k(X),k(Y)]", "p[k(1)]", false},
      {"p[k(X),k(Y)]", "p[k(1),k(2)]", true},
      {"p(q)", "p(q[a])", true},
      {"p(q[a])", "p(q)", false},
      {"[q]", "[q[a]]", true},
      {"[q[a]]", "[q]", false},
  };
  for (const AnnotationRow& row : rows) {
    test::Terms terms;
    EXPECT_EQ(terms.unify(row.a, row.b), row.unify) << row.a << " = " << row.b;
  }
}

struct Binding {
  std::string a;
  std::string b;
  std::string variable;
  std::string value;
};

void expect_bound(const std::vector<Binding>& rows) {
  for (const Binding& row : rows) {
    test::Terms terms;
    EXPECT_TRUE(terms.unify(row.a, row.b)) << row.a << " = " << row.b;
    EXPECT_EQ(terms.text(row.variable), row.value) << row.a << " = " << row.b;
  }
}

TEST(UnifierAnnotations, GiveTheRestToAnOpenTail) {
  expect_bound({
      {"p[a|T]", "p[a,b,c]", "T", "[b,c]"},
      {"p[b|T]", "p[a,b,c]", "T", "[a,c]"},
      {"p[|T]", "p[a,b]", "T", "[a,b]"},
      {"p[|T]", "p", "T", "[]"},
      {"p[a|T]", "p[a]", "T", "[]"},
  });
}

TEST(UnifierAnnotations, GiveWhatIsMissingToTheOthersTail) {
  expect_bound({
      {"p[a,b]", "p[a|T]", "T", "[b]"},
      {"p[a]", "p[a|T]", "T", "T"},
  });
}

TEST(UnifierAnnotations, BindTheFirstThatUnifies) {
  expect_bound({
      {"p[k(X)]", "p[k(2),k(1)]", "X", "1"},
      {"p[X]", "p[b,a]", "X", "a"},
      {"p(Y)[source(Y)]", "p(bob)[source(ann),source(bob)]", "Y", "bob"},
  });
}

TEST(UnifierAnnotations, AreTakenOffTheValueOfAnAnnotatedVariable) {
  expect_bound({
      {"X[An]", "p(1)[q]", "X", "p(1)"},
      {"X[An]", "p(1)[q]", "An", "q"},
      {"X[q|R]", "p(1)[q,r]", "X", "p(1)"},
      {"X[q|R]", "p(1)[q,r]", "R", "[r]"},
      {"p(1)[q]", "X[q,r]", "X", "p(1)"},
  });
}

TEST(UnifierAnnotations, MustBeThereForAnAnnotatedVariable) {
  test::Terms terms;
  EXPECT_FALSE(terms.unify("X[q]", "p(1)"));
  EXPECT_FALSE(terms.unify("X[q]", "p(1)[r]"));
  EXPECT_EQ(terms.text("f(X)"), "f(X)");
}

TEST(UnifierAnnotations, JoinThoseOfTheValueWhenAnAnnotatedVariableIsApplied) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "g(1)[a]"));
  EXPECT_EQ(terms.text("X[b]"), "g(1)[a,b]");
  EXPECT_EQ(terms.text("X[a]"), "g(1)[a]");
}

TEST(UnifierAnnotations, StaySortedWhenTheyAreApplied) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("f(X,Y)", "f(b,a)"));
  EXPECT_EQ(terms.text("p[X,Y,c,a]"), "p[a,b,c]");
}

}  // namespace
}  // namespace jaywalk
