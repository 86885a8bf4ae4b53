// SPDX-License-Identifier: Apache-2.0
// .member .length .empty .nth .reverse .sort .shuffle .max .min .union .intersection .difference
// .range .prefix .suffix .sublist .random

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(ListActions, FindMembersInOrder) {
  expect_lines({
      {".findall(X, .member(X, [c,a,c]), L); .print(L)", {"[c,a,c]"}},
      {".member(f(X), [g(1),f(2),f(3)]); .print(X)", {"2"}},
      {".findall(X, .member(X, [1|_]), L); .print(L)", {"[1]"}},
      {".member(a[x], [a[x,y]]); .print(yes)", {"yes"}},
      {".member(a, [])", {"failed: ia_failed"}},
      {".member(a, b)", {"failed: wrong_arguments"}},
      {".member(a)", {"failed: wrong_arguments"}},
      {".set.add_all(S, [b,a,b]); .findall(X, .member(X, S), L); .print(L)", {"[a,b]"}},
      {".set.add_all(S, [b,a]); .count(.member(a, S), N); .print(N)", {"1"}},
  });
}

TEST(ListActions, MeasureLength) {
  expect_lines({
      {".length([], A); .length([x,[y,z]], B); .length([x|_], C); .print(A, B, C)", {"021"}},
      {".length(\"\", A); .length(\"a\\\"b\", B); .print(A, B)", {"03"}},
      {".length(\"h\u00e4\U0001F600\", N); .print(N)", {"4"}},  // UTF-16 units, as in Java
      {".map.put(M, k, v); .length(M, N); .print(N, .length(M))", {"11"}},
      {".length([a], 2)", {"failed: ia_failed"}},
      {".length(a, _)", {"failed: ia_failed"}},
      {".empty([]); .empty(\"\"); .set.create(S); .empty(S); .print(yes)", {"yes"}},
      {".empty([a])", {"failed: ia_failed"}},
  });
}

TEST(ListActions, TakeElementsByIndex) {
  expect_lines({
      {".nth(0, [p,q], A); .nth(1.9, [p,q], B); .print(A, B)", {"pq"}},
      {".findall(I, .nth(I, [a,b,a], a), L); .print(L)", {"[0,2]"}},
      {".nth(1, \"w\u00f6rd\", C); .print(C)", {"\u00f6"}},
      {".findall(c(I,C), .nth(I, \"ab\", C), L); .print(L)", {"[c(0,\"a\"),c(1,\"b\")]"}},
      {".nth(0, [p], q)", {"failed: ia_failed"}},
      {".nth(1, [p], _)", {"failed: internal_action"}},
      {".nth(-1, [p], _)", {"failed: internal_action"}},
      {".nth(a, [p], _)", {"failed: wrong_arguments"}},
      {".nth(0, p, _)", {"failed: wrong_arguments"}},
  });
}

TEST(ListActions, ReverseAndSort) {
  expect_lines({
      {".reverse([1,2,3], A); .reverse(\"abc\", B); .reverse([], C); .print(A, B, C)",
       {"[3,2,1]cba[]"}},
      {".reverse(\"a\u00e4\", R); .print(R)", {"\u00e4a"}},
      {".reverse(ab, R); .print(R)", {"failed: wrong_arguments"}},
      {".sort([c,f(2),f(1,0),\"s\",[],2,c,1.5,~c], L); .print(L)",
       {"[1.5,2,\"s\",[],c,c,~c,f(1,0),f(2)]"}},
      {".sort([b,a], [a,b]); .print(yes)", {"yes"}},
      {".sort(a, _)", {"failed: wrong_arguments"}},
      {".set_random_seed(1); .shuffle([1,2,3,4], L); .sort(L, S); .print(S)", {"[1,2,3,4]"}},
  });
}

