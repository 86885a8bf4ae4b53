// SPDX-License-Identifier: Apache-2.0
// Plans that are never chosen, never end or handle no failure.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

TEST(CheckPlans, WarnsOfThoseBehindOneThatIsAlwaysChosen) {
  const auto behind = [](int line) {
    return " this plan is never chosen: the one at line " + std::to_string(line) +
           " is, whenever this could be\n";
  };
  for (const auto& [text, place] : {
           Row{"+!g.\n+!g <- a.", "2:3"},
           Row{"+!g(X).\n+!g(1) <- a.", "2:3"},
           Row{"+!g(X,Y) : true.\n+!g(A,f(A)) : b <- a.", "2:3"},
           Row{"+b(X).\n+b(X)[source(percept)] <- a.", "2:2"},
           Row{"+!g(X) : b(X).\n+!g(X) : b(X) <- a.", "2:3"},
           Row{"-!g(_).\n-!g(X)[error(E)] <- a.", "2:3"},
           Row{"+!g(X,X).\n+!g(1,1).", "2:3"},
           Row{"@a[learned(p)] +!g.\n+!g <- a.", "2:3"},
           Row{"+!g.\n@a[learned(p)] +!g <- a.", "2:18"},
           Row{"+!h. {\n+!g.\n+!g <- a. }", "3:3"},
       }) {
    EXPECT_EQ(warnings_of("unreachable-plan", text), place + behind(*place - '1')) << text;
  }
}

TEST(CheckPlans, IsSilentAboutThoseThatCanBeChosen) {
  for (const char* text : {
           "+!g : b. +!g <- a.",
           "+!g(1). +!g(X) <- a.",
           "+!g(X,X). +!g(X,Y) <- a.",
           "+!g(X,X). +!g(_,_) <- a.",
           "+!g[source(self)]. +!g <- a.",
           "+b. -b. +!b. +?b. -!b.",
           "+b. +~b.",
           "+!g. +!g(X).",
           "+!g(f(X)). +!g(X).",
           "n::p. { begin namespace(m) } +!g. { end } +!g <- a.",
           "+!g. +!g <- a. +!h <- .remove_plan(l).",
           "+!g. +!g <- a. select__option(_,_,_,_).",
           "@a[learned(p)] +!g <- a. @b[learned(p)] +!g <- b.",
           "{ begin ebdg(g) } +!g <- a. +!g <- b. { end }",
           "+!g([X|T]). +!g([]) <- a.",
           "+!g(\"a\"). +!g(\"b\").",
           "+n::b. +m::b.",
       }) {
    EXPECT_EQ(warnings_of("unreachable-plan", text), "") << text;
  }
}

TEST(CheckPlans, WarnsOfFormulasAfterFail) {
  EXPECT_EQ(warnings_of("unreachable-formula", "+!g <- a; .fail; b; c."),
            "1:18 this is never done: the '.fail' before it fails\n");
  EXPECT_EQ(warnings_of("unreachable-formula", "+!g <- if (x) { .fail(why); b }."),
            "1:29 this is never done: the '.fail' before it fails\n");
  for (const char* text : {"+!g <- a; .fail.", "+!g <- if (x) { .fail }; b.",
                           "+!g <- .fail ||| b; c.", "+!g <- .failed; b."}) {
    EXPECT_EQ(warnings_of("unreachable-formula", text), "") << text;
  }
}

TEST(CheckPlans, WarnsOfFailurePlansOfNoGoal) {
  EXPECT_EQ(warnings_of("+!cross. -!corss."),
            "1: orphan-failure-plan: there is a plan for the failure of 'corss', but none for the "
            "goal (did you mean 'cross'?)\n");
  EXPECT_EQ(warnings_of("+!go. -!go(X)."),
            "1: orphan-failure-plan: there is a plan for the failure of 'go', but none for the "
            "goal (the plans +! for it have another number of arguments)\n");
  for (const char* text :
       {"+!g. -!g.", "+!G. -!g.", "-!g. +!h <- .add_plan(P).", "-?t.", "-b.",
        "-!kqml_received(A,B,C,D).", "{ begin bdg(g) } +!g. { end } -!g.", "+!h. { +!g. } -!g."}) {
    EXPECT_EQ(warnings_of("orphan-failure-plan", text), "") << text;
  }
}

TEST(CheckPlans, WarnsOfAtomicPlansThatWait) {
  for (const auto& [text, warnings] : {
           Row{"@l[atomic] +!g <- a; .wait(10).",
               "1:22 the whole agent waits for '.wait' in an atomic plan\n"},
           Row{"@[atomic] +!g <- if (b) { .suspend }.",
               "1:27 the whole agent waits for '.suspend' in an atomic plan\n"},
           Row{"@l[cost(1),atomic] +!g <- .send(bob,askOne,p(X),A).",
               "1:27 the whole agent waits for '.send' in an atomic plan\n"},
       }) {
    EXPECT_EQ(warnings_of("waiting-atomic", text), warnings) << text;
  }
  for (const char* text :
       {"@l +!g <- .wait(10).", "@l[atomic] +!g <- .send(bob,tell,p).",
        "@l[atomic] +!g <- .send(bob,askOne,p(X)).", "@l[atomic] +!g <- .suspend(h).",
        "@l[atomic] +!g <- !h({ .wait(10) }).", "@atomic +!g <- .wait(10)."}) {
    EXPECT_EQ(warnings_of("waiting-atomic", text), "") << text;
  }
}

TEST(AtomsForVariables, AreThoseThatNoBeliefHasAndTheClauseAloneUses) {
  for (const auto& [text, warnings] : {
           Row{"age(bob, 3). +!go : age(bob, x) <- a(x).",
               "1:30 'x' is an atom, which no 'age' has there\n"},
           Row{"age(bob, 3). old(p) :- age(p, A) & A > 2.",
               "1:28 'p' is an atom, which no 'age' has there\n"},
           Row{"age(bob, 3). +!go : not age(x, _) <- a(x).",
               "1:29 'x' is an atom, which no 'age' has there\n"},
       }) {
    EXPECT_EQ(warnings_of("atom-for-variable", text), warnings) << text;
  }
}

TEST(AtomsForVariables, AreNotAtomsThatMayBeTold) {
  for (const char* text : {
           "age(bob, 3). +!go : age(ann, X) <- a(X).",             // once
           "+!go : age(ann, X) <- a(ann).",                        // nothing is known of age
           "age(bob, 3). +!go : age(ann, X) <- a(ann). !b(ann).",  // used elsewhere
           "age(bob, 3). +!go : age(ann, X) <- +age(Y, 1); a(ann).",
           "age(W, 3) :- who(W). +!go : age(ann, X) <- a(ann).",
           "age(ann, 3). +!go : age(ann, X) <- a(ann).",
       }) {
    EXPECT_EQ(warnings_of("atom-for-variable", text), "") << text;
  }
}

}  // namespace
}  // namespace jaywalk
