// `jaywalk repl`: a conversation with an agent.

#include <csignal>
#include <iostream>
#include <optional>
#include <string>
#include <unistd.h>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/shipped.h"
#include "tools/jaywalk/repl/line_editor.h"
#include "tools/jaywalk/repl/repl_completion.h"
#include "tools/jaywalk/repl/repl_history.h"
#include "tools/jaywalk/repl/repl_session.h"

namespace jaywalk::command::repl {
namespace {

/// An input is given up when it has more text than this without an end.
constexpr std::size_t kLongestInput = std::size_t{1} << 20U;

/// The lines of one input; nothing at the end.
std::optional<std::string> read_whole(LineReader& reader) {
  std::string text;
  while (true) {
    const auto line = reader.read(text.empty() ? "> " : "| ");
    if (!line) return text.empty() ? std::nullopt : std::optional(text);
    if (line->cancelled) return std::string();
    text += line->text;
    if (is_whole_input(text) || text.size() > kLongestInput) return text;
    text += '\n';
  }
}

void converse(ReplSession& session, LineReader& reader, Console& console) {
  while (const auto text = read_whole(reader)) {
    if (!text->empty()) reader.remember(*text);
    for (const ReplInput& input : read_inputs(*text)) {
      const bool goes_on = session.carry_out(input);
      console.flush();
      if (!goes_on || !Console::can_print()) return;
    }
  }
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
  const std::string path =
      arguments.operands().empty() ? std::string() : located(arguments.operands().front());
  if (!session.load(path)) return ExitCode::usage;
  // A Ctrl-C that comes when a query has just ended must not end the conversation.
  if (in_terminal) std::signal(SIGINT, SIG_IGN);
  reader->complete_with(
      [&session](std::string_view before) { return complete_input(before, session.names()); });
  if (in_terminal) {
    console.print("':help' says what can be typed, Tab completes it; Ctrl-D ends.\n");
  }
  console.flush();
  converse(session, *reader, console);
  return !in_terminal && session.had_mistakes() ? ExitCode::usage : ExitCode::success;
}

}  // namespace jaywalk::command::repl
