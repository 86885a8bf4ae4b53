#pragma once

// Regular expressions in Java's syntax, without what takes more than linear time: no references to
// groups within the pattern and no looking around. Matching is a simulation of all threads at once
// (Pike's, see Russ Cox, "Regular Expression Matching: the Virtual Machine Approach", 2009), so no
// pattern is catastrophic, and a long text needs no deep stack. Works on UTF-8, by characters.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/actions/java/java_character_class.h"

namespace jaywalk::actions {

class Regex {
 public:
  /// Nothing if the pattern is not one; `error` then says why.
  [[nodiscard]] static std::optional<Regex> parse(std::string_view pattern, std::string& error);

  /// The begin and end of a match and its groups, in bytes: [2*i] and [2*i+1]; kNone: group i did
  /// not take part. Empty: no match.
  using Groups = std::vector<std::size_t>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// The first match at or after a byte.
  [[nodiscard]] Groups find(std::string_view text, std::size_t from) const;
  /// The whole text matches.
  [[nodiscard]] bool matches(std::string_view text) const;
  /// Java's replaceAll: `$1` in the replacement is a group, `\` quotes. Nothing if the replacement
  /// is wrong or the result too long.
  [[nodiscard]] std::optional<std::string> replace_all(std::string_view text,
                                                       std::string_view replacement,
                                                       std::string& error) const;

  /// Sets a function that is called now and then during a search; an exception from it ends the
  /// search.
  void watch(std::function<void()> look) { look_ = std::move(look); }

 private:
  friend class RegexParser;
  friend class RegexRun;

  struct Instruction {
    enum class Kind : std::uint8_t {
      one_of,      // a character of class x
      any,         // any character but an end of line
      split,       // go on at x, or else at y
      jump,        // go on at x
      save,        // remember the position in slot x
      line_begin,  // ^
      line_end,    // $
      word_edge,   // \b; x is 1 for \B
      match,
    };
    Kind kind;
    std::uint32_t x = 0;
    std::uint32_t y = 0;
  };

  Regex() = default;

  std::vector<Instruction> program_;
  std::vector<CharacterClass> classes_;
  std::size_t groups_ = 1;
  std::function<void()> look_;
};

}  // namespace jaywalk::actions
