// SPDX-License-Identifier: Apache-2.0
// Heads of rules, compiled: what they match and bind, and that they leave no choice where there is
// none.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/logic/machine.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(HeadCode, TakesListsApartAndMakesThem) {
  test::Terms terms;
  terms.believe("p([H|T],T,[x,H|T]). p2([[A|B]|C],[B,C|D]) :- D = [A].");
  EXPECT_THAT(terms.answers("p([1,2,3],A,B)", "r(A,B)"), ElementsAre("r([2,3],[x,1,2,3])"));
  EXPECT_THAT(terms.answers("p(A,[2],[_,1|B])", "r(A,B)"), ElementsAre("r([1,2],[2])"));
  EXPECT_THAT(terms.answers("p([1|A],B,[x,C|D]) & D = [7]", "r(A,B,C)"),
              ElementsAre("r([7],[7],1)"));
  EXPECT_THAT(terms.answers("p2([[1,2],3],X)", "X"), ElementsAre("[[2],[3],1]"));
  EXPECT_THAT(terms.answers("p2([[1]],[A,B|C])", "r(A,B,C)"), ElementsAre("r([],[],[1])"));
  EXPECT_THAT(terms.answers("p([],A,B)", "A"), IsEmpty());
  EXPECT_THAT(terms.answers("p(a,A,B)", "A"), IsEmpty());
}

TEST(HeadCode, MatchesConstantsAsUnificationDoes) {
  test::Terms terms;
  terms.believe("q(1,a,[],\"s\",X) :- X = f(_).");
  EXPECT_TRUE(terms.holds("q(1.0,a[note],[],\"s\",_)") == terms.unify("a[note]", "a"));
  EXPECT_THAT(terms.answers("q(A,B,C,D,f(3))", "r(A,B,C,D)"), ElementsAre("r(1,a,[],\"s\")"));
  for (const char* const query :
       {"q(2,a,[],\"s\",_)", "q(1,b,[],\"s\",_)", "q(1,a,[x],\"s\",_)", "q(1,a,[],\"t\",_)",
        "q(1,a(1),[],\"s\",_)", "q([1],a,[],\"s\",_)"}) {
    EXPECT_FALSE(terms.holds(query)) << query;
  }
}

TEST(HeadCode, EvaluatesExpressionsInTheQuery) {
  test::Terms terms;
  terms.believe("v(3,X,X) :- true & true. w([X|_],X).");
  EXPECT_TRUE(terms.holds("v(1+2,4*2,16/2)"));
  EXPECT_TRUE(terms.holds("Y = 2 & v(Y+1,Y-7,0-5)"));
  EXPECT_FALSE(terms.holds("v(1+1,1,1)"));
  EXPECT_FALSE(terms.holds("w(1+2,_)"));
}

TEST(HeadCode, UnifiesTheLaterPlacesOfAVariable) {
  test::Terms terms;
  terms.believe("s(X,X,[X],g(X)).");
  EXPECT_THAT(terms.answers("s(A,b,C,D)", "r(A,C,D)"), ElementsAre("r(b,[b],g(b))"));
  EXPECT_THAT(terms.answers("s(A,B,[C|D],E) & A = 1", "r(B,C,D,E)"), ElementsAre("r(1,1,[],g(1))"));
  EXPECT_THAT(terms.answers("s(A,A,_,g(k))", "A"), ElementsAre("k"));
  EXPECT_FALSE(terms.holds("s(1,2,_,_)"));
  EXPECT_FALSE(terms.holds("s(A,1,_,g(2))"));
}

TEST(HeadCode, LeavesNoBindingOfARuleThatDoesNotMatch) {
  test::Terms terms;
  terms.believe("t(X,[X|R],R,b). t(X,Y,Z,c) :- X = 5.");
  EXPECT_THAT(terms.answers("t(X,Y,Z,c)", "r(X,Y,Z)"), ElementsAre("r(5,Y,Z)"));
  EXPECT_THAT(terms.answers("t(X,Y,Z,W) & W = c", "r(X,Y,Z)"), ElementsAre("r(5,Y,Z)"));
  EXPECT_THAT(terms.answers("Y = [K|L] & t(1,Y,L,W)", "r(K,W)"), ElementsAre("r(1,b)"));
}

TEST(HeadCode, LeavesNoChoiceIfAnyArgumentTellsTheRulesApart) {
  test::Terms terms;
  terms.believe("last(N,[]) :- N > 0. last(N,[_|T]) :- last(N,T).");
  terms.believe("kind(_,a,X) :- X = 1. kind(_,b,X) :- X = 2. kind(_,3,X) :- X = 3.");
  terms.believe("kinds(0). kinds(N) :- N > 0 & kind(N,b,2) & kinds(N - 1).");
  const std::vector<Value> elements(200'000, Value::number(1));
  ASSERT_TRUE(terms.unifier().unify(terms.term("L"), terms.heap.list(elements)));
  terms.heap.protect();
  terms.heap.set_limit(terms.heap.all_bytes() + (4U << 20U));
  EXPECT_TRUE(terms.holds("last(1,L)"));
  EXPECT_FALSE(terms.holds("kinds(20000) & false"));
}

TEST(HeadCode, GoesOnWithVariablesOfItsOwn) {
  // Variables made by the query itself are not on the trail, those of the caller are.
  test::Terms terms;
  terms.believe("app([],L,L). app([H|T],L,[H|R]) :- app(T,L,R).");
  terms.believe("split(A,B) :- app(A,B,[1,2]) & app(B,A,C) & C \\== [1,2].");
  EXPECT_THAT(terms.answers("app(A,B,[1,2])", "r(A,B)"),
              ElementsAre("r([],[1,2])", "r([1],[2])", "r([1,2],[])"));
  EXPECT_THAT(terms.answers("split(A,B)", "r(A,B)"), ElementsAre("r([1],[2])"));
  EXPECT_THAT(terms.answers("app([1],X,Y) & (X = [2] | X = [3])", "Y"),
              ElementsAre("[1,2]", "[1,3]"));
  EXPECT_THAT(terms.answers("app([1],X,Y) & not app(X,_,[9]) & X = [4]", "Y"), IsEmpty());
  EXPECT_THAT(terms.answers("app([1],X,Y) & not (X = [9] & false) & X = [4]", "Y"),
              ElementsAre("[1,4]"));
}

TEST(HeadCode, KnowsAVariableOfAFactAgain) {
  test::Terms terms;
  ASSERT_TRUE(terms.beliefs.add(terms.term("p([A],A)[source(self)]")).has_value());
  terms.new_scope();
  EXPECT_THAT(terms.answers("p([Z],Z) & Z = 1", "Z"), ElementsAre("1"));
  EXPECT_THAT(terms.answers("p([Z],Y) & Z = 1", "Y"), ElementsAre("1"));
}

}  // namespace
}  // namespace jaywalk
