// SPDX-License-Identifier: Apache-2.0
// Laws of the actions for lists, strings, sets, maps and queues, tried with lists at random.

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

/// Lists of up to seven elements, some of them twice: numbers, atoms, strings, structures, lists.
std::vector<std::string> lists(unsigned seed, std::size_t count) {
  const std::vector<std::string> kinds{"1", "2",     "2.5",  "a",       "b",
                                       "c", "\"a\"", "f(1)", "g(a,[])", "[x,y]"};
  std::mt19937 random(seed);
  std::vector<std::string> made;
  for (std::size_t i = 0; i < count; ++i) {
    std::string text;
    for (std::size_t n = random() % 8; n > 0; --n) {
      text += (text.empty() ? "" : ",") + kinds[random() % kinds.size()];
    }
    made.push_back("[" + text + "]");
  }
  return made;
}

/// The body prints `holds` with each list as L, and the next list as M.
void expect_law(const std::string& body, unsigned seed = 1) {
  const std::vector<std::string> all = lists(seed, 25);
  std::vector<BodyRow> rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& next = all[(i + 1) % all.size()];
    rows.push_back(
        {"L = " + all[i] + "; M = " + next + "; " + body + "; .print(holds)", {"holds"}});
  }
  expect_lines(rows);
}

TEST(LawsOfLists, ReversingTwiceChangesNothing) {
  expect_law(".reverse(L, R); .reverse(R, L); .length(L, N); .length(R, N)");
}

TEST(LawsOfLists, ReversingAJoinJoinsTheReversed) {
  expect_law(
      ".concat(L, M, J); .reverse(J, A); .reverse(L, RL); .reverse(M, RM); .concat(RM, RL, A)");
}

TEST(LawsOfLists, SortingKeepsTheElementsAndSortsOnce) {
  expect_law(
      ".sort(L, S); .sort(S, S); .length(L, N); .length(S, N); .reverse(L, R); .sort(R, T); "
      ".length(T, N); for (.member(X, L)) { .member(X, S) }");
}

TEST(LawsOfLists, ShufflingKeepsTheElements) {
  expect_law(".shuffle(L, R); .sort(L, S); .sort(R, S)");
}

TEST(LawsOfLists, UnionsAndIntersectionsDoNotDependOnTheOrder) {
  expect_law(
      ".union(L, M, U); .union(M, L, U); .intersection(L, M, I); .intersection(M, L, I); "
      ".sort(U, U); .sort(I, I)");
}

TEST(LawsOfLists, AUnionIsBothDifferencesAndWhatIsCommon) {
  expect_law(
      ".difference(L, M, A); .difference(M, L, B); .intersection(L, M, I); .union(L, M, U); "
      ".concat(A, B, I, J); .sort(J, U)");
}

TEST(LawsOfLists, EachBeginningHasItsEnd) {
  expect_law(
      ".length(L, N); .findall(P, .prefix(P, L), Ps); .length(Ps, N + 1); "
      "for (.member(P, Ps)) { .length(P, K); .findall(S, .suffix(S, L) & .length(S, N - K), [S]); "
      ".concat(P, S, L) }");
}

TEST(LawsOfLists, EachElementStandsAtAnIndex) {
  expect_law(
      ".findall(X, .nth(_, L, X), L); .length(L, N); "
      "if (N > 0) { .nth(0, L, First); L = [First|_]; .nth(N - 1, L, Last); .reverse(L, [Last|_]) "
      "}");
}

TEST(LawsOfLists, TheGreatestIsLastAndTheLeastFirstInOrder) {
  expect_law(
      "if (L \\== []) { .sort(L, S); .min(L, A); S = [A|_]; .max(L, B); .reverse(S, [B|_]) }");
}

TEST(LawsOfLists, DeletingAnElementLeavesTheOthers) {
  expect_law(  // a number would be an index, a string an expression for texts
      "for (.member(X, L) & not .number(X) & not .string(X)) { .delete(X, L, R); .count(.member(X, "
      "R), 0); "
      ".count(.member(X, L), C); .length(L, N); .length(R, N - C) }");
}

TEST(LawsOfStrings, TextsOfTermsAreReadAgain) {
  expect_law(".term2string(L, T); .term2string(R, T); R == L");
}

TEST(LawsOfStrings, PartsOfATextJoinToIt) {
  expect_law(
      ".term2string(L, T); .length(T, N); for (.range(I, 0, N)) { .substring(T, A, 0, I); "
      ".substring(T, B, I); .concat(A, B, T) }");
}

TEST(LawsOfSets, TheirElementsAreTheListInOrderWithoutDuplicates) {
  expect_law(".set.create(S); .set.add_all(S, L); .set.to_list(S, T); .union(L, [], T)");
}

TEST(LawsOfSets, TheyAgreeWithTheActionsForLists) {
  expect_law(
      ".set.create(S); .set.add_all(S, L); .set.copy(S, A); .set.copy(S, B); .set.copy(S, C); "
      ".set.union(A, M); .set.to_list(A, TA); .union(L, M, TA); "
      ".set.intersection(B, M); .set.to_list(B, TB); .intersection(L, M, TB); "
      ".set.difference(C, M); .set.to_list(C, TC); .difference(L, M, TC)");
}

TEST(LawsOfQueues, WhatComesFirstGoesFirstAndTheLeastInThoseWithPriorities) {
  expect_law(
      ".queue.create(Q); .queue.add_all(Q, L); .queue.to_list(Q, L); .queue.create(P, priority); "
      ".queue.add_all(P, L); .sort(L, S); for (.member(X, S)) { .queue.remove(P, X) }; .empty(P)");
}

TEST(LawsOfMaps, TheLastValueOfAKeyStays) {
  expect_law(
      ".map.create(D); for (.member(X, L)) { .map.put(D, X, old) }; "
      "for (.member(X, M)) { .map.put(D, X, new) }; .union(L, M, U); .findall(K, .map.key(D, K), "
      "U); "
      "for (.member(X, M)) { .map.get(D, X, new) }; .difference(L, M, R); "
      "for (.member(X, R)) { .map.get(D, X, old) }");
}

}  // namespace
}  // namespace jaywalk::test
