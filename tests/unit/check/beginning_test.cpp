// SPDX-License-Identifier: Apache-2.0
// Programs that no goal begins.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

Vocabulary by_itself() {
  Vocabulary vocabulary;
  vocabulary.begins_by_itself = true;
  return vocabulary;
}

TEST(CheckBeginning, FindsAFactThatIsMeantForAGoalWhoeverElseThereIs) {
  for (const Vocabulary& vocabulary : {Vocabulary(), nothing_known(), by_itself()}) {
    EXPECT_EQ(warnings_of("s. +!s <- .print(never).", vocabulary),
              "1: missing-goal: 's' is a belief here, and no goal begins the program (did you mean "
              "'!s'?)\n");
    EXPECT_EQ(warnings_of("n(1).\nwalk(3). +!walk(N) : n(M) <- !walk(N - M).", vocabulary),
              "2: missing-goal: 'walk' is a belief here, and no goal begins the program (did you "
              "mean '!walk'?)\n");
  }
}

TEST(CheckBeginning, LeavesFactsAloneThatAreUsedAsFacts) {
  for (const char* text :
       {"s. +!s : s <- .print(a).", "s. +!t : s <- .print(a). +!s.", "s. +!s <- -s.", "s. +s. +!s.",
        "s. +!s <- .count(s,N); .print(N).", "s(1). +!s.", "s. +!t.", "!t. s. +!t. +!s."}) {
    EXPECT_EQ(warnings_of("missing-goal", text), "") << text;
  }
  Vocabulary among;
  among.named_by_others = {"s"};
  EXPECT_EQ(warnings_of("missing-goal", "s. +!s.", among), "");
}

TEST(CheckBeginning, FindsAProgramThatIsRunWithoutAGoal) {
  for (const auto& [text, warning] : {
           Row{"+!walk <- !step. +!step <- .print(a).",
               "1:3 no goal begins the program, so that it does nothing\n"},
           Row{"p(1). +q(X) <- .print(X).",
               "1:1 no plan is for anything that the agent believes or perceives, so that it does "
               "nothing\n"},
           Row{"p(1). r(X) :- p(X).", "1:1 the program has no plan, so that it does nothing\n"},
           Row{"", "1:1 the program has no plan, so that it does nothing\n"},
           Row{"-!walk.",
               "1:1 no plan is for anything that the agent believes or perceives, so that "
               "it does nothing\n"},
       }) {
    EXPECT_EQ(warnings_of("missing-goal", text, by_itself()), warning) << text;
    EXPECT_EQ(warnings_of("missing-goal", text), "") << "others may begin it: " << text;
  }
}

TEST(CheckBeginning, NamesTheGoalThatNoPlanPosts) {
  EXPECT_EQ(warnings_of("+!step <- .print(a). +!walk <- !step.", by_itself()),
            "1: missing-goal: no goal begins the program, so that it does nothing (begin with a "
            "goal: !walk.)\n");
}

TEST(CheckBeginning, IsSilentIfSomethingBegins) {
  Vocabulary perceives = by_itself();
  perceives.percepts.push_back({.name = "tick", .least_args = 1, .most_args = 1, .summary = ""});
  EXPECT_EQ(warnings_of("missing-goal", "+tick(_) <- !go. +!go.", perceives), "");
  for (const char* text : {"!walk. +!walk.", "p(1). +p(X) <- .print(X).", "p. +B <- .print(B).",
                           "{ begin mg(p) } { end }", "{ begin namespace(x) } !a. +!a. { end }"}) {
    EXPECT_EQ(warnings_of("missing-goal", text, by_itself()), "") << text;
  }
  EXPECT_EQ(warnings_with({{"inc.asl", "!go. +!go."}}, "{ include(\"inc.asl\") } p.", by_itself()),
            "");
}

}  // namespace
}  // namespace jaywalk
