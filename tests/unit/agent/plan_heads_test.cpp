// SPDX-License-Identifier: Apache-2.0
// Triggers of plans are matched with the arguments of a goal. The goal can be rebuilt from the
// plan's variables afterwards.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;

/// The output when a goal meets plans.
std::vector<std::string> printed(const std::string& goal, const std::string& plans) {
  return test::printed_by("!start. +!start <- !" + goal + ". " + plans);
}

TEST(PlanHeads, TakeListsApart) {
  const std::string plans = "+!g([]) <- .print(none). +!g([H|T]) <- .print(H, \" then \", T).";
  EXPECT_THAT(printed("g([1,2,3])", plans), ElementsAre("1 then [2,3]"));
  EXPECT_THAT(printed("g([])", plans), ElementsAre("none"));
}

TEST(PlanHeads, MakeListsForVariables) {
  EXPECT_THAT(printed("g(L); .print(L)", "+!g([H|T]) <- H = 1; T = [2]."), ElementsAre("[1,2]"));
  EXPECT_THAT(printed("g(L); .print(L)", "+!g([a|T]) <- T = []."), ElementsAre("[a]"));
}

TEST(PlanHeads, KnowAVariableAgain) {
  const std::string plans = "+!g(X, X) <- .print(same, X). +!g(X, Y) <- .print(X, Y).";
  EXPECT_THAT(printed("g(2, 2)", plans), ElementsAre("same2"));
  EXPECT_THAT(printed("g(2, 3)", plans), ElementsAre("23"));
  EXPECT_THAT(printed("g(Z, 3); .print(Z)", plans), ElementsAre("same3", "3"));
}

TEST(PlanHeads, MatchConstantsWithoutTheirAnnotations) {
  EXPECT_THAT(printed("g(a[k])", "+!g(a) <- .print(yes)."), ElementsAre("yes"));
  EXPECT_THAT(printed("g(a)", "+!g(a[k]) <- .print(yes). +!g(_) <- .print(no)."),
              ElementsAre("no"));
}

TEST(PlanHeads, TellTheGoalThatFailed) {
  const std::string handler = " -!g(X) <- .print(X).";
  EXPECT_THAT(printed("g([1,b])", "+!g([H|T]) <- .fail." + handler), ElementsAre("[1,b]"));
  EXPECT_THAT(printed("g(a[k])", "+!g(a) <- .fail." + handler), ElementsAre("a[k]"));
  EXPECT_THAT(printed("g([a[k]])", "+!g([a|T]) <- .fail." + handler), ElementsAre("[a[k]]"));
  EXPECT_THAT(printed("g(f(1)[k])", "+!g(f(X)) <- .fail." + handler), ElementsAre("f(1)[k]"));
}

TEST(PlanHeads, TellOtherPlansOfTheGoal) {
  EXPECT_THAT(printed("g([1,2])", "+!g([H|T]) <- !h. +!h : .intend(g(L)) <- .print(L)."),
              ElementsAre("[1,2]"));
}

TEST(PlanHeads, FreeWhatTheBodyHasBoundWhenTheGoalFails) {
  EXPECT_THAT(
      printed("g([1|R]); .print(R)", "+!g([H|T]) <- T = [2]; .fail. -!g([_|T]) <- T = [3]."),
      ElementsAre("[3]"));
}

TEST(PlanHeads, MayHaveTermsThatShareTheirParts) {
  const std::string grow = "+!grow(0, T, T). +!grow(N, S, T) : N > 0 <- !grow(N-1, p(S, S), T).";
  EXPECT_THAT(printed("grow(60, a, T); +{ +!g(T, Y) <- .print(Y) }; !g(T, 5)", grow),
              ElementsAre("5"));
  EXPECT_THAT(printed("grow(60, a, T); +{ r(T, Y) :- Y = 1 }; ?r(T, Y); .print(Y)", grow),
              ElementsAre("1"));
}

TEST(PlanHeads, OfSubPlansKnowTheVariablesAroundThem) {
  EXPECT_THAT(printed("g(1)",
                      "+!g(X) <- !h(1, 5); !h(2, 6). {"
                      "  +!h(X, Y) <- .print(mine, Y)."
                      "  +!h(Z, Y) <- .print(another, Y). }"),
              ElementsAre("mine5", "another6"));
}

}  // namespace
}  // namespace jaywalk
