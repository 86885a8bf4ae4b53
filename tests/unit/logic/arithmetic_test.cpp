// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/unifier/arithmetic.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

struct ArithmeticRow {
  std::string expression;
  std::string value;
};

// Through the evaluation of terms, as programs see it.
TEST(Arithmetic, IsJavas) {
  const std::vector<ArithmeticRow> rows{
      {"1 + 2 * 3", "7"},
      {"(1 + 2) * 3", "9"},
      {"7 - 2 - 1", "4"},
      {"1 / 2", "0.5"},
      {"1 / 0", "Infinity"},
      {"-1 / 0", "-Infinity"},
      {"0 / 0", "NaN"},
      {"7 div 2", "3"},
      {"-7 div 2", "-3"},
      {"7 div -2", "-3"},
      {"7.9 div 2.9", "3"},
      {"0.5 div 1", "0"},
      {"1e10 div 1", "2147483647"},
      {"-1e10 div 1", "-2147483648"},
      {"-1e10 div -1", "-2147483648"},  // the least int has no opposite
      {"7 mod 3", "1"},
      {"-7 mod 3", "-1"},
      {"7 mod -3", "1"},
      {"5.5 mod 2", "1.5"},
      {"7 mod 0", "NaN"},
      {"2 ** 10", "1024"},
      {"-2 ** 2", "4"},
      {"2 ** -1", "0.5"},
      {"2 ** 3 ** 2", "512"},
      {"0 ** 0", "1"},
      {"2 ** 53 + 1", "9007199254740992"},
      {"0.1 + 0.2", "0.30000000000000004"},
      {"-(3)", "-3"},
      {"0 * -1", "0"},
  };
  for (const ArithmeticRow& row : rows) {
    test::Terms terms;
    EXPECT_EQ(terms.text(row.expression), row.value) << row.expression;
  }
}

TEST(Arithmetic, HasNoResultForDivByZero) {
  EXPECT_FALSE(calculate(predicates::int_divide, 1, 0).has_value());
  EXPECT_FALSE(calculate(predicates::int_divide, 1, 0.9).has_value());  // truncated first
  EXPECT_FALSE(
      calculate(predicates::int_divide, 1, std::numeric_limits<double>::quiet_NaN()).has_value());
  EXPECT_TRUE(calculate(predicates::divide, 1, 0).has_value());
}

TEST(Arithmetic, LeavesWhatIsNotKnownUnevaluated) {
  test::Terms terms;
  EXPECT_EQ(terms.text("X + 1"), "(X+1)");
  // No part of an expression is evaluated before the whole can be.
  EXPECT_EQ(terms.text("f(X * (1 + 1))"), "f((X*(1+1)))");
  ASSERT_TRUE(terms.unify("X", "4"));
  EXPECT_EQ(terms.text("f(X * (1 + 1))"), "f(8)");
}

TEST(Arithmetic, MakesNotANumberOfOtherTermsAndWarns) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "a"));
  EXPECT_EQ(terms.text("X + 1"), "NaN");
  EXPECT_FALSE(terms.warnings.empty());
}

TEST(Arithmetic, EvaluatesFunctionsWithinExpressions) {
  test::Terms terms;
  EXPECT_EQ(terms.text("math.max(2, 5) * 2"), "10");
  EXPECT_EQ(terms.text("f(math.max(X, 5))"), "f(math.max(X,5))");
}

}  // namespace
}  // namespace jaywalk
