// SPDX-License-Identifier: Apache-2.0
// `jaywalk run` of an agent or a project: its limits, its exit codes, what agents may read and
// write.

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;
using testing::Not;

class RunOfAProgram : public FolderTest {
 protected:
  [[nodiscard]] CommandRun run(const std::string& program,
                               std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", file("a.asl", program), "--no-check"});
    return run_command(more);
  }
};

TEST_F(RunOfAProgram, EndsWithTheCodeThatAnAgentAsksFor) {
  EXPECT_EQ(run("!g. +!g <- .stopMAS.").code, ExitCode::success);
  EXPECT_EQ(run("!g. +!g <- .stopMAS(0, 1).").code, ExitCode::failed);
  EXPECT_EQ(run("!g. +!g <- .stopMAS(0, 0).").code, ExitCode::success);
}

TEST_F(RunOfAProgram, EndsWhereNothingIsLeftToDo) {
  const CommandRun idle = run("!g. +!g <- .print(a); .wait(3600000); .print(b).");
  EXPECT_EQ(idle.code, ExitCode::success);
  EXPECT_EQ(idle.output, "[a] a\n[a] b\n") << "an hour of virtual time costs none";
}

TEST_F(RunOfAProgram, StopsAtAnyOfItsLimits) {
  const std::string endless = "!g. +!g <- .wait(1000); !g.";
  const CommandRun cycles = run(endless, {"--max-cycles", "50"});
  EXPECT_EQ(cycles.code, ExitCode::failed);
  EXPECT_THAT(cycles.errors, HasSubstr("limit of 50 cycles"));
  const CommandRun inferences = run("p(X) :- p(X). !g. +!g <- ?p(1).", {"--max-inferences", "500"});
  EXPECT_THAT(inferences.errors, HasSubstr("500 inferences"));
}

TEST_F(RunOfAProgram, PrintsTheSameForTheSameSeed) {
  const std::string program = "!g. +!g <- .random(X); .print(X).";
  const std::string first = run(program, {"--seed", "1"}).output;
  EXPECT_THAT(first, testing::StartsWith("[a] 0."));
  EXPECT_EQ(run(program, {"--seed", "1"}).output, first);
  EXPECT_NE(run(program, {"--seed", "2"}).output, first);
}

TEST_F(RunOfAProgram, GivesAProjectTheSameOnAnyNumberOfThreads) {
  file("b.asl",
       "!g. +!g <- .my_name(N); .random(X); .print(N, X); .broadcast(tell, said(X)).\n"
       "+said(X)[source(S)] <- .my_name(N); .print(N, heard, S).");
  const std::string project = file("p.mas2j", "MAS p { agents: b #6; aslSourcePath: \".\"; }");
  const std::string one = run_command({"run", project}).output;
  EXPECT_EQ(std::ranges::count(one, '\n'), 6 + 30);
  EXPECT_EQ(run_command({"run", project, "--threads", "4"}).output, one);
}

TEST_F(RunOfAProgram, MayWriteWhereItIsAllowedAlone) {
  const std::string program = "!g. +!g <- .save_agent(\"" + path("out/s.asl") + "\").";
  std::filesystem::create_directory(path("out"));
  const CommandRun refused = run(program);
  EXPECT_FALSE(exists("out/s.asl"));
  EXPECT_THAT(refused.output + refused.errors, HasSubstr("--allow-write"));
  const CommandRun allowed = run(program, {"--allow-write", path("out")});
  EXPECT_EQ(allowed.code, ExitCode::success);
  EXPECT_TRUE(exists("out/s.asl"));
}

TEST_F(RunOfAProgram, WritesTheCoverageOfWhatRan) {
  const CommandRun done =
      run("!g. +!g <- .print(1).\n+!h <- .print(2).", {"--coverage", path("c.info")});
  EXPECT_EQ(done.code, ExitCode::success);
  EXPECT_THAT(text("c.info"), HasSubstr("SF:"));
  EXPECT_THAT(text("c.info"), HasSubstr("DA:2,0"));
  EXPECT_THAT(text("c.info"), Not(HasSubstr("DA:1,0")));
  EXPECT_EQ(run("b.", {"--coverage", path("c.doc")}).code, ExitCode::usage);
}

TEST_F(RunOfAProgram, LeavesOutWarningsWhereItIsAsked) {
  const std::string program = file("w.asl", "!g. +!g <- !other.");
  EXPECT_THAT(run_command({"run", program}).errors, HasSubstr("[unknown-goal]"));
  EXPECT_THAT(run_command({"run", program, "--no-check"}).errors, Not(HasSubstr("[unknown-goal]")));
}

/// How often a text stands in another.
std::size_t times(const std::string& text, const std::string& in) {
  std::size_t count = 0;
  for (std::size_t at = in.find(text); at != in.npos; at = in.find(text, at + 1)) ++count;
  return count;
}

