// SPDX-License-Identifier: Apache-2.0
// Which programs keep to themselves, so that it does not matter when their agents reason.

#include "interpreter/program/isolation.h"

#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;

bool keeps(const std::string& program) {
  const CompiledProgram made(program);
  EXPECT_EQ(made.errors(), "");
  return keeps_to_itself(*made.program);
}

TEST(KeepsToItself, WhoChangesItsBeliefsAndGoalsAlone) {
  EXPECT_TRUE(keeps(""));
  EXPECT_TRUE(
      keeps("b(1). r(X) :- b(X) & not c(X) & X > 0. !g.\n"
            "+!g : r(X) <- +c(X); ++d; -b(X); --d; -+e(X); +<f; +>f; ?r(Y); !g; !!h;\n"
            "  if (b(1)) { !g } else { !h }; while (b(Z)) { -b(Z) }; for (b(Q)) { +c(Q) }.\n"
            "+c(X) <- !h. -!g. +?t."));
}

TEST(KeepsToItself, NotWhoActs) {
  EXPECT_FALSE(keeps("+!g <- go."));
  EXPECT_FALSE(keeps("+!g <- .print(1)."));
  EXPECT_FALSE(keeps("+!g : .random(X)."));
  EXPECT_FALSE(keeps("r :- .my_name(X)."));
  EXPECT_FALSE(keeps("+!g <- if (.random(X)) { !h }."));
  EXPECT_FALSE(keeps("+!g <- if (b) { go }."));
  EXPECT_FALSE(keeps("+!g <- a |&| b."));
}

TEST(KeepsToItself, NotWhoDoesWhatIsKnownAtRunTimeOnly) {
  EXPECT_FALSE(keeps("+!g(X) <- X."));
  EXPECT_FALSE(keeps("+!g(X) <- !X."));
  EXPECT_FALSE(keeps("+!g(X) : X."));
  EXPECT_FALSE(keeps("+!X."));
  EXPECT_FALSE(keeps("+!g(N) : N::b."));
}

TEST(KeepsToItself, NotWhoAsksThePlansForMessages) {
  EXPECT_FALSE(keeps("+!g <- !kqml_received(a, tell, b, c)."));
  EXPECT_FALSE(keeps("+!kqml_received(A, B, C, D) <- +b."));
}

TEST(KeepsToItself, NotWhoHearsOfTheSystem) {
  EXPECT_FALSE(keeps("+!jag_sleeping <- +b."));
  EXPECT_FALSE(keeps("+!jag_awaking <- +b."));
  EXPECT_FALSE(keeps("+!jag_shutting_down(T) <- +b."));
}

TEST(KeepsToItself, NotWhoseGoalsHaveAnnotationsWhichMaySetTimers) {
  EXPECT_FALSE(keeps("+!g <- !h[hard_deadline(10)]."));
  EXPECT_FALSE(keeps("+!g. { +!h. }"));
}

}  // namespace
}  // namespace jaywalk
