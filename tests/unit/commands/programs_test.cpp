// SPDX-License-Identifier: Apache-2.0
// Commands about programs: check, fmt, run, test.

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

class CheckCommand : public FolderTest {};

TEST_F(CheckCommand, CountsWhatItFoundInAllFiles) {
  file("a.asl", "!go. +!go <- .print(1).");
  file("deep/b.asl", "!go. +!og <- .print(1).");
  file("deep/notes.txt", "not a program");
  const CommandRun run = run_command({"check", path("")});
  EXPECT_EQ(run.code, ExitCode::success) << "warnings alone are no failure";
  EXPECT_THAT(run.output, HasSubstr("2 files checked: 0 errors, "));
  EXPECT_THAT(run.errors, HasSubstr("deep/b.asl:1:2: warning: "));
  EXPECT_EQ(run_command({"check", path(""), "--werror"}).code, ExitCode::usage);
}

TEST_F(CheckCommand, GoesOnAfterAFileThatItCannotCheck) {
  const std::string wrong = file("a.asl", "b(1.\nc(.\n");
  const CommandRun run =
      run_command({"check", path("none.asl"), file("a.txt", ""), wrong, file("b.asl", "b.")});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("none.asl"));
  EXPECT_THAT(run.errors,
              HasSubstr("expected a file .asl, .mas2j or .yaml, found '" + path("a.txt")));
  EXPECT_THAT(run.errors, HasSubstr("a.asl:1:4: error: "));
  EXPECT_THAT(run.errors, HasSubstr("a.asl:2:3: error: "));
}

TEST_F(CheckCommand, ChecksAProgramOnceHoweverOftenItIsNamed) {
  const std::string wrong = file("a.asl", "b(1.\n");
  EXPECT_THAT(run_command({"check", wrong, wrong, path("./a.asl")}).output, HasSubstr("1 error,"));
}

TEST_F(CheckCommand, ChecksTheProgramsOfAProjectTogether) {
  file("a.asl", "!go. +!go <- .send(b, achieve, hello).");
  file("b.asl", "+!hello.");
  const CommandRun run =
      run_command({"check", file("p.mas2j", "MAS p { agents: a; b; aslSourcePath: \".\"; }")});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_EQ(run.errors, "");
}

class FmtCommand : public FolderTest {};

TEST_F(FmtCommand, LaysOutFilesInPlaceAndNamesThoseThatChanged) {
  const std::string wrong = file("a.asl", "b( 1 ).\n");
  file("b.asl", "b(1).\n");
  const CommandRun run = run_command({"fmt", path("")});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_EQ(run.output, wrong + "\n");
  EXPECT_EQ(text("a.asl"), "b(1).\n");
  EXPECT_EQ(run_command({"fmt", path("")}).output, "") << "once is enough";
}

TEST_F(FmtCommand, NamesWhatWouldChangeAndWritesNothing) {
  const std::string wrong = file("a.asl", "b( 1 ).\n");
  const CommandRun check = run_command({"fmt", "--check", wrong});
  EXPECT_EQ(check.code, ExitCode::failed);
  EXPECT_EQ(check.output, wrong + "\n");
  EXPECT_EQ(text("a.asl"), "b( 1 ).\n");
}

TEST_F(FmtCommand, LeavesAFileWithMistakesAsItIs) {
  const std::string wrong = file("a.asl", "b( 1 .\n");
  const CommandRun run = run_command({"fmt", wrong});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("a.asl:1:6: error: "));
  EXPECT_EQ(text("a.asl"), "b( 1 .\n");
  EXPECT_EQ(run_command({"fmt", file("a.txt", "")}).code, ExitCode::usage);
}

class RunCommand : public FolderTest {};

TEST_F(RunCommand, PrintsWhatTheAgentPrints) {
  const CommandRun run = run_command({"run", file("hello.asl", "!g. +!g <- .print(\"hello\").")});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_EQ(run.output, "[hello] hello\n");
  EXPECT_EQ(run.errors, "");
}

TEST_F(RunCommand, FailsAtALimitAndSaysWhich) {
  const std::string endless = file("endless.asl", "!g. +!g <- !g.");
  const CommandRun run = run_command({"run", endless, "--max-cycles", "100"});
  EXPECT_EQ(run.code, ExitCode::failed);
  EXPECT_THAT(run.errors, HasSubstr("100 cycles"));
}

TEST_F(RunCommand, RunsNothingOfAProgramWithMistakes) {
  const CommandRun run = run_command({"run", file("a.asl", "!g. +!g <- .print(1). b(.")});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.errors, HasSubstr("a.asl:1:25: error: "));
}

TEST_F(RunCommand, RefusesOptionsThatTheKindOfFileDoesNotHave) {
  const std::string program = file("a.asl", "!g. +!g <- .print(1).");
  const CommandRun run = run_command({"run", program, "--behaviour", "proximity"});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.errors, HasSubstr("--behaviour: error: has no meaning for"));
  EXPECT_THAT(run_command({"run", file("a.txt", "")}).errors,
              HasSubstr("expected a file .asl, .mas2j or .yaml"));
  EXPECT_THAT(run_command({"run", program, program}).errors,
              HasSubstr("expected one file, found 2"));
}

class TestCommand : public FolderTest {};

constexpr const char* kTests =
    "{ include(\"test_assert.asl\") }\n"
    "@[test] +!good <- !assert_equals(2, 1 + 1).\n"
    "@[test] +!bad <- .print(seen); !assert_equals(3, 1 + 1).\n"
    "@[test] +!empty.\n";

TEST_F(TestCommand, SaysHowEachTestEnded) {
  const CommandRun run = run_command({"test", file("t.asl", kTests), "--threads", "2"});
  EXPECT_EQ(run.code, ExitCode::failed);
  EXPECT_THAT(run.output, HasSubstr("ok   " + path("t.asl") + ": good (1 assertion)\n"));
  EXPECT_THAT(run.output, HasSubstr("FAIL " + path("t.asl") + ": bad (1 assertion)\n"));
  EXPECT_THAT(run.output, HasSubstr("??   " + path("t.asl") + ": empty (asserts nothing)\n"));
  EXPECT_THAT(run.output, HasSubstr("seen")) << "what a failed test printed";
  EXPECT_THAT(run.output, HasSubstr("1 passed, 1 failed, 1 without assertions\n"));
}

TEST_F(TestCommand, RunsTheTestsThatAFilterLeaves) {
  const CommandRun run = run_command({"test", file("t.asl", kTests), "--filter", "good"});
  EXPECT_EQ(run.code, ExitCode::success);
  EXPECT_THAT(run.output, Not(HasSubstr("bad")));
  EXPECT_EQ(run_command({"test", path("t.asl"), "--filter", "nowhere"}).code, ExitCode::usage);
}

TEST_F(TestCommand, WritesItsResultsForOtherPrograms) {
  (void)run_command(
      {"test", file("t.asl", kTests), "--junit", path("r.xml"), "--coverage", path("c.info")});
  EXPECT_THAT(text("r.xml"), HasSubstr("<testcase "));
  EXPECT_THAT(text("r.xml"), HasSubstr("<failure "));
  EXPECT_THAT(text("c.info"), HasSubstr("SF:"));
}

TEST_F(TestCommand, ExpectsTestsOfAFileThatIsNamed) {
  const CommandRun run = run_command({"test", file("a.asl", "+!g.")});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("a.asl: error: has no tests"));
}

}  // namespace
}  // namespace jaywalk
