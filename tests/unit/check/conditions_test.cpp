// SPDX-License-Identifier: Apache-2.0
// Conditions that say nothing, and rules that cannot answer.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

TEST(CheckConditions, WarnsOfComparisonsOfDifferentTypes) {
  for (const auto& [text, warnings] : {
           Row{"+!g : b(X) & X+1 > \"2\" <- a.", "1:14 a number is compared with a string\n"},
           Row{"+!g <- if (\"a\" == a) { a }.", "1:12 a string is compared with a literal\n"},
           Row{"+!g(X) : [X] = 3 <- a.", "1:10 a list is compared with a number\n"},
           Row{"p(X) :- q(X) & not (X*2 == none).", "1:21 a number is compared with a literal\n"},
           Row{"+!g <- .findall(X, b(X) & 1 < a, L).",
               "1:27 a number is compared with a literal\n"},
           Row{"+!g(X) : X > \"2.5\" <- a.",
               "1:14 \"2.5\" is a string, which is greater than every number\n"},
           Row{"+!g(X) : \"25\" <= X <- a.",
               "1:10 \"25\" is a string, which is greater than every number\n"},
       }) {
    EXPECT_EQ(warnings_of("incompatible-types", text), warnings) << text;
  }
  for (const char* text :
       {"+!g(X) : X > \"2b\" <- a.", "+!g(X) : X > \"\" <- a.", "+!g(X) : X == \"2\" <- a.",
        "+!g(X) : X == a & X < 3 <- a.", "+!g(X) : .length(X) > 3 <- a.", "+!g : math.pi > 3 <- a.",
        "+!g(X) : f(X) = f(1) <- a.", "+!g <- .print(1 < a)."}) {
    EXPECT_EQ(warnings_of("incompatible-types", text), "") << text;
  }
}

TEST(CheckConditions, WarnsOfThoseThatAreAlwaysTheSame) {
  for (const auto& [text, warnings] : {
           Row{"+!g : 1 < 2 <- a.", "1:7 '1 < 2' is always true\n"},
           Row{"+!g : 2*3 == 7 <- a.", "1:7 '2*3 == 7' is always false\n"},
           Row{"+!g(X) : X \\== X <- a.", "1:10 'X \\== X' is always false\n"},
           Row{"+!g(X) <- if (f(X) == f(X)) { a }.", "1:15 'f(X) == f(X)' is always true\n"},
           Row{"+!g <- if (a = b) { a }.", "1:12 'a = b' is always false\n"},
           Row{"+!g : false <- a.", "1:7 the condition is always false\n"},
           Row{"+!g : not true <- a.", "1:7 the condition is always false\n"},
           Row{"+!g <- if (true) { a }.", "1:12 the condition is always true\n"},
           Row{"+!g(N) <- N = N + 1.",
               "1:11 'N = N+1' is no assignment: a variable keeps its value\n"},
           Row{"+!g : b(X) & c & not b(X) <- a.",
               "1:18 always false: 'b(X)' must hold and must not hold\n"},
       }) {
    EXPECT_EQ(warnings_of("constant-condition", text), warnings) << text;
  }
  for (const char* text :
       {"+!g : true <- a.", "+!g <- while (true) { a }.", "+!g <- while (not false) { a }.",
        "+!g : math.random < math.random <- a.", "+!g : _ = _ <- a.", "+!g(N) <- M = N + 1; a(M).",
        "+!g : b(X) & not b(Y) <- a(X,Y).", "+!g : b(X) & not b(X)[source(self)] <- a.",
        "+!g <: false <- a.", "+!g : b | not b <- a.", "+!g(X,Y) : X == Y <- a.", "p(X) :- true.",
        "+!g(N) <- N = N + 0."}) {
    EXPECT_EQ(warnings_of("constant-condition", text), "") << text;
  }
}

TEST(CheckConditions, WarnsOfRulesThatNeedThemselves) {
  for (const auto& [text, warnings] : {
           Row{"p(X) :- q(X,Y) & p(Y).",
               "1:1 'p' has no answer: every rule for it needs another 'p'\n"},
           Row{"p(X) :- q(X) & (p(X) | r & p(X)).",
               "1:1 'p' has no answer: every rule for it needs another 'p'\n"},
       }) {
    EXPECT_EQ(warnings_of("endless-rule", text), warnings) << text;
  }
  for (const char* text :
       {"p(X) :- q(X,Y) & p(Y). p(1).", "p(X) :- q(X). p(X) :- q(X,Y) & p(Y).",
        "p(X) :- q(X) | p(X).", "p(X) :- q(X) & not p(0).", "p(X) :- p(X,1).",
        "p(X) :- q(X,Y) & p(Y). +!g <- +p(1).", "p(X) :- q(X,Y) & p(Y). +p(1) <- a.",
        "p(X) :- ~p(X).", "p(X) :- n::p(X)."}) {
    EXPECT_EQ(warnings_of("endless-rule", text), "") << text;
  }
}

}  // namespace
}  // namespace jaywalk
