// SPDX-License-Identifier: Apache-2.0
// What holds for every command: its help can be read, and wrong words end it before it does
// anything.

#include <algorithm>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using test::CommandRun;
using test::run_command;
using testing::HasSubstr;

class EveryCommand : public testing::TestWithParam<Command> {};

TEST_P(EveryCommand, HasAHelpOfAtMostAHundredColumns) {
  std::istringstream lines(help_text(GetParam()));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST_P(EveryCommand, ShowsExamplesOfItself) {
  std::istringstream lines{std::string(GetParam().help().examples)};
  const std::string begin = "  jaywalk " + std::string(GetParam().name);
  bool has_own = false;
  for (std::string line; std::getline(lines, line);) has_own |= line.starts_with(begin);
  EXPECT_TRUE(has_own);
}

TEST_P(EveryCommand, DeclaresEachOptionOnceAndSaysWhatItIsFor) {
  std::vector<OptionSpec> options = GetParam().help().options;
  options.insert(options.end(), common_options().begin(), common_options().end());
  std::set<std::string_view> names;
  for (const OptionSpec& option : options) {
    EXPECT_TRUE(names.insert(option.name.text()).second) << option.name.text();
    EXPECT_FALSE(option.summary.empty()) << option.name.text();
    EXPECT_TRUE(option.written == Written::no || !option.value.empty()) << option.name.text();
  }
}

TEST_P(EveryCommand, RefusesAnOptionThatItDoesNotHave) {
  const CommandRun run = run_command({std::string(GetParam().name), "--colour-of-the-sky"});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.errors, HasSubstr("--colour-of-the-sky: error: unknown option"));
}

TEST_P(EveryCommand, SuggestsTheOptionThatWasMeant) {
  const CommandRun run = run_command({std::string(GetParam().name), "--log-levl=info"});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors,
              HasSubstr("--log-levl: error: unknown option\n  hint: did you mean '--log-level'?"));
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryCommand, testing::ValuesIn(commands()),
                         [](const auto& command) { return std::string(command.param.name); });

class EveryReader : public testing::TestWithParam<Command> {};

/// The commands that read files which their operands name.
std::vector<Command> readers() {
  std::vector<Command> all(commands().begin(), commands().end());
  std::erase_if(all, [](const Command& each) { return each.name == "list" || each.name == "lsp"; });
  return all;
}

TEST_P(EveryReader, RefusesFilesThatAreNotThere) {
  const CommandRun run = run_command({std::string(GetParam().name), "no/such.file"});
  EXPECT_EQ(run.code, ExitCode::usage);
  EXPECT_THAT(run.errors, HasSubstr("error: "));
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryReader, testing::ValuesIn(readers()),
                         [](const auto& command) { return std::string(command.param.name); });

}  // namespace
}  // namespace jaywalk
