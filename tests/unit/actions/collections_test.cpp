// SPDX-License-Identifier: Apache-2.0
// .set.* .map.* .queue.*

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"
#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(SetActions, KeepElementsSortedAndOnce) {
  expect_lines({
      {".set.create(S); .set.add(S, c); .set.add(S, a); .set.add(S, c); .print(S)", {"{a,c}"}},
      {".set.add(S, x); .print(S)", {"{x}"}},
      {".set.add_all(S, [b,2,\"t\"]); .set.to_list(S, L); .print(L)", {"[2,\"t\",b]"}},
      {".set.add_all(S, [a,b]); .set.remove(S, a); .set.remove(S, z); .print(S)", {"{b}"}},
      {".set.add_all(S, [a,b]); .set.union(S, [c]); .print(S)", {"{a,b,c}"}},
      {".set.add_all(S, [a,b]); .set.intersection(S, [b,c]); .print(S)", {"{b}"}},
      {".set.add_all(S, [a,b]); .set.add(T, a); .set.difference(S, T); .print(S)", {"{b}"}},
      {".set.add_all(S, [a,b]); .set.clear(S); .print(S)", {"{}"}},
      {".set.add_all(S, [a]); .set.copy(S, T); .set.add(T, b); .print(S, T)", {"{a}{a,b}"}},
      {".set.create(S); .set.create(S)", {"failed: ia_failed"}},
      {".set.add(a, b)", {"failed: unknown"}},
      {".set.add_all(S, a)", {"failed: unknown"}},
  });
}

TEST(SetActions, CompareByContents) {
  expect_lines({
      {".set.add_all(S, [a,b]); .set.add_all(T, [b,a]); S == T; S = T; .print(yes)", {"yes"}},
      {".set.add(S, a); .set.create(T); .sort([S,T,z,S], L); .print(L)", {"[z,{},{a},{a}]"}},
  });
}

TEST(SetActions, AreSharedByReference) {
  expect_lines(
      {
          {".set.create(S); +keep(S); !fill; .print(S)", {"{x}"}},
      },
      "+!fill <- ?keep(T); .set.add(T, x).");
}

TEST(MapActions, GiveKeysValues) {
  expect_lines({
      {".map.create(M); .map.put(M, two, \"2\"); .map.put(M, one, 1); .print(M)",
       {"{one->1,two->\"2\"}"}},
      {".map.put(M, k, 1); .map.put(M, k, 2); .map.get(M, k, V); .print(V)", {"2"}},
      {".map.put(M, k, 1); .map.get(M, z, V)", {"failed: ia_failed"}},
      {".map.put(M, k, 1); .map.get(M, z, V, none); .print(V)", {"none"}},
      {".map.put(M, b, 1); .map.put(M, a, 2); .findall(K, .map.key(M, K), L); .print(L)",
       {"[a,b]"}},
      {".map.put(M, b, 1); .map.put(M, a, 2); .findall(K, .map.value(M, K), L); .print(L)",
       {"[2,1]"}},
      {".map.put(M, k, 1); .map.remove(M, k, V); .print(V, M)", {"1{}"}},
      {".map.create(M); .map.remove(M, k, V)", {"failed: ia_failed"}},
      {".map.put(M, k, 1); .map.copy(M, N); .map.clear(M); .print(M, N)", {"{}{k->1}"}},
      {".map.get(a, k, V)", {"failed: unknown"}},
  });
}

TEST(QueueActions, GiveBackInOrder) {
  expect_lines({
      {".queue.create(Q); .queue.add(Q, 2); .queue.add_all(Q, [1,\"a\"]); .print(Q)",
       {"[2, 1, \"a\"]"}},
      {".queue.create(Q); .queue.add_all(Q, [2,1]); .queue.head(Q, H); .queue.remove(Q, R); "
       ".queue.to_list(Q, L); .print(H, R, L)",
       {"22[1]"}},
      {".queue.create(Q, priority); .queue.add_all(Q, [5,3,9,1]); .queue.remove(Q, A); "
       ".queue.remove(Q, B); .print(A, B, Q)",
       {"13[5, 9]"}},
      {".queue.create(Q); .queue.head(Q, _)", {"failed: ia_failed"}},
      {".queue.create(Q); .queue.remove(Q, _)", {"failed: ia_failed"}},
      {".queue.create(Q); .queue.add(Q, a); .queue.copy(Q, C); .queue.clear(Q); .print(Q, C)",
       {"[][a]"}},
      {".queue.add(Q, a)", {"failed: unknown"}},
  });
}

TEST(Collections, KeepTheirElementsThroughBacktrackingAndCollection) {
  const std::string program =
      "!a. +!a <- .set.create(S); +keep(S); !fill(0)."
      "+!fill(K) : K < 300 & keep(S) & .set.add(S, f(K, \"text\")) & not .fail"
      "  <- .findall(g(X, Y), .range(X, 1, 20) & Y = X * 2, _); !fill(K + 1)."
      "+!fill(_) <- ?keep(S); .length(S, N); .set.to_list(S, L); .nth(299, L, E); .print(N, E).";
  EXPECT_THAT(printed_by(program), ::testing::ElementsAre("300f(299,\"text\")"));
}

TEST(Collections, TravelAsCopies) {
  const AgentRun run = run_agents(
      {{"ann", "!a. +!a <- .set.add_all(S, [b,a]); .send(bob, tell, bag(S)); .set.clear(S)."},
       {"bob", "+bag(S) <- .set.add(S, c); .print(S)."}});
  EXPECT_THAT(run.printed, ::testing::ElementsAre("[bob] {a,b,c}"));
}

}  // namespace
}  // namespace jaywalk::test
