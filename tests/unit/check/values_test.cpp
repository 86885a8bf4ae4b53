// SPDX-License-Identifier: Apache-2.0
// Atoms in arguments that are almost those that stand there otherwise.

#include <gtest/gtest.h>

#include "interpreter/check/checking.h"
#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

Vocabulary road() {
  Vocabulary vocabulary;
  vocabulary.environment_known = true;
  vocabulary.percepts = {{.name = "ground",
                          .least_args = 2,
                          .most_args = 2,
                          .summary = {},
                          .values = {{"left", "right"}, {"lane", "pavement"}}}};
  vocabulary.actions = {{.name = "move",
                         .least_args = 1,
                         .most_args = 1,
                         .summary = {},
                         .values = {{"left", "right", "forward", "back"}}}};
  return vocabulary;
}

std::string values_of(const std::string& text, const Vocabulary& vocabulary = road()) {
  return warnings_of("unknown-value", text, vocabulary);
}

TEST(Slips, AreOneLetterMoreLessOrChangedOrTwoThatChangePlaces) {
  for (const char* slip : {"rigt", "rightt", "riggt", "rigth", "right1", "ight"}) {
    EXPECT_TRUE(is_one_slip(slip, "right")) << slip;
    EXPECT_TRUE(is_one_slip("right", slip)) << slip;
  }
  for (const char* other : {"right", "rgiht1", "left", "", "rightly", "thgir"}) {
    EXPECT_FALSE(is_one_slip(other, "right")) << other;
  }
}

TEST(UnknownValues, AreThoseThatTheEnvironmentDoesNotDeclare) {
  for (const auto& [text, warnings] : {
           Row{"+!go <- move(rigth).", "1:14 'rigth' is none of the values that occur here\n"},
           Row{"+!go <- move(lft).", "1:14 'lft' is none of the values that occur here\n"},
           Row{"+!go <- move(up).", "1:14 'up' is none of the values that occur here\n"},
           Row{"+!go : ground(left, lnae) <- a.",
               "1:21 'lnae' is none of the values that occur here\n"},
           Row{"+!go : ground(left, grass) <- a.",
               "1:21 'grass' is none of the values that occur here\n"},
           Row{"+!go : ground(W, K) & K \\== pavment <- move(W).",
               "1:29 'pavment' is none of the values that occur here\n"},
       }) {
    EXPECT_EQ(values_of(text), warnings) << text;
  }
}

TEST(UnknownValues, FollowVariablesToWhereTheyAreWrong) {
  for (const auto& [text, warnings] : {
           Row{"way(forwrd). +!go : way(W) <- move(W).",
               "1:5 'forwrd' is none of the values that occur here\n"},
           Row{"+!go : way(W) <- move(W). +!b <- -+way(bakc).",
               "1:40 'bakc' is none of the values that occur here\n"},
           Row{"across(rigth) :- at(X). +!go : across(W) <- !cross(W). +!cross(V) <- move(V).",
               "1:8 'rigth' is none of the values that occur here\n"},
           Row{"+!go <- .random([forwrd, back], W); move(W).",
               "1:18 'forwrd' is none of the values that occur here\n"},
           Row{"+!go <- W = lefft; move(W).",
               "1:13 'lefft' is none of the values that occur here\n"},
           Row{"way(nowhere). +!go : way(nowhre) <- a. +!go : way(W) <- move(W).",
               "1:26 'nowhre' is none of the values that occur here\n"},
           Row{"+!go : best(option(W, _)) <- move(W). best(option(lefft, 3)).",
               "1:51 'lefft' is none of the values that occur here\n"},
       }) {
    EXPECT_EQ(values_of(text), warnings) << text;
  }
}

TEST(UnknownValues, MayBeOtherWordsThatAPlanKnowsWhatToDoWith) {
  for (const char* text : {
           "first(either). +!go : first(either) <- a. +!go : first(W) <- move(W).",
           "ground(left, grass). +!go : ground(left, grass) <- move(left).",
           "+!go : way(none) <- a. +!go : way(W) <- move(W). +!b <- +way(none).",
           "wait(long). +!go : wait(short) <- move(left).",
       }) {
    EXPECT_EQ(values_of(text), "") << text;
  }
}

