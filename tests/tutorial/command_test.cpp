// The subcommand that tools/jaywalk/commands/TUTORIAL.md adds works as the page says.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/commands/command.h"

namespace jaywalk {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const std::string kProgram = JAYWALK_SOURCE_DIR "/agents/tutorial/t01_hello.asl";

struct Outcome {
  ExitCode code = ExitCode::success;
  std::string output;
  std::string errors;
};

Outcome run(const std::vector<std::string>& words) {
  const auto found = std::ranges::find(commands(), "plans", &Command::name);
  const auto arguments = parse_arguments(words, found->help().options);
  EXPECT_TRUE(arguments);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  {
    Console console;
    outcome.code = found->execute(arguments.value(), console);
    EXPECT_TRUE(console.finish());
  }
  outcome.output = testing::internal::GetCapturedStdout();
  outcome.errors = testing::internal::GetCapturedStderr();
  return outcome;
}

TEST(CommandTutorial, HasACommandThatCounts) {
  const Outcome each = run({kProgram, kProgram});
  EXPECT_EQ(each.code, ExitCode::success);
  EXPECT_THAT(each.output, EndsWith("t01_hello.asl\n"));
  EXPECT_NE(run({"--total", kProgram, kProgram}).output, "0\n");
}

TEST(CommandTutorial, HasACommandThatSaysWhatIsWrong) {
  const Outcome outcome = run({"--total", "no_such.asl"});
  EXPECT_EQ(outcome.code, ExitCode::usage);
  EXPECT_THAT(outcome.errors, HasSubstr("no_such.asl"));
  EXPECT_EQ(outcome.output, "");
}

TEST(CommandTutorial, LeavesTheOtherCommandsWhereTheyAre) {
  EXPECT_EQ(commands().front().name, "run");
  EXPECT_EQ(commands().back().name, "plans");
}

}  // namespace
}  // namespace jaywalk
