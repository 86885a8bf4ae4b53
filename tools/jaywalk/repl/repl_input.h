// SPDX-License-Identifier: Apache-2.0
#pragma once

// An input at the prompt of `jaywalk repl`: a command `:word argument`, a query `?- formula.`, or a
// clause of AgentSpeak, over any number of lines.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

struct ReplInput {
  enum class Kind {
    nothing,  // blanks and comments
    command,  // word: "load"; text: its argument
    query,    // text: the formula
    add,      // `+b(1).`: text is the literal, as in those that follow
    remove,   // `-b(1).`
    goal,     // `!g.`
    program,  // beliefs, rules, plans, directives: text is all of it
  };
  Kind kind = Kind::nothing;
  std::string word;
  std::string text;
};

/// The words of commands, without the colon.
[[nodiscard]] const std::vector<std::string>& repl_commands();

/// The command that a line consists of, `:quit`, or one of the words `help`, `quit` and `exit`. It
/// is no part of an input that has begun before.
[[nodiscard]] std::optional<ReplInput> command_alone(std::string_view line);

/// Whether the lines so far are a whole input: a command, nothing, or up to a full stop outside of
/// brackets. A text that no further line can make valid is whole, too: it is an error.
[[nodiscard]] bool is_whole_input(std::string_view text);

/// The parts of a whole input: each clause is read as it would be alone, also if several stand on a
/// line. Kinds of clauses are distinguished by parsing. A text that does not parse counts as a
/// program, so that loading it reports its errors.
[[nodiscard]] std::vector<ReplInput> read_inputs(const std::string& text);

// Completion at the prompt of `jaywalk repl`: commands after a colon, goals after an exclamation
// mark, internal actions after a full stop, elsewhere beliefs, goals and functions.

/// The names that an agent knows.
struct ReplNames {
  std::vector<std::string> commands;    // without the colon
  std::vector<std::string> predicates;  // of beliefs and rules
  std::vector<std::string> goals;       // that there are plans for
  std::vector<std::string> actions;     // internal ones and functions, `.print`, `math.max`
};

struct Completion {
  /// The letters before the cursor that a candidate replaces.
  std::size_t replaced = 0;
  /// Sorted, without duplicates.
  std::vector<std::string> candidates;
  /// The longest common beginning of all candidates.
  [[nodiscard]] std::string common() const;
};

/// `before` is the line up to the cursor.
[[nodiscard]] Completion complete_input(std::string_view before, const ReplNames& names);

}  // namespace jaywalk