TEST(UnknownValues, AreInferredFromTheProgramAlone) {
  const Vocabulary none = nothing_known();
  for (const auto& [text, warnings] : {
           Row{"state(waiting). +!go : state(waitng) <- a.",
               "1:30 'waitng' is none of the values that occur here\n"},
           Row{"+!go : state(waitng) <- a. +!b <- -+state(waiting).",
               "1:14 'waitng' is none of the values that occur here\n"},
           Row{"!go(crossing). +!go(corssing) <- a.",
               "1:21 'corssing' is none of the values that occur here\n"},
           Row{"state(S) :- mode(S). mode(waiting). +!go : state(waitng) <- a.",
               "1:50 'waitng' is none of the values that occur here\n"},
           // The one that occurs more often is meant.
           Row{"state(waitng). +!go : state(waiting) <- a. +!b : not state(waiting) <- b.",
               "1:7 'waitng' is none of the values that occur here\n"},
       }) {
    EXPECT_EQ(values_of(text, none), warnings) << text;
  }
}

TEST(UnknownValues, AreNotWhatIsToldApartOnPurpose) {
  for (const char* text : {
           "state(table1). +!go : state(table2) <- a.",
           "state(locks). +!go : state(lock) <- a.",
           "state(open). +!go : state(oper) <- a.",
           "state(waiting). +!go : state(sleeping) <- a.",
           "state(waiting). +!go : state(waitng) <- a. other(waitng).",
           "state(waiting). +!go : state(S) & S \\== a <- a.",
       }) {
    EXPECT_EQ(values_of(text, nothing_known()), "") << text;
  }
  Vocabulary others = nothing_known();
  others.named_by_others.insert("waitng");
  EXPECT_EQ(values_of("state(waiting). +!go : state(waitng) <- a.", others), "");
}

TEST(UnknownValues, AreLookedForInSettingsOfScenarios) {
  const auto source = std::make_shared<const Source>("s.yaml", "first_way: forwards");
  Vocabulary vocabulary = road();
  const std::string program =
      "first_way(either). +!go : first_way(either) <- a. +!go : first_way(W) <- move(W).";
  const auto with = [&](const char* value) {
    vocabulary.settings = {{.name = "first_way", .atoms = {value}, .where = {source, {11, 19}}}};
    return values_of(program, vocabulary);
  };
  EXPECT_EQ(with("forwards"), "1:12 'forwards' is none of the values that occur here\n");
  EXPECT_EQ(with("sideways"), "1:12 'sideways' is none of the values that occur here\n");
  EXPECT_EQ(with("forward"), "");
  EXPECT_EQ(with("either"), "");
}

TEST(UnknownValues, AreStringsWhereAtomsAreMeant) {
  EXPECT_EQ(values_of("!g. +!g <- move(\"right\")."),
            "1:17 \"right\" is a string, and the values here are atoms\n");
  EXPECT_EQ(values_of("!g. +!g <- move(\"rigth\")."),
            "1:17 \"rigth\" is a string, and the values here are atoms\n");
  EXPECT_EQ(values_of("!g. +!g <- move(\"up\")."),
            "1:17 \"up\" is a string, and the values here are atoms\n");
  EXPECT_EQ(values_of("!go(\"right\"). +!go(W) <- move(W)."),
            "1:5 \"right\" is a string, and the values here are atoms\n");
  EXPECT_EQ(values_of("!g. +!g : ground(left, \"lane\") <- move(left)."),
            "1:24 \"lane\" is a string, and the values here are atoms\n");
  EXPECT_EQ(values_of("side(left). !g. +!g : side(\"left\") <- .print(a).", nothing_known()),
            "1:28 \"left\" is a string, and the values here are atoms\n");
}

TEST(UnknownValues, AreNotStringsThatAreValuesThemselves) {
  for (const char* text :
       {"name(\"left\"). !g. +!g : name(\"left\") <- .print(left).",
        "side(left). name(\"left\"). !g. +!g : name(X) & side(Y) <- .print(X, Y).",
        "side(left). side(\"left\"). !g. +!g : side(\"left\") <- .print(a).",
        "!g. +!g : told(\"left\") <- .print(left).", "!g(\"left\"). +!g(W) <- .print(W)."}) {
    EXPECT_EQ(values_of(text), "") << text;
    EXPECT_EQ(values_of(text, nothing_known()), "") << text;
  }
}

}  // namespace
}  // namespace jaywalk
