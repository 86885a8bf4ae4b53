// SPDX-License-Identifier: Apache-2.0
// What included files ask the including program to define, and checks that look across includes.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

const Vocabulary kAlone;

const Included kLibrary = {
    {"lib.asl", "// jaywalk: asks ready/0\n!go. +!go : ready <- .print(go). +!go <- !go."}};

std::string with_library(const std::string& text, const Vocabulary& vocabulary = kAlone) {
  return warnings_with(kLibrary, "{ include(\"lib.asl\") }\n" + text, vocabulary);
}

TEST(CheckAsked, IsSatisfiedByARuleABeliefAndWhatIsAddedOrPerceived) {
  for (const char* text : {"ready :- true.", "ready.", "ready[source(self)].",
                           "+!other <- +ready. !other.", "+?ready <- true."}) {
    EXPECT_EQ(with_library(text), "") << text;
  }
  Vocabulary perceived;
  perceived.percepts.push_back({.name = "ready", .summary = ""});
  EXPECT_EQ(with_library("", perceived), "");
}

TEST(CheckAsked, PointsAtTheIncludeIfNothingIsLikeIt) {
  EXPECT_EQ(with_library(""),
            "1: missing-definition: 'lib.asl' asks for 'ready', which this program does not define "
            "(add a rule: ready :- ...)\n");
  EXPECT_EQ(with_library("", nothing_known()), with_library("")) << "others cannot define it";
}

TEST(CheckAsked, PointsAtTheMisspeltDefinitionAlone) {
  const char* const kSlip =
      "2: missing-definition: 'lib.asl' asks for 'ready', which this program does not define "
      "(did you mean 'ready'?)\n";
  EXPECT_EQ(with_library("raedy :- true."), kSlip);
  EXPECT_EQ(with_library("redy."), kSlip);
}

TEST(CheckAsked, LeavesAloneWhatTheProgramUsesUnderAnotherName) {
  EXPECT_EQ(with_library("reedy :- true. ready :- reedy."), "");
  EXPECT_EQ(with_library("reedy :- true. !b. +!b : reedy."),
            "1: missing-definition: 'lib.asl' asks for 'ready', which this program does not define "
            "(add a rule: ready :- ...)\n");
}

TEST(CheckAsked, SaysIfTheNumberOfArgumentsIsAnother) {
  EXPECT_EQ(with_library("ready(now) :- true."),
            "2: missing-definition: 'lib.asl' asks for 'ready' with 0 arguments, which this "
            "program does not define (here it has 1 argument)\n");
}

TEST(CheckAsked, MayBePassedOnToTheNextIncluder) {
  const Included nested = {{"outer.asl", "// jaywalk: asks ready/0\n{ include(\"lib.asl\") }"},
                           kLibrary.front()};
  EXPECT_EQ(warnings_with(nested, "// jaywalk: asks ready/0\n{ include(\"lib.asl\") }"), "");
  EXPECT_EQ(warnings_with(nested, "\n{ include(\"outer.asl\") }"),
            "2: missing-definition: 'outer.asl' asks for 'ready', which this program does not "
            "define (add a rule: ready :- ...)\n");
  EXPECT_EQ(warnings_of("// jaywalk: asks ready/0\nsteady. !go. +!go : ready & steady.", kAlone),
            "")
      << "the library by itself";
}

TEST(CheckAsked, IsOfGoalsToo) {
  const Included library = {{"lib.asl", "// jaywalk: asks !cross/1\n!go. +!go <- !cross(left)."}};
  const std::string include = "{ include(\"lib.asl\") }\n";
  EXPECT_EQ(warnings_with(library, include + "+!cross(W) <- .print(W).", kAlone), "");
  EXPECT_EQ(warnings_with(library, include + "+!corss(W) <- .print(W).", kAlone),
            "2: missing-definition: 'lib.asl' asks for '!cross', which this program does not "
            "define (did you mean 'cross'?)\n");
  EXPECT_EQ(warnings_with(library, include, kAlone),
            "1: missing-definition: 'lib.asl' asks for '!cross', which this program does not "
            "define (add a plan: +!cross(_) <- ...)\n");
}

TEST(CheckAsked, IsSilentWhereSomethingUnknownMayDefineIt) {
  EXPECT_EQ(with_library("+!other <- .include(\"more.asl\"). !other."), "");
  EXPECT_EQ(with_library("// jaywalk: allow-file missing-definition\n"), "");
}

TEST(CheckAsked, NamesTheLibraryThatDefinesIt) {
  Vocabulary installed;
  installed.libraries = [] {
    return std::vector<Vocabulary::Library>{
        {.name = "$x/steps.asl", .defines = {"ready/0", "near/1", "!cross/0"}, .asks = {"when/0"}}};
  };
  EXPECT_EQ(with_library("", installed),
            "1: missing-definition: 'lib.asl' asks for 'ready', which this program does not define "
            "(include(\"$x/steps.asl\") defines it)\n");
  installed.environment_known = true;
  EXPECT_EQ(
      warnings_of("!go. +!go : near(_) <- !cross.", installed),
      "1: unknown-belief: 'near' is neither a belief nor a percept (include(\"$x/steps.asl\") "
      "defines it)\n"
      "1: unknown-goal: no plan for the goal 'cross' (include(\"$x/steps.asl\") defines it)\n");
  EXPECT_EQ(warnings_of("when :- true.", installed),
            "1: unused-rule: nothing asks for 'when' (include(\"$x/steps.asl\") asks for it)\n");
  EXPECT_EQ(warnings_of("other :- true. near(1) :- true.", installed), "") << "a library, perhaps";
}

TEST(CheckAsked, ReadsOnlyNamesWithTheirNumberOfArguments) {
  EXPECT_EQ(warnings_of("// jaywalk: asks ready\np."),
            "1: unknown-code: expected a name with its number of arguments, found 'ready' (as in "
            "`asks radius/1`, or `asks !cross/0` for a goal)\n");
  EXPECT_EQ(warnings_of("// jaywalk: aks ready/0\np."),
            "1: unknown-code: 'aks' means nothing in a comment for the checker (did you mean "
            "'asks'?)\n");
  EXPECT_EQ(warnings_of("// jaywalk: see the README\np."), "") << "prose";
}

TEST(CheckAcrossIncludes, AnInitialGoalMayStandInAnyFile) {
  const Included library = {{"inc.asl", "!go. +!go <- .print(hi)."}};
  const std::string include = "{ include(\"inc.asl\") }\n";
  EXPECT_EQ(warnings_with(library, include + "foo :- true.", kAlone),
            "2: unused-rule: nothing asks for 'foo'\n");
  EXPECT_EQ(warnings_with(library, include + "+!other.", kAlone),
            "2: unused-plan: nobody posts the goal 'other'\n");
  EXPECT_EQ(warnings_with(library, include + "foo :- true.", nothing_known()), "");
  const Included block = {{"inc.asl", "{ begin namespace(local) } !go. +!go. { end }"}};
  EXPECT_EQ(warnings_with(block, include + "foo :- true.", kAlone),
            "2: unused-rule: nothing asks for 'foo'\n");
}

}  // namespace
}  // namespace jaywalk
