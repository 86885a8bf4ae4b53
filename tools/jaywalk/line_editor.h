#pragma once

// Lines that a person types, or that come through a pipe.

#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace jaywalk {

class LineReader {
 public:
  virtual ~LineReader() = default;
  struct Line {
    std::string text;
    /// Ctrl-C was pressed while it was being typed: what it belongs to is given up.
    bool cancelled = false;
  };
  /// The next line without its line break; nothing at the end (Ctrl-D).
  [[nodiscard]] virtual std::optional<Line> read(const std::string& prompt) = 0;
  /// Makes a whole input available to the arrow keys.
  virtual void remember(const std::string& input) = 0;
};

/// From a terminal, with editing and history (libedit).
[[nodiscard]] std::unique_ptr<LineReader> terminal_reader();
/// From anything else; there are no prompts then.
[[nodiscard]] std::unique_ptr<LineReader> stream_reader(std::istream& stream);

}  // namespace jaywalk
