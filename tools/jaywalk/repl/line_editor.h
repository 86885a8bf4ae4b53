// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lines that a person types, or that come through a pipe.

#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "tools/jaywalk/repl/repl_input.h"

namespace jaywalk {

class LineReader {
 public:
  virtual ~LineReader() = default;
  struct Line {
    std::string text;
    /// Whether Ctrl-C was pressed while it was being typed: its whole input is discarded.
    bool cancelled = false;
  };
  /// The next line without its line break; nothing at the end (Ctrl-D).
  [[nodiscard]] virtual std::optional<Line> read(const std::string& prompt) = 0;
  /// Makes a whole input available to the arrow keys.
  virtual void remember(const std::string& input) = 0;
  /// Sets the completion that the Tab key uses; it receives the line up to the cursor.
  virtual void complete_with(std::function<Completion(std::string_view before)> complete) = 0;
};

/// From a terminal, with editing and history (libedit). The history begins with what is in the
/// file, if one is given, and is kept there.
[[nodiscard]] std::unique_ptr<LineReader> terminal_reader(
    const std::optional<std::filesystem::path>& history_file);
/// From anything else; there are no prompts then.
[[nodiscard]] std::unique_ptr<LineReader> stream_reader(std::istream& stream);

/// The file in which `jaywalk repl` keeps its inputs from one session to the next:
/// `$XDG_STATE_HOME/jaywalk/repl_history`, by default below `~/.local/state`; its folder is made.
/// Nothing if there is no place to keep it.
[[nodiscard]] std::optional<std::filesystem::path> repl_history_file();

}  // namespace jaywalk
