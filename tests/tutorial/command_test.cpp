// The subcommand that tools/jaywalk/commands/TUTORIAL.md adds works as the page says.

#include "tools/jaywalk/commands/command.h"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

/// A program of two plans.
std::string program() {
  std::string path = testing::TempDir() + "command_tutorial.asl";
  std::ofstream(path) << "b(1).\n!go.\n+!go <- +b(2).\n+b(X) <- .print(X).\n";
  return path;
}

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
  const std::string path = program();
  EXPECT_EQ(run({path, path}).output, "2 " + path + "\n2 " + path + "\n");
  const Outcome total = run({"--total", path, path});
  EXPECT_EQ(total.output, "4\n");
  EXPECT_EQ(total.code, ExitCode::success);
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
