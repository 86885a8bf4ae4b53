// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words that a command was started with, as a line in which errors of options have their
// places.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

class CommandLine {
 public:
  /// An empty line, in which no diagnostic has a place.
  CommandLine() = default;
  /// `words`: all but the program's name; `options`: those of their command.
  CommandLine(std::span<const std::string> words, std::span<const OptionSpec> options);

  /// The diagnostics as people read them. Below the message of one about an option stands the line,
  /// and a caret under the option's value, or under the option if it has none; of a list that is
  /// the value, under the item that the message quotes.
  [[nodiscard]] std::string render(const Diagnostics& diagnostics, Colour colour) const;

 private:
  /// A word as it was given, and the byte of the line where it begins.
  struct Word {
    std::string text;
    std::size_t begin = 0;
    /// In quotes, as a shell would need it.
    bool is_quoted = false;
  };
  struct Place {
    std::size_t word = 0;
    /// Where the value begins in the word: after `--name=`.
    std::size_t from = 0;
  };

  [[nodiscard]] std::optional<SourceSpan> place_of(const Diagnostic& diagnostic) const;
  /// The place of a diagnostic's subject: `--name`, or `--name value` for an option that is given
  /// several times.
  [[nodiscard]] std::optional<Place> find(std::string_view subject) const;
  [[nodiscard]] Place place_of_option(std::size_t word, std::string_view name) const;
  [[nodiscard]] Span span_of(const Place& place, std::string_view message) const;

  std::vector<Word> words_;
  /// Words from this one on are operands: `--` stands before them.
  std::size_t operands_from_ = 0;
  std::vector<std::string> with_value_;
  SourcePtr line_;
};

}  // namespace jaywalk
