// The characters of names and numbers in programs and projects; ASCII, whatever the locale.
#pragma once

#include <array>
#include <cstddef>

namespace jaywalk {

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
[[nodiscard]] constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] constexpr bool is_letter(char c) { return is_lower(c) || is_upper(c); }

inline constexpr auto kNameCharacters = [] {
  std::array<bool, 256> are{};
  for (std::size_t i = 0; i < 128; ++i) {
    const char each = static_cast<char>(i);
    are[i] = is_letter(each) || is_digit(each) || each == '_';
  }
  return are;
}();

/// Whether `c` may stand in a name behind its first character.
[[nodiscard]] constexpr bool is_name_character(char c) {
  return kNameCharacters[static_cast<unsigned char>(c)];
}

}  // namespace jaywalk
