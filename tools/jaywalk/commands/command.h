// SPDX-License-Identifier: Apache-2.0
#pragma once

// A subcommand: the texts of its --help and the function that executes it. commands.def has a row
// for each.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

struct CommandHelp {
  /// The text after the command's name: "FILE [OPTIONS]".
  std::string_view usage;
  /// Paragraphs of whole lines, at most 80 columns wide.
  std::string_view description;
  std::vector<OptionSpec> options;
  /// Lines that can be run as they are.
  std::string_view examples;
};

struct Command {
  std::string_view name;
  std::string_view summary;
  CommandHelp (*help)();
  ExitCode (*execute)(const Arguments& arguments, Console& console);
};

[[nodiscard]] std::span<const Command> commands();

/// The text of `jaywalk NAME --help`.
[[nodiscard]] std::string help_text(const Command& command);

namespace command {
#define JAYWALK_COMMAND(name, summary)                            \
  namespace name {                                                \
  CommandHelp help();                                             \
  ExitCode execute(const Arguments& arguments, Console& console); \
  }
#include "tools/jaywalk/commands/commands.def"
#undef JAYWALK_COMMAND
}  // namespace command

}  // namespace jaywalk
