// SPDX-License-Identifier: Apache-2.0
// Rules unfolded into contexts: an agent behaves as if it queried them.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/compile/compiler.h"
#include "interpreter/program/code_text.h"
#include "tests/unit/coverage/observed.h"

namespace jaywalk {
namespace {

using test::Observed;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> printed(const std::string& program) {
  test::System system;
  system.add("agent", program);
  (void)system.run();
  return system.printed;
}

// Contexts for coverage have probes, and are not unfolded.
std::vector<std::string> printed_observed(const std::string& program) {
  Observed observed(program);
  CoverageObserver coverage(*observed.probes);
  (void)observed.run(coverage);
  return observed.system.printed;
}

std::string code_of(const std::string& program) {
  test::System system;
  system.add("a", program);
  return code_text(*system.agents.front().program, *system.symbols);
}

TEST(UnfoldedRules, StandInTheContext) {
  const std::string code =
      code_of("near(X) :- at(Y) & X - Y < 3.\n+!go(N) : near(N) & ready <- .print(N).\n");
  EXPECT_THAT(code, HasSubstr("query_unfolded     near(N@0)"));
  EXPECT_THAT(code, HasSubstr("  query              at(Y@1)"));
  EXPECT_THAT(code, HasSubstr("((N@0-Y@1) < 3)"));
}

TEST(UnfoldedRules, StandInOneAnother) {
  const std::string code =
      code_of("a(X) :- b(X) & X > 1.\nb(X) :- c(X).\n+!go : a(Z) <- .print(Z).\n");
  EXPECT_THAT(code, HasSubstr("query_unfolded     a(Z@0)"));
  EXPECT_THAT(code, HasSubstr("query_unfolded     b(Z@0)"));
  EXPECT_THAT(code, HasSubstr("query              c(Z@0)"));
}

TEST(UnfoldedRules, StandInThemselvesOnlyOnce) {
  const std::string code = code_of("r(X) :- a(X, Y) & r(Y).\n+!go(X) : r(X) <- .print(X).\n");
  EXPECT_THAT(code, HasSubstr("query_unfolded     r(X@0)"));
  EXPECT_THAT(code, HasSubstr("query              r(Y@1)"));
}

TEST(UnfoldedRules, AreThoseAloneThatAreOneAndSimple) {
  const std::vector<std::string> programs{
      "r(X) :- a(X).\nr(X) :- b(X).\n",     // two of them
      "r(1) :- a(1).\n",                    // wants a value
      "r(f(X)) :- a(X).\n",                 // takes a term apart
      "r(X) :- .member(X, [1, 2]).\n",      // calls an internal action
      "r(X) :- a(X)[source(S)] & b(S).\n",  // looks at annotations
      "r(X) :- a(L) & L =.. [X|_].\n",      // takes a literal apart
      "r(X + 1) :- a(X).\n",                // evaluates its head
      "r(X) :- true.\n",                    // says nothing
  };
  for (const std::string& rule : programs) {
    EXPECT_THAT(code_of(rule + "+!go(X) : r(X) <- .print(X).\n"), Not(HasSubstr("unfolded")))
        << rule;
  }
  EXPECT_THAT(code_of("r(X) :- a(X).\n+!go(X) : r(X + 1) <- .print(X).\n"),
              Not(HasSubstr("unfolded")));
}

TEST(UnfoldedRules, GiveWhatTheRulesGive) {
  const std::vector<std::string> programs{
      "at(4). at(9). near(X) :- at(Y) & X - Y < 3 & Y - X < 3.\n"
      "!go(5). !go(7). !go(1).\n"
      "+!go(N) : near(N) <- .print(near, N).\n+!go(N) <- .print(far, N).\n",
      // An argument that gets a value, and a query with a choice.
      "at(4). at(9). big(X) :- at(X) & X > 5.\n!go.\n+!go : big(X) & X > 8 <- .print(X).\n",
      "at(4). at(9). pair(X, Y) :- at(X) & at(Y) & X < Y.\n!go.\n"
      "+!go : pair(A, B) & not pair(B, A) <- .print(A, B).\n",
      // Either side, and within negations.
      "a(1). b(2). any(X) :- a(X) | b(X).\n!go.\n"
      "+!go : any(X) & X > 1 & not any(3) & not (any(Y) & Y > 5) <- .print(X).\n",
      // The same variable twice, constants, and a rule of no arguments.
      "a(1, 2). a(3, 3). same(X, Y) :- a(X, Y). ready :- same(1, 2).\n!go.\n"
      "+!go : ready & same(Z, Z) & same(1, Two) <- .print(Z, Two).\n",
      // What stays open is printed with its number.
      "a(_). open(X) :- a(X).\n!go(_).\n"
      "+!go(U) : open(X) & not (open(Y) & Y == 3) <- .print(X, U); !again(V).\n"
      "+!again(W) : open(W) <- .print(W).\n",
      // A name that the rule and the plan use for two things.
      "at(4). near(N) :- at(X) & N > X.\n!go(5, 1).\n+!go(N, X) : near(N) & X = 1 <- .print(X).\n",
      // Values are what is looked for, not what is like them.
      "a(f(1)). has(X) :- a(f(X)).\n!go.\n+!go : has(X) & has(1) & not has(2) <- .print(X).\n",
  };
  for (const std::string& program : programs) {
    const auto lines = printed(program);
    EXPECT_FALSE(lines.empty()) << program;
    EXPECT_EQ(lines, printed_observed(program)) << program;
  }
}

TEST(UnfoldedRules, GiveWayToWhatIsBelievedLater) {
  EXPECT_THAT(printed("at(4). near(X) :- at(X).\n"
                      "!go.\n"
                      "+!go <- !look(7); +near(7); !look(7); -near(7); !look(7); !look(4).\n"
                      "+!look(N) : near(N) <- .print(near, N).\n"
                      "+!look(N) <- .print(far, N).\n"),
              ElementsAre("[agent] far7", "[agent] near7", "[agent] far7", "[agent] near4"));
}

TEST(UnfoldedRules, GiveWayToRulesThatAreAddedLater) {
  EXPECT_THAT(printed("at(4). near(X) :- at(X).\n"
                      "!go.\n"
                      "+!go <- !look(7); .assertz({near(X) :- X > 5}); !look(7).\n"
                      "+!look(N) : near(N) <- .print(near, N).\n"
                      "+!look(N) <- .print(far, N).\n"),
              ElementsAre("[agent] far7", "[agent] near7"));
}

TEST(UnfoldedRules, TakeNothingOfOtherNamespaces) {
  const std::string program =
      "{ begin namespace(other) } a(1). { end }\n"
      "other::seen(other::thing). mine(X) :- took(X).\n"
      "took(1).\n!go.\n"
      "+!go : other::seen(other::X) & mine(1) <- .print(X).\n"
      "+!go <- .print(none).\n";
  EXPECT_EQ(printed(program).size(), 1U);
  EXPECT_EQ(printed(program), printed_observed(program));
}

}  // namespace
}  // namespace jaywalk
