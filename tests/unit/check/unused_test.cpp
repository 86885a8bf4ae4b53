// SPDX-License-Identifier: Apache-2.0
// Plans and rules that nothing uses, as far as that can be known.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

const Vocabulary kAlone;

Vocabulary among(std::set<std::string, std::less<>> names) {
  Vocabulary vocabulary = nothing_known();
  vocabulary.others_known = true;
  vocabulary.named_by_others = std::move(names);
  return vocabulary;
}

TEST(CheckUnused, WarnsOfPlansThatNothingTriggers) {
  for (const auto& [text, warnings] : {
           Row{"!g. +!g. +!h.", "1:12 nobody posts the goal 'h'\n"},
           Row{"!g. +!g. +?t(X) <- a(X).", "1:12 nobody asks for 't'\n"},
       }) {
    EXPECT_EQ(warnings_of("unused-plan", text, kAlone), warnings) << text;
    EXPECT_EQ(warnings_of("unused-plan", text), "") << "others may: " << text;
  }
}

TEST(CheckUnused, IsSilentWhereSomethingMayTrigger) {
  for (const char* text : {
           "+!g. +!h.",
           "!g. +!g <- X = h; !X. +!h.",
           "!g. +!g <- .add_plan(\"+!k <- !h.\"). +!h.",
           "!g. +!g <- .at(\"now +1 s\", {+!h}). +!h.",
           "!g. +!g <- .my_name(X). +!h.",
           "!g. +!g. +b[source(bob)]. +!h.",
           "!g. +!g <- .send(bob,tell,p). +!h.",
           "!g. +!g. @[test] +!h.",
           "!g. +!g. +!jag_shutting_down(_).",
           "!g. +!g. -!g. +b. -b.",
           "!g. +!g. +!X. +!h.",
           "!g. +!g <- for (next(G)) { !G }. next(h). +!h.",
       }) {
    EXPECT_EQ(warnings_of("unused-plan", text, kAlone), "") << text;
  }
}

TEST(CheckUnused, KnowsWhatTheOthersOfAProjectSay) {
  EXPECT_EQ(warnings_of("unused-plan", "+!g. +!h.", among({"g"})),
            "1:8 nobody posts the goal 'h'\n");
  EXPECT_EQ(warnings_of("unused-plan", "+!g. +!h.", among({"g", "h"})), "");
  EXPECT_EQ(warnings_of("unknown-goal", "!g.", among({})), "1:2 no plan for the goal 'g'\n");
  EXPECT_EQ(warnings_of("unknown-goal", "!g.", among({"tellHow"})), "") << "others may tell it";
}

TEST(CheckUnused, WarnsOfRulesThatNothingAsksFor) {
  EXPECT_EQ(warnings_of("unused-rule", "!g. +!g. p(X) :- q(X).", kAlone),
            "1:10 nothing asks for 'p'\n");
  for (const char* text : {
           "p(X) :- q(X).",
           "!g. +!g : p(1). p(X) :- q(X).",
           "!g. +!g <- .findall(X,p(X),L). p(X) :- q(X).",
           "!g. +!g <- X = p(1); ?X. p(X) :- q(X).",
           "!g. +!g. p(1).",
           "!g. +!g. select__option(_,_,_,_) :- true.",
           "!g. @a[learned(p)] +!g. observation(p,[X]) :- q(X).",
           "!g. +!g <- .send(bob,tell,k). p(X) :- q(X).",
           "!g. +!g <- .term2string(T,\"p(1)\"); ?T. p(X) :- q(X).",
       }) {
    EXPECT_EQ(warnings_of("unused-rule", text, kAlone), "") << text;
  }
}

TEST(CheckUnused, NamesEveryCheckOnce) {
  std::set<std::string_view> names;
  for (const CheckInfo& check : checks()) {
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
    EXPECT_FALSE(check.summary.empty());
  }
}

}  // namespace
}  // namespace jaywalk
