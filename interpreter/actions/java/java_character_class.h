#pragma once

// Sets of characters as Java's regular expressions name them: `[a-z_]`, `\d`, `\p{Upper}`.

#include <optional>
#include <string_view>
#include <vector>

namespace jaywalk::actions {

[[nodiscard]] constexpr bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }
/// Letters, digits and `_` of ASCII, as `\w` and `\b` mean it.
[[nodiscard]] constexpr bool is_word(char32_t c) {
  return is_digit(c) || (c >= 'A' && c <= 'Z') || c == '_' || (c >= 'a' && c <= 'z');
}

struct CharacterClass {
  struct Range {
    char32_t first;
    char32_t last;
  };
  std::vector<Range> ranges;
  bool negated = false;
  bool fold_case = false;

  [[nodiscard]] bool contains(char32_t character) const;
  /// The characters of another class, whose ranges are in order, too.
  void add(const CharacterClass& other);
};

/// `d`, `w`, `s` and their complements `D`, `W`, `S`; nothing for other names.
[[nodiscard]] std::optional<CharacterClass> predefined_class(char name);
/// The class for the name in the braces of `\p{…}`; nothing for an unknown name.
[[nodiscard]] std::optional<CharacterClass> class_of_property(std::string_view name);

}  // namespace jaywalk::actions
