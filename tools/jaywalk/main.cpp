// SPDX-License-Identifier: Apache-2.0
// The command `jaywalk`: finds the subcommand, reads its arguments, carries it out.

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <new>
#include <span>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

std::string overview() {
  std::string text =
      "Usage: jaywalk COMMAND [ARGUMENTS] [OPTIONS]\n\n"
      "Runs AgentSpeak agents, and tests automated vehicles with pedestrians that are\n"
      "such agents.\n\nCommands:\n";
  for (const Command& command : commands()) {
    text += fmt::format("  {:<9} {}\n", command.name, command.summary);
  }
  text +=
      "\n'jaywalk help COMMAND' explains a command; 'jaywalk --version' names the version.\n\n"
      "Examples:\n"
      "  jaywalk run hello.asl\n"
      "  jaywalk run scenarios/paper.yaml --watch\n"
      "  jaywalk compare scenarios/paper.yaml --tests 200\n";
  return text;
}

const Command* find_command(std::string_view name) {
  for (const Command& command : commands()) {
    if (command.name == name) return &command;
  }
  return nullptr;
}

ExitCode wrong_command(const std::string& word, Console& console) {
  const bool option = word.starts_with('-');
  std::vector<std::string> known = {option::kHelp.dashed(), "--version"};
  if (!option) {
    known.clear();
    for (const Command& command : commands()) known.emplace_back(command.name);
  }
  std::string hint = did_you_mean(word, known);
  if (hint.empty()) {
    hint = option ? "a command's options follow its name" : "'jaywalk --help' names the commands";
  }
  console.error(fmt::format("unknown {} '{}'", option ? "option" : "command", word), hint);
  return ExitCode::usage;
}

ExitCode execute(const Command& command, const Arguments& arguments, const CommandLine& line,
                 std::span<const OptionSpec> options) {
  static const std::vector<std::string> kColours = {"auto", "always", "never"};
  static const std::vector<std::string> kLevels = {"warning", "error", "info", "debug"};
  constexpr std::array kLevelValues = {LogLevel::warning, LogLevel::error, LogLevel::info,
                                       LogLevel::debug};
  Diagnostics diagnostics;
  const auto colour = arguments.choice(option::kColor, kColours, diagnostics);
  const auto level = arguments.choice(option::kLogLevel, kLevels, diagnostics);
  Console console(static_cast<ColourChoice>(colour));
  console.set_log_level(kLevelValues[level]);
  console.set_command_line(line);
  ExitCode code = ExitCode::usage;
  if (arguments.has(option::kHelp)) {
    console.print(help_text(command));
    code = ExitCode::success;
  } else if (diagnostics.has_errors()) {
    console.report(diagnostics);
  } else if (can_write_outputs(arguments, options, console)) {
    code = command.execute(arguments, console);
    if (!arguments.has(option::kQuiet)) console.tell_written();
  }
  if (!console.finish() && code == ExitCode::success) code = ExitCode::failed;
  return code;
}

/// `-h` as people type it.
std::vector<std::string> with_long_help(std::span<const std::string> words) {
  std::vector<std::string> result(words.begin(), words.end());
  const auto end = std::ranges::find(result, "--");
  std::replace(result.begin(), end, std::string("-h"), option::kHelp.dashed());
  return result;
}

ExitCode dispatch(std::span<const std::string> words) {
  Console console;
  if (words.empty()) {
    console.error("a command is missing", "'jaywalk --help' names the commands");
    return ExitCode::usage;
  }
  const std::string& first = words.front();
  if (first == "help" && words.size() > 1 && !words[1].starts_with('-')) {
    const std::array asked = {words[1], option::kHelp.dashed()};
    return dispatch(asked);
  }
  if (first == option::kHelp.dashed() || first == "-h" || first == "help") {
    console.print(overview());
    return console.finish() ? ExitCode::success : ExitCode::failed;
  }
  if (first == "--version" || first == "-V") {
    console.print(fmt::format("jaywalk {}\n", JAYWALK_VERSION));
    return console.finish() ? ExitCode::success : ExitCode::failed;
  }
  const Command* const command = find_command(first);
  if (command == nullptr) return wrong_command(first, console);

  std::vector<OptionSpec> options = command->help().options;
  options.insert(options.end(), common_options().begin(), common_options().end());
  const CommandLine line(words, options);
  const auto arguments = parse_arguments(with_long_help(words.subspan(1)), options);
  if (!arguments) {
    console.set_command_line(line);
    console.report(arguments.diagnostics());
    return ExitCode::usage;
  }
  return execute(*command, arguments.value(), line, options);
}

/// A program that was started without standard streams must not take the files that it opens for
/// them. What is written to such a stream fails.
void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the system has no other interface
    if (::fcntl(stream, F_GETFD) == -1) (void)::open("/dev/null", O_RDONLY | O_CLOEXEC);
  }
}

/// fmt::print() would throw if standard error is full or closed.
void report_internal(const std::exception& error) {
  const std::string text =
      fmt::format("internal error: {}\n  please report it with the command\n", error.what());
  std::fputs(text.c_str(), stderr);
}

}  // namespace
}  // namespace jaywalk

int main(int argc, char** argv) {
  // A reader that has seen enough (`| head`) ends us without a word.
  std::signal(SIGPIPE, SIG_DFL);
  // A file that grows beyond the limit of sizes (`ulimit -f`) is one that cannot be written.
  std::signal(SIGXFSZ, SIG_IGN);
  jaywalk::reserve_standard_streams();
  try {
    const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    return static_cast<int>(jaywalk::dispatch(words));
  } catch (const std::bad_alloc&) {
    std::fputs("error: out of memory\n", stderr);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) {
      std::fputs("error: no thread can be started: the system has none left\n", stderr);
      return static_cast<int>(jaywalk::ExitCode::failed);
    }
    jaywalk::report_internal(error);
  } catch (const std::exception& error) {
    jaywalk::report_internal(error);
  }
  return static_cast<int>(jaywalk::ExitCode::internal);
}
