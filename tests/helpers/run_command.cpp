// SPDX-License-Identifier: Apache-2.0
#include "tests/helpers/run_command.h"

#include <algorithm>
#include <span>

#include <gtest/gtest.h>

#include "tools/jaywalk/console/output_files.h"

namespace jaywalk::test {
namespace {

ExitCode execute(const std::vector<std::string>& words, Console& console) {
  const auto found = std::ranges::find(commands(), words.front(), &Command::name);
  if (found == commands().end()) {
    ADD_FAILURE() << "there is no command " << words.front();
    return ExitCode::internal;
  }
  std::vector<OptionSpec> options = found->help().options;
  options.insert(options.end(), common_options().begin(), common_options().end());
  const auto arguments = parse_arguments(std::span(words).subspan(1), options);
  if (!arguments) {
    console.report(arguments.diagnostics());
    return ExitCode::usage;
  }
  if (!can_write_outputs(arguments.value(), options, console)) return ExitCode::usage;
  return found->execute(arguments.value(), console);
}

}  // namespace

CommandRun run_command(const std::vector<std::string>& words) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  CommandRun run;
  {
    Console console;
    run.code = execute(words, console);
    EXPECT_TRUE(console.finish());
  }
  run.output = testing::internal::GetCapturedStdout();
  run.errors = testing::internal::GetCapturedStderr();
  return run;
}

}  // namespace jaywalk::test
