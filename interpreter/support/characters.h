// The characters of names and numbers in programs and projects; ASCII, whatever the locale.
#pragma once

namespace jaywalk {

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
[[nodiscard]] constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] constexpr bool is_letter(char c) { return is_lower(c) || is_upper(c); }
/// Whether `c` may stand in a name behind its first character.
[[nodiscard]] constexpr bool is_name_character(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

}  // namespace jaywalk
