// SPDX-License-Identifier: Apache-2.0
// What programs may ask of the machine: recursion of any depth that fits the memory, and a clear
// end of what does not end by itself.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/logic/machine.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;

TEST(MachineLimits, RunTailRecursionInConstantSpace) {
  test::Terms terms;
  // No choice is left in a level: the argument tells the fact from the rule, or there is one row.
  terms.believe(
      "loop(N) :- N == 0 | N > 0 & loop(N - 1). down(N) :- step(N,M) & down(M). "
      "step(N,N - 1) :- N > 0.");
  terms.believe("walk([]). walk([_|T]) :- walk(T).");
  std::vector<Value> elements(1'000'000, Value::number(1));
  ASSERT_TRUE(terms.unifier().unify(terms.term("L"), terms.heap.list(elements)));
  terms.heap.protect();
  // The frames of a million levels would take a hundred times as much.
  terms.heap.set_limit(terms.heap.all_bytes() + (4U << 20U));
  EXPECT_TRUE(terms.holds("walk(L)"));
  EXPECT_FALSE(terms.holds("down(10000)"));
}

TEST(MachineLimits, RememberNoBindingsOfFramesThatAreGivenUp) {
  test::Terms terms;
  terms.believe("down(N) :- N > 0 & M = N - 1 & down(M).");
  terms.believe("stays(X,N) :- N > 0 & stays(X,N - 1).");
  // A word for each level would be sixteen times as much.
  terms.heap.set_limit(terms.heap.all_bytes() + (2U << 20U));
  EXPECT_FALSE(terms.holds("down(2000000)"));
  EXPECT_FALSE(terms.holds("stays(a,2000000)"));
}

TEST(MachineLimits, RecurseDeeplyWithoutRecursingThemselves) {
  test::Terms terms;
  terms.believe("sum(0,0). sum(N,S) :- N > 0 & sum(N - 1,T) & S = T + N.");
  EXPECT_THAT(terms.answers("sum(100000,S)", "S"), ElementsAre("5000050000"));
}

TEST(MachineLimits, StopARuleThatCallsItself) {
  test::Terms terms;
  terms.machine.set_limits(100'000);
  terms.believe("p :- p. q(X) :- q(f(X)). r :- r & r. s :- not s. t(X) :- t(X) | t(X).");
  for (const char* const endless : {"p", "q(0)", "r", "t(1)"}) {
    EXPECT_THROW((void)terms.holds(endless), QueryLimit) << endless;
  }
  EXPECT_TRUE(terms.holds("X = 1"));
}

TEST(MachineLimits, FailDeeplyWithoutRecursingThemselves) {
  // Each level leaves a choice point that turns out to be empty.
  test::Terms terms;
  terms.believe("one(a,1). one(a,2). rows(0). rows(N) :- N > 0 & one(_,1) & rows(N - 1).");
  terms.believe("acts(0). acts(N) :- N > 0 & .member(_,[1]) & acts(N - 1).");
  terms.believe("notes(N) :- N == 0 | N > 0 & k(_)[a] & notes(N - 1). k(1)[a,b]. k(2)[b].");
  for (const char* const query :
       {"rows(100000) & false", "acts(100000) & false", "notes(100000) & false"}) {
    EXPECT_FALSE(terms.holds(query)) << query;
  }
}

TEST(MachineLimits, StopAQueryThatTriesTooMuch) {
  test::Terms terms;
  terms.machine.set_limits(100'000);
  EXPECT_THROW((void)terms.holds(".range(X,1,1000000) & .range(Y,1,1000000) & false"), QueryLimit);
}

TEST(MachineLimits, StopARuleThatGrowsWithoutEnd) {
  test::Terms terms;
  terms.believe("q(X) :- q([X|X]). r(X) :- r(X + 1) & true.");
  const Value q = terms.term("q(0)");
  const Value r = terms.term("r(0)");
  terms.heap.set_limit(1U << 20U);
  EXPECT_THROW((void)terms.machine.solve_term(q), HeapExhausted);
  EXPECT_THROW((void)terms.machine.solve_term(r), QueryLimit);
}

TEST(MachineLimits, StopNegationsThatNestWithoutEnd) {
  test::Terms terms;
  terms.machine.set_limits(100'000);
  terms.heap.set_limit(16U << 20U);
  terms.believe("s(X) :- not s(X).");
  EXPECT_THROW((void)terms.holds("s(1)"), QueryLimit);
}

TEST(MachineLimits, StopQueriesThatNestWithoutEnd) {
  test::Terms terms;
  terms.believe("n(L) :- .findall(X,n(X),L). c(N) :- .count(c(_),N).");
  EXPECT_THROW((void)terms.holds("n(L)"), QueryLimit);
  EXPECT_THROW((void)terms.holds("c(N)"), QueryLimit);
  EXPECT_TRUE(terms.holds("X = 1"));
}

TEST(MachineLimits, StopFormulasMadeWithoutEnd) {
  test::Terms terms;
  terms.machine.set_limits(100'000);
  terms.believe("v(F) :- F = v(F) & F. w(X) :- G = w(X) & G.");
  EXPECT_ANY_THROW((void)terms.holds("w(1)"));
  EXPECT_ANY_THROW((void)terms.holds("v(_)"));
  EXPECT_TRUE(terms.holds("X = 1"));
}

TEST(MachineLimits, CountTheInferencesOfEachQueryAnew) {
  test::Terms terms;
  terms.machine.set_limits(10'000);
  terms.believe("loop(0). loop(N) :- N > 0 & loop(N - 1).");
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(terms.holds("loop(1000)"));
  EXPECT_THROW((void)terms.holds("loop(20000)"), QueryLimit);
}

TEST(MachineLimits, HoldForTheAnswersToFindall) {
  test::Terms terms;
  terms.machine.set_limits(1'000'000);
  terms.believe("any(0). any(X) :- any(Y) & X = Y + 1.");
  EXPECT_THROW((void)terms.holds(".findall(X,any(X),L)"), QueryLimit);
  EXPECT_TRUE(terms.holds("any(3)"));
}

TEST(MachineLimits, LetNoListBeTooLong) {
  test::Terms terms;
  terms.believe("len([],0). len([_|T],N) :- len(T,M) & N = M + 1.");
  const std::vector<Value> elements(100'000, Value::number(1));
  ASSERT_TRUE(terms.unifier().unify(terms.term("L"), terms.heap.list(elements)));
  EXPECT_THAT(terms.answers("len(L,N)", "N"), ElementsAre("100000"));
}

TEST(MachineLimits, LeaveNoBindingBehind) {
  test::Terms terms;
  terms.machine.set_limits(10'000);
  terms.believe("p :- p. q(X,Y) :- X = 1 & p. r(X) :- q(X,Y).");
  for (const char* const query : {"X = 2 & p", "q(X,Y)", "r(X)", "B & p", "B & X = B & r(Y)"}) {
    const std::size_t mark = terms.unifier().mark();
    EXPECT_THROW((void)terms.holds(query), QueryLimit) << query;
    EXPECT_EQ(terms.unifier().mark(), mark) << query;
    EXPECT_EQ(terms.text("f(X,Y,B)"), "f(X,Y,B)") << query;
  }
}

}  // namespace
}  // namespace jaywalk
