// SPDX-License-Identifier: Apache-2.0
// .findall .setof .count .eval .abolish .asserta .assertz .belief .relevant_rules .list_rules
// .namespace*

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(QueryActions, CollectSolutions) {
  expect_lines(
      {
          {".findall(X, v(X), L); .setof(X, v(X), S); .count(v(_), N); .print(L, S, N)",
           {"[f(2),1,b][1,b,f(2)]3"}},
          {".findall(t(X,Y), v(X) & Y = X + 1 & X == 1, L); .print(L)", {"[t(1,2)]"}},
          {".findall(X, v(X) & X == 9, L); .print(L)", {"[]"}},
          {".count(v(9), 0); .print(.count(v(b)))", {"1"}},
          {"Q = v(X); .findall(X, Q, L); .print(L)", {"[f(2),1,b]"}},
          {".eval(A, v(1)); .eval(B, v(5) | 2 > 5); .eval(C, not v(5)); .print(A, \" \", B, \" \", "
           "C)",
           {"true false true"}},
          {".eval(A, v(X)); .print(X)", {"X<no-value>"}},
      },
      "v(f(2)). v(1). v(b). v(2,k).");
}

TEST(QueryActions, CountAnnotatedBeliefsOnce) {
  expect_lines({{".count(v(_), N); .print(N)", {"2"}}}, "v(2). v(1). v(2)[again].");
}

TEST(BeliefActions, AbolishWhateverTheSource) {
  const std::string beliefs =
      "q(1). q(2)[source(z)]. r(1). r(5)[source(z)]. q(1,2). t(X) :- q(X). left::p(1).";
  expect_lines(
      {
          {".abolish(q(_)); .count(q(_), N); .count(q(_,_), M); .print(N, M)", {"01"}},
          {".abolish(_[source(z)]); .findall(X, q(X) | r(X), L); .print(L)", {"[1,1]"}},
          {".abolish(_); .count(r(_) | left::p(_), N); .print(N); +q(7); ?t(X); .print(X)",
           {"0", "7"}},
          {".abolish(nothing); .print(yes)", {"yes"}},
          {".abolish(1)", {"failed: wrong_arguments"}},
      },
      beliefs);
  expect_lines({{".abolish(q(_)); .wait(1)", {"gone [] 1", "gone [] 2"}}},
               "q(1). q(2)[source(z)]. -q(X)[|A] <- .print(\"gone \", A, \" \", X).");
}

TEST(BeliefActions, AddAtEitherEnd) {
  expect_lines(
      {
          {".asserta(b(0)); .assertz(b(9)); .findall(X, b(X), L); .print(L)", {"[0,1,9]"}},
          {".asserta(b(0)); ?b(0)[source(S)]; .print(S)", {"self"}},
          {".assertz(b(9)); ?b(9)[source(S)]", {"failed: test_goal_failed"}},
          {".asserta({ big(X) :- b(X) & X > 0 }); ?big(Y); .print(Y)", {"1"}},
          {".asserta(1)", {"failed: unknown"}},
      },
      "b(1).");
}

TEST(BeliefActions, LookAtFactsAndRules) {
  const std::string beliefs = "b(1). b(2)[source(eve)]. old(X) :- b(X) & X > 1. old(9).";
  expect_lines(
      {
          {".findall(X, .belief(b(X)), L); .findall(X, .belief(old(X)), M); .print(L, M)",
           {"[1,2][9]"}},
          {".belief(b(X)[source(eve)]); .print(X)", {"2"}},
          {".belief(zz)", {"failed: ia_failed"}},
          {".relevant_rules(old(_), L); .print(L)", {"[{ old(X) :- (b(X) & (X > 1)) }]"}},
          {".relevant_rules(b(_), L); .print(L)", {"[]"}},
          {".list_rules", {"old(X)[source(self)] :- (b(X) & (X > 1))"}},
      },
      beliefs);
}

TEST(NamespaceActions, NameNamespacesAndTheirProperties) {
  expect_lines(
      {
          {".findall(N, .namespace(N), L); .print(L)", {"[default,left]"}},
          {".namespace(left); .print(yes)", {"yes"}},
          {".namespace(right)", {"failed: ia_failed"}},
          {".namespace_set_prop(left, k, f(1)); .namespace_get_prop(left, k, V); .print(V)",
           {"f(1)"}},
          {".namespace_set_prop(left, a, 1); .namespace_set_prop(left, b, 2); "
           ".namespace_set_prop(left, a, 3); "
           ".findall(p(K,V), .namespace_get_prop(left, K, V), L); .print(L)",
           {"[p(a,3),p(b,2)]"}},
          {".namespace_get_prop(left, k, V, none); .print(V)", {"none"}},
          {".namespace_get_prop(left, k, V); .print(V)", {"V<no-value>"}},
          {".namespace_set_prop(1, k, 2)", {"failed: wrong_arguments"}},
      },
      "left::b(1).");
}

}  // namespace
}  // namespace jaywalk::test