TEST_F(RunOfAProgram, CountsTheSameWarningOfManyAgents) {
  file("b.asl", "!g. +!g <- nothing(here). !h. +!h <- .my_name(N); nothing(N).");
  const std::string project = file("p.mas2j", "MAS p { agents: b #20; aslSourcePath: \".\"; }");
  const std::string one = run_command({"run", project, "--no-check"}).errors;
  EXPECT_EQ(times("in nothing(here)\n", one), 6U);
  EXPECT_THAT(one, HasSubstr("warning: 15 more: " + path("b.asl") + ":1:12: no failure event"));
  EXPECT_EQ(times("in nothing(b", one), 20U) << "these are different ones";
  EXPECT_EQ(run_command({"run", project, "--no-check", "--threads", "4"}).errors, one);
  file("b.asl", "!g. +!g <- nothing(here).");
  EXPECT_EQ(times("more: ", run_command({"run", path("b.asl")}).errors), 0U);
}

TEST_F(RunOfAProgram, CountsTheSameWarningOfOneAgentInALoop) {
  const std::string errors = run("n(1). !g. +!g : n(N) & N < 100 <- !!h; -+n(N+1); !g. +!g. "
                                 "+!h <- nothing(here).")
                                 .errors;
  EXPECT_EQ(times("[a] ", errors), 6U);
  EXPECT_THAT(errors, HasSubstr("warning: 93 more: "));
}

TEST_F(RunOfAProgram, RefusesEveryOptionOfScenarios) {
  for (const char* option : {"--watch", "--metrics", "--strict"}) {
    const CommandRun refused = run("!g. +!g <- .print(1).", {option});
    EXPECT_EQ(refused.code, ExitCode::usage) << option;
    EXPECT_EQ(refused.output, "") << option;
    EXPECT_THAT(refused.errors,
                HasSubstr(std::string(option) + ": error: has no meaning for an agent"));
  }
  for (const char* option : {"--agents", "--test", "--store", "--preset", "--policy", "--speed"}) {
    EXPECT_THAT(run("b.", {option, "1"}).errors,
                HasSubstr(std::string(option) + ": error: has no meaning for an agent"));
  }
}

TEST_F(RunOfAProgram, RefusesAllThatIsWrongAtOnce) {
  const CommandRun wrong = run("b.", {"--seed", "x", "--max-ticks", "0", "--threads", "two"});
  EXPECT_EQ(wrong.code, ExitCode::usage);
  EXPECT_THAT(
      wrong.errors,
      HasSubstr(
          "--seed: error: expected a whole number from 0 to 18446744073709551615, found 'x'"));
  EXPECT_THAT(wrong.errors, HasSubstr("--max-ticks: error: expected a whole number from 1"));
  EXPECT_THAT(wrong.errors, HasSubstr("--threads: error: expected a whole number from 1"));
}

class RunOfAProject : public FolderTest {};

TEST_F(RunOfAProject, RunsTheAgentsInOrderBesideOneThatIsWrong) {
  file("good.asl", "!g. +!g <- .print(here).");
  file("bad.asl", "!g. +!g <- .print(");
  const CommandRun run =
      run_command({"run", file("p.mas2j", "MAS p { agents: good; bad; aslSourcePath: \".\"; }")});
  EXPECT_EQ(run.code, ExitCode::usage) << "a mistake stays one";
  EXPECT_EQ(run.output, "[good] here\n");
  EXPECT_THAT(run.errors, HasSubstr("bad.asl:1:"));
}

TEST_F(RunOfAProject, NamesAgentsOfOneProgramByNumbers) {
  file("w.asl", "!g. +!g <- .my_name(N); .print(N).");
  const CommandRun run =
      run_command({"run", file("p.mas2j", "MAS p { agents: w #3; aslSourcePath: \".\"; }")});
  EXPECT_EQ(run.output, "[w1] w1\n[w2] w2\n[w3] w3\n");
}

TEST_F(RunOfAProject, NeedsLeaveToDoWithoutItsJavaClasses) {
  file("a.asl", "!g. +!g <- .print(here).");
  const std::string project =
      file("p.mas2j",
           "MAS p { environment: my.Env agents: a agentClass my.Agent; aslSourcePath: \".\"; }");
  const CommandRun refused = run_command({"run", project});
  EXPECT_EQ(refused.code, ExitCode::usage);
  EXPECT_THAT(refused.errors, HasSubstr("--ignore-java"));
  EXPECT_EQ(refused.output, "");
  const CommandRun run = run_command({"run", project, "--ignore-java"});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_EQ(run.output, "[a] here\n");
}

TEST_F(RunOfAProject, PointsAtMistakesOfTheProject) {
  const CommandRun run = run_command({"run", file("p.mas2j", "MAS p {\n agents a;\n}")});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("p.mas2j:2:9: error: "));
}

}  // namespace
}  // namespace jaywalk
