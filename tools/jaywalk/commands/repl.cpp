// SPDX-License-Identifier: Apache-2.0
// `jaywalk repl`: a conversation with an agent.

#include <csignal>
#include <iostream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/repl/line_editor.h"
#include "tools/jaywalk/repl/repl_input.h"
#include "tools/jaywalk/repl/repl_session.h"

namespace jaywalk::command::repl {
namespace {

/// An input is given up when it has more text than this without an end.
constexpr std::size_t kLongestInput = std::size_t{1} << 20U;

/// False: the conversation is over.
bool carry_out(const std::vector<ReplInput>& inputs, ReplSession& session, Console& console) {
  for (const ReplInput& input : inputs) {
    const bool goes_on = session.carry_out(input);
    console.flush();
    if (!goes_on || !Console::can_print()) return false;
  }
  return true;
}

enum class Talk { explains, is_silent };

void converse(ReplSession& session, LineReader& reader, Talk talk, Console& console) {
  std::string text;  // the lines of an input that has not ended yet
  while (true) {
    const auto line = reader.read(text.empty() ? "> " : "| ");
    if (!line) break;
    if (line->cancelled) {
      text.clear();
      continue;
    }
    if (const auto command = command_alone(line->text)) {
      reader.remember(line->text);
      if (!carry_out({*command}, session, console)) return;
      continue;
    }
    text += line->text;
    if (is_whole_input(text) || text.size() > kLongestInput) {
      if (!text.empty()) reader.remember(text);
      if (!carry_out(read_inputs(std::exchange(text, {})), session, console)) return;
      continue;
    }
    text += '\n';
    if (std::exchange(talk, Talk::is_silent) == Talk::explains) {
      console.print("(an input ends with a full stop '.'; Ctrl-C drops it)\n");
      console.flush();
    }
  }
  (void)carry_out(read_inputs(text), session, console);
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "[AGENT.asl] [OPTIONS]",
      .description =
          "Asks an agent, tells it beliefs, gives it goals and plans, and shows what it\n"
          "prints: a conversation, with the agent in a file or with an empty one. ':help'\n"
          "there says what can be typed. In a terminal the Tab key completes names, and what\n"
          "was typed is kept for the next time, in $XDG_STATE_HOME/jaywalk/repl_history (by\n"
          "default below ~/.local/state). Without a terminal inputs are read to the end of\n"
          "standard input; the exit code is 2 if one of them was wrong.\n",
      .options = {},
      .examples =
          "  jaywalk repl\n"
          "  jaywalk repl agents/crossing/proximity.asl\n"
          "  echo '?- .range(X,1,3).' | jaywalk repl\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().size() > 1) {
    console.error("expected at most one file", "jaywalk repl --help shows how to write it");
    return ExitCode::usage;
  }
  const auto include_path = read_include_path(arguments, console);
  if (!include_path) return ExitCode::usage;
  const bool in_terminal = ::isatty(STDIN_FILENO) == 1 && console.output_is_terminal();
  const auto reader = in_terminal ? terminal_reader(repl_history_file()) : stream_reader(std::cin);
  ReplSession session(*include_path, console, in_terminal ? reader.get() : nullptr);
  Diagnostics wrong;
  const auto files = input_files(arguments.operands(), kPrograms, wrong);
  console.report(wrong);
  if (wrong.has_errors()) return ExitCode::usage;
  if (!session.load(files.empty() ? std::string() : files.front())) return ExitCode::usage;
  // A Ctrl-C that comes when a query has just ended must not end the conversation.
  if (in_terminal) std::signal(SIGINT, SIG_IGN);
  reader->complete_with(
      [&session](std::string_view before) { return complete_input(before, session.names()); });
  if (in_terminal) {
    console.print("':help' says what can be typed, Tab completes it; Ctrl-D ends.\n");
  }
  console.flush();
  converse(session, *reader, in_terminal ? Talk::explains : Talk::is_silent, console);
  return !in_terminal && session.had_mistakes() ? ExitCode::usage : ExitCode::success;
}

}  // namespace jaywalk::command::repl
