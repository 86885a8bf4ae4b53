// SPDX-License-Identifier: Apache-2.0
// Labels of plans whose annotations have variables.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<std::string> printed(const std::string& program) { return test::printed_by(program); }

TEST(Labels, MayHaveVariablesWhereRelevantPlansAreAskedFor) {
  EXPECT_THAT(printed("@l[x(Y)] +!greet. !m. +!m <- .relevant_plans({+!greet}, P, [L]); "
                      "L = l[x(1)|_]; .length(P, N); .print(N)."),
              ElementsAre("1"));
  EXPECT_THAT(printed("@l[x(Y)] +!greet(Y). !m. "
                      "+!m <- for (.relevant_plan({+!greet(_)}, P)) { .print(P) }."),
              ElementsAre(AllOf(HasSubstr("@l["), HasSubstr("x("))));
}

TEST(Labels, MayHaveAnOpenTailWhereIntentionsAreTerms) {
  EXPECT_THAT(printed("!m. @l[x|T] +!m <- .current_intention(intention(_, [im(L, _, _, _)])); "
                      "L = l[x|_]; .print(yes)."),
              ElementsAre("yes"));
  EXPECT_THAT(printed("!m. @l[x(Y)] +!m <- .intention(_, S, [im(L, _, _, _)|_]); "
                      "L = l[x(_)|_]; .print(S)."),
              SizeIs(1));
}

TEST(Labels, MayHaveVariablesWhenAPlanIsAddedAndTakenAway) {
  EXPECT_THAT(printed("!m. +!m <- .add_plan({@l[x(Y)|T] +!g(Y) <- .print(Y)}); "
                      ".relevant_plans({+!g(_)}, _, [L]); !g(1); "
                      ".remove_plan(l); .relevant_plans({+!g(_)}, Q); .print(Q)."),
              ElementsAre("1", "[]"));
  EXPECT_THAT(printed("!m. +!m <- .add_plan(\"@l[x(Y)] +!g <- .print(a)\", bob); "
                      ".add_plan({@l[x(Y)] +!g <- .print(a)}, ann); .remove_plan(l, bob); "
                      ".plan_label(P, l); .relevant_plans({+!g}, _, [L]); !g."),
              ElementsAre("a"));
}

TEST(Labels, MayHaveVariablesWherePlansAreWritten) {
  EXPECT_THAT(printed("@l[x(Y)] +!g(Y). !m. +!m <- .list_plans({+!g(_)})."), SizeIs(1));
  EXPECT_THAT(printed("@l[x(Y)] +!g(Y). !m. +!m <- for (.plan_label(P, l)) { .print(P) }."),
              SizeIs(1));
}

}  // namespace
}  // namespace jaywalk
