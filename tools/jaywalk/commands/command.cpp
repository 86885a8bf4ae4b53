// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/commands/command.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::string option_lines(std::span<const OptionSpec> options) {
  const auto left = [](const OptionSpec& option) {
    return fmt::format("  {}{}{}", option.name.dashed(), option.value.empty() ? "" : " ",
                       option.value);
  };
  std::size_t width = 0;
  for (const OptionSpec& option : options) width = std::max(width, left(option).size());
  std::string text;
  for (const OptionSpec& option : options) {
    text += fmt::format("{:<{}}  ", left(option), width);
    // Further lines of a summary stand below the first.
    for (const char c : option.summary) {
      text += c;
      if (c == '\n') text.append(width + 2, ' ');
    }
    text += '\n';
  }
  return text;
}

}  // namespace

namespace {

// A command whose name C++ has taken, as a keyword or a library, has an underscore behind it.
constexpr std::string_view word(std::string_view name) {
  return name.ends_with('_') ? name.substr(0, name.size() - 1) : name;
}

}  // namespace

std::span<const Command> commands() {
  static constexpr std::array kCommands = {
#define JAYWALK_COMMAND(name, summary) \
  Command{word(#name), summary, &command::name::help, &command::name::execute},
#include "tools/jaywalk/commands/commands.def"
#undef JAYWALK_COMMAND
  };
  return kCommands;
}

std::string help_text(const Command& command) {
  CommandHelp help = command.help();
  std::ranges::copy(common_options(), std::back_inserter(help.options));
  return fmt::format("Usage: jaywalk {} {}\n\n{}\nOptions:\n{}\nExamples:\n{}", command.name,
                     help.usage, help.description, option_lines(help.options), help.examples);
}

}  // namespace jaywalk
