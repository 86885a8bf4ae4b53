// SPDX-License-Identifier: Apache-2.0
// Conversations with an agent at the prompt.

#include "tools/jaywalk/repl/repl_session.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/console/console.h"

namespace jaywalk {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The standard output and standard error of a session.
struct Said {
  std::string output;
  std::string errors;
  bool had_mistakes = false;
  bool goes_on = true;
};

/// Types these lines to an agent with that program, or with none.
Said say(const std::vector<std::string>& lines, const std::string& program = {}) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("repl_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const std::filesystem::path file = folder / "bob.asl";
  if (!program.empty()) std::ofstream(file) << program;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Said said;
  {
    Console console;
    ReplSession session(IncludePath{}, console, nullptr);
    EXPECT_TRUE(session.load(program.empty() ? "" : file.string()));
    for (const std::string& line : lines) {
      for (const ReplInput& input : read_inputs(line)) {
        said.goes_on = said.goes_on && session.carry_out(input);
      }
    }
    said.had_mistakes = session.had_mistakes();
    EXPECT_TRUE(console.finish());
  }
  said.output = testing::internal::GetCapturedStdout();
  said.errors = testing::internal::GetCapturedStderr();
  std::filesystem::remove_all(folder);
  return said;
}

TEST(ReplSession, AnswersQueriesWithTheirBindings) {
  const Said said = say({"?- p(X) & X > 1.", "?- p(1).", "?- p(9)."}, "p(1). p(2). p(3).");
  EXPECT_EQ(said.output, "X = 2\nX = 3\ntrue\nfalse\n");
  EXPECT_FALSE(said.had_mistakes);
}

TEST(ReplSession, ShowsSeveralVariablesInOneAnswer) {
  EXPECT_EQ(say({"?- X = 1 & Y = f(X)."}).output, "X = 1, Y = f(1)\n");
}

TEST(ReplSession, AddsAndRemovesBeliefs) {
  EXPECT_EQ(say({"+p(1).", "+p(2).", "?- p(X).", "-p(1).", "?- p(X)."}).output,
            "X = 2\nX = 1\nX = 2\n");
}

TEST(ReplSession, GivesGoalsAndReasonsUntilNothingIsLeft) {
  EXPECT_EQ(say({"!count(3)."}, "+!count(0). +!count(N) <- .print(N); !count(N - 1).").output,
            "[bob] 3\n[bob] 2\n[bob] 1\n");
}

TEST(ReplSession, TakesPlansRulesAndBeliefsOfAProgram) {
  EXPECT_EQ(
      say({"double(X, Y) :- Y = 2 * X.", "+!show(X) : double(X, Y) <- .print(Y).", "!show(21)."})
          .output,
      "[agent] 42\n");
}

TEST(ReplSession, TakesSeveralClausesOfALine) {
  EXPECT_EQ(say({"+p(1). +p(2). ?- .count(p(_), N)."}).output, "N = 2\n");
}

TEST(ReplSession, ReportsMistakesAndGoesOn) {
  const Said said = say({"+p(1.", "?- p(.", "+p(2).", "?- p(X)."});
  EXPECT_TRUE(said.had_mistakes);
  EXPECT_TRUE(said.goes_on);
  EXPECT_THAT(said.errors, HasSubstr("error: "));
  EXPECT_EQ(said.output, "X = 2\n");
}

TEST(ReplSession, SuggestsNamesThatAreAlmostThere) {
  const std::string program = "price(3). +!greet <- .print(hello).";
  EXPECT_THAT(say({"?- prize(X)."}, program).errors, HasSubstr("did you mean 'price'?"));
  EXPECT_THAT(say({"!great."}, program).errors, HasSubstr("did you mean '!greet'?"));
  EXPECT_THAT(say({"?- price(4)."}, program).errors, Not(HasSubstr("did you mean")))
      << "it is there, and false";
}

TEST(ReplSession, ShowsBeliefsAllOrOfOneName) {
  const std::string program = "p(1). q(2). p(3).";
  const Said all = say({":beliefs"}, program);
  EXPECT_THAT(all.output, HasSubstr("p(1)"));
  EXPECT_THAT(all.output, HasSubstr("q(2)"));
  const Said some = say({":beliefs p"}, program);
  EXPECT_THAT(some.output, HasSubstr("p(3)"));
  EXPECT_THAT(some.output, Not(HasSubstr("q(2)")));
}

TEST(ReplSession, ShowsRulesAndPlansAsTheAgentHasThem) {
  const std::string program = "r(X) :- p(X) & X > 1. p(1). @a +!go : r(X) <- .print(X). +!stop.";
  EXPECT_THAT(say({":rules"}, program).output,
              HasSubstr("r(X)[source(self)] :- (p(X) & (X > 1))."));
  EXPECT_THAT(say({":plans"}, program).output, HasSubstr("+!stop"));
  const Said some = say({":plans go"}, program);
  EXPECT_THAT(some.output, HasSubstr("@a"));
  EXPECT_THAT(some.output, HasSubstr("+!go"));
  EXPECT_THAT(some.output, Not(HasSubstr("+!stop")));
}

TEST(ReplSession, ShowsIntentions) {
  const Said said = say({"!go.", ":intentions"}, "+!go <- .suspend; .print(never).");
  EXPECT_THAT(said.output, HasSubstr("go"));
}

TEST(ReplSession, TracesEachStepOfAGoal) {
  const Said said = say({":trace !go."}, "ready. +!go : not ready. +!go : ready <- .print(hello).");
  EXPECT_THAT(said.output, HasSubstr("+!go"));
  EXPECT_THAT(said.output, HasSubstr(".print(hello)"));
  EXPECT_THAT(said.output, HasSubstr("hello\n"));
}

TEST(ReplSession, DoesNotTraceWhatIsNotToBeTraced) {
  EXPECT_EQ(say({"!go."}, "+!go <- .print(hello).").output, "[bob] hello\n");
}

TEST(ReplSession, BeginsAnewWithTheSameFile) {
  EXPECT_EQ(say({"+p(2).", ":reload", "?- p(X)."}, "p(1).").output, "X = 1\n");
}

TEST(ReplSession, KeepsWhatThereWasWhereAFileCannotBeLoaded) {
  const Said said = say({":load /no/such/file.asl", "?- p(X)."}, "p(1).");
  EXPECT_EQ(said.output, "X = 1\n");
  EXPECT_TRUE(said.had_mistakes);
  EXPECT_THAT(said.errors, HasSubstr("/no/such/file.asl"));
}

TEST(ReplSession, NeedsAFileToLoad) {
  const Said said = say({":load"});
  EXPECT_THAT(said.errors, HasSubstr("expected a file"));
  EXPECT_TRUE(said.had_mistakes);
}

TEST(ReplSession, SuggestsCommands) {
  EXPECT_THAT(say({":belefs"}).errors,
              HasSubstr("unknown command ':belefs'\n  hint: did you mean"));
  EXPECT_THAT(say({":xyzzy"}).errors, HasSubstr("':help' names the commands"));
}

TEST(ReplSession, EndsWithQuit) {
  EXPECT_FALSE(say({":quit"}).goes_on);
  EXPECT_TRUE(say({":help"}).goes_on);
}

TEST(ReplSession, HelpNamesEveryCommand) {
  const Said said = say({":help"});
  testing::internal::CaptureStdout();
  Console console;
  ReplSession session(IncludePath{}, console, nullptr);
  (void)session.load("");
  const std::vector<std::string> commands = session.names().commands;
  (void)testing::internal::GetCapturedStdout();
  EXPECT_GE(commands.size(), 10U);
  for (const std::string& command : commands) EXPECT_THAT(said.output, HasSubstr(":" + command));
}

TEST(ReplSession, SaysThatTheAgentIsGone) {
  const Said said = say({"!die.", "?- true.", ":beliefs", ":reload", "?- p."},
                        "p. +!die <- .my_name(N); .kill_agent(N).");
  EXPECT_THAT(said.errors, HasSubstr("the agent is gone"));
  EXPECT_EQ(said.output, "true\n") << "after :reload";
}

TEST(ReplSession, SaysThatEverythingHasBeenStopped) {
  EXPECT_THAT(say({"!end."}, "+!end <- .stopMAS.").errors,
              HasSubstr("the agent has stopped everything"));
}

TEST(ReplSession, KnowsTheNamesThatCanBeCompleted) {
  testing::internal::CaptureStdout();
  Console console;
  ReplSession session(IncludePath{}, console, nullptr);
  ASSERT_TRUE(session.load(""));
  for (const ReplInput& input : read_inputs("+price(3). +!greet <- .print(1). +seen(_).")) {
    (void)session.carry_out(input);
  }
  const ReplNames names = session.names();
  (void)testing::internal::GetCapturedStdout();
  EXPECT_THAT(names.predicates, Contains("price"));
  EXPECT_THAT(names.goals, Contains("greet"));
  EXPECT_THAT(names.goals, Not(Contains("seen"))) << "that is a belief";
  EXPECT_THAT(names.goals, Not(Contains("kqml_received"))) << "not the agent's own";
  EXPECT_THAT(names.actions, testing::IsSupersetOf({".print", "math.abs"}));
}

}  // namespace
}  // namespace jaywalk