TEST(ListActions, FindExtremes) {
  expect_lines(
      {
          {".min([3,1,2], A); .max([3,1,2], B); .print(A, B)", {"13"}},
          {".max([b,\"z\",7,[a]], A); .min([b,\"z\",7], B); .print(A, B)", {"b7"}},
          {".max(p(X,k), v(X), M); .min(X, v(X), N); .print(M, N)", {"p(9,k)2"}},
          {".max([], _)", {"failed: ia_failed"}},
          {".min(X, v(X) & X > 9, _)", {"failed: ia_failed"}},
          {".min(a, _)", {"failed: wrong_arguments"}},
      },
      "v(4). v(9). v(2).");
}

TEST(ListActions, CombineListsAsSets) {
  expect_lines({
      {".union([c,a], [b,a], L); .print(L)", {"[a,b,c]"}},
      {".intersection([c,a,b,c], [b,c,d], L); .print(L)", {"[b,c]"}},
      {".difference([c,a,b,a], [b], L); .print(L)", {"[a,c]"}},
      {".union([], [], L); .print(L)", {"[]"}},
      {".union([a[x]], [a], L); .print(L)", {"[a,a[x]]"}},
      {".union(a, [], _)", {"failed: wrong_arguments"}},
  });
}

TEST(ListActions, CountThroughRanges) {
  expect_lines({
      {".findall(X, .range(X, 1, 4), L); .print(L)", {"[1,2,3,4]"}},
      {".findall(X, .range(X, 5, 1, -2), L); .print(L)", {"[5,3,1]"}},
      {".findall(X, .range(X, 1.9, 3.9), L); .print(L)", {"[1,2,3]"}},
      {".findall(X, .range(X, 3, 2), L); .print(L)", {"[]"}},
      {".range(4, 1, 5); .print(yes)", {"yes"}},
      {".range(6, 1, 5)", {"failed: ia_failed"}},
      {".range(X, 1, 3, 0)", {"failed: internal_action"}},
      {".range(X, a, 3)", {"failed: wrong_arguments"}},
      {".range(X, 1, 1000000000); .print(X)", {"1"}},
  });
}

TEST(ListActions, ListPartsTheLongestFirst) {
  expect_lines({
      {".findall(P, .prefix(P, [1,2]), L); .print(L)", {"[[1,2],[1],[]]"}},
      {".findall(P, .suffix(P, [1,2]), L); .print(L)", {"[[1,2],[2],[]]"}},
      {".findall(P, .sublist(P, [1,2,3]), L); .print(L)", {"[[1,2,3],[1,2],[1],[2,3],[2],[3],[]]"}},
      {".findall(P, .sublist(P, []), L); .print(L)", {"[[]]"}},
      {".findall(T, .prefix([1|T], [1,2]), L); .print(L)", {"[[2],[]]"}},
      {".findall(P, .prefix(P, \"ab\"), L); .print(L)", {"[\"ab\",\"a\",\"\"]"}},
      {".findall(P, .suffix(P, \"ab\"), L); .print(L)", {"[\"ab\",\"b\",\"\"]"}},
      {".prefix(\"ho\", \"house\"); .suffix(\"se\", \"house\"); .print(yes)", {"yes"}},
      {".sublist([1,3], [1,2,3])", {"failed: ia_failed"}},
      {".prefix(a, [a])", {"failed: wrong_arguments"}},
      {".suffix(_, a)", {"failed: wrong_arguments"}},
  });
}

TEST(ListActions, DrawJavasNumbers) {
  expect_lines({
      {".set_random_seed(42); .random(X); .print(X)", {"0.7275636800328681"}},
      {".set_random_seed(42); .print(math.random)", {"0.7275636800328681"}},
      {".set_random_seed(7); .findall(X, .random([a,b], X, 5), L); .length(L, N); .print(N)",
       {"5"}},
      {".random([], _)", {"failed: ia_failed"}},
      {".random(5)", {"failed: wrong_arguments"}},
      {".random([a], b)", {"failed: wrong_arguments"}},
      {".set_random_seed(a)", {"failed: unknown"}},
  });
}

}  // namespace
}  // namespace jaywalk::test
