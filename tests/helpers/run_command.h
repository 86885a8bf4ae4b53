// SPDX-License-Identifier: Apache-2.0
#pragma once

// The subcommands of `jaywalk` in this process.

#include <string>
#include <vector>

#include "tools/jaywalk/commands/command.h"

namespace jaywalk::test {

/// How a command ended, and what it wrote to standard output and standard error.
struct CommandRun {
  ExitCode code = ExitCode::internal;
  std::string output;
  std::string errors;
};

/// Runs a subcommand with its arguments: the name is the first word. Words that cannot be parsed
/// end it as they end the program: with the exit code `usage`, and why on standard error.
[[nodiscard]] CommandRun run_command(const std::vector<std::string>& words);

}  // namespace jaywalk::test
