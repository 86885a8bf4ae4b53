// SPDX-License-Identifier: Apache-2.0
// Percepts that a scenario does not give.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

Vocabulary blind() {
  Vocabulary vocabulary;
  vocabulary.environment_known = true;
  for (const char* name : {"seen", "at"}) {
    vocabulary.percepts.push_back(
        {.name = name, .least_args = 1, .most_args = 1, .summary = {}, .values = {}});
  }
  vocabulary.percepts.front().absent_without = "world.sight";
  return vocabulary;
}

std::string absent_in(const std::string& text) {
  return warnings_of("absent-percept", text, blind());
}

TEST(AbsentPercepts, AreAskedForOrReactedTo) {
  const std::string message = " the scenario does not give the percept 'seen'\n";
  for (const auto& [text, place] : {
           Row{"!go. +!go : seen(X) & at(X) <- a.", "1:13"},
           Row{"!go. +!go : not seen(1) <- a.", "1:17"},
           Row{"!go. +!go <- ?seen(X); a(X).", "1:15"},
           Row{"!go. +!go <- .findall(X, seen(X), L); a(L).", "1:26"},
           Row{"+seen(X) <- a(X).", "1:2"},
           Row{"-seen(X) <- a(X).", "1:2"},
           Row{"near(X) :- seen(X). !go. +!go : near(X) <- a(X).", "1:12"},
       }) {
    EXPECT_EQ(absent_in(text), place + message) << text;
  }
}

TEST(AbsentPercepts, AreReportedOnce) {
  EXPECT_EQ(absent_in("!go. +!go : seen(1) <- a. +!go : seen(2) <- b. +seen(3) <- c."),
            "1:13 the scenario does not give the percept 'seen'\n");
}

TEST(AbsentPercepts, AreNoneThatTheProgramGivesItself) {
  for (const char* text : {
           "!go. +!go : at(X) <- a(X).",
           "!go. +!go : seen(1, 2) <- a.",
           "seen(1). !go. +!go : seen(X) <- a(X).",
           "seen(X) :- at(X). !go. +!go : seen(X) <- a(X).",
           "!go. +!go <- +seen(1); !on. +!on : seen(X) <- a(X).",
           "!go. +!go <- .send(bob, tell, seen(1)). +seen(X) <- a(X).",
           "!go. +!go <- ?seen(X); a(X). +?seen(1).",
           "!go. +!go : seen(X) <- a(X).  // jaywalk: allow absent-percept",
           "// jaywalk: allow-file absent-percept\n\n\n!go. +!go : seen(X) <- a(X).",
       }) {
    EXPECT_EQ(absent_in(text), "") << text;
  }
}

}  // namespace
}  // namespace jaywalk
