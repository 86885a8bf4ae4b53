// SPDX-License-Identifier: Apache-2.0
// The subcommand that docs/internals/add_subcommand.md adds works as the page says.

#include "tools/jaywalk/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;

class CommandTutorial : public FolderTest {};

TEST_F(CommandTutorial, HasACommandThatCounts) {
  // A program of two plans.
  const std::string path = file("two.asl", "b(1).\n!go.\n+!go <- +b(2).\n+b(X) <- .print(X).\n");
  EXPECT_EQ(run_command({"plans", path, path}).output, "2 " + path + "\n2 " + path + "\n");
  const CommandRun total = run_command({"plans", "--total", path, path});
  EXPECT_EQ(total.output, "4\n");
  EXPECT_EQ(total.code, ExitCode::success);
}

TEST_F(CommandTutorial, HasACommandThatSaysWhatIsWrong) {
  const CommandRun outcome = run_command({"plans", "--total", "no_such.asl"});
  EXPECT_EQ(outcome.code, ExitCode::usage);
  EXPECT_THAT(outcome.errors, HasSubstr("no_such.asl"));
  EXPECT_EQ(outcome.output, "");
}

TEST_F(CommandTutorial, LeavesTheOtherCommandsWhereTheyAre) {
  EXPECT_EQ(commands().front().name, "run");
  EXPECT_EQ(commands().back().name, "plans");
}

}  // namespace
}  // namespace jaywalk
