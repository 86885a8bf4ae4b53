// SPDX-License-Identifier: Apache-2.0
#pragma once

// Carries out a case in this process, which may not survive it. Read target.h first.

#include <span>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace jaywalk::fuzz {

/// What absolute paths in hostile names begin with: no file may be made there.
inline constexpr std::string_view kOutside = "/tmp/jaywalk-fuzz-outside";

/// Writes the files and runs agents and commands in `folder`, which is emptied before. Standard
/// output and error are those of the process. What is wrong with how they ended: an exception, or
/// an exit code that is none of the documented ones, a file that the commands should not have made;
/// empty if nothing is.
[[nodiscard]] std::string run_case(const Case& made, const std::string& folder);

/// One `jaywalk` command in this process; its exit code. What it throws is not caught.
int run_command(std::span<const std::string> words);

/// Writes the files, the standard input and a script `repeat` with the commands into `folder`.
void write_case(const Case& made, const std::string& folder);

}  // namespace jaywalk::fuzz
