// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texts by characters of UTF-8 and by lines.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// Whether a character begins with the byte; otherwise it goes on with it.
[[nodiscard]] inline bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

[[nodiscard]] inline std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

/// The first byte that is not valid UTF-8 (RFC 3629); nothing if all are.
[[nodiscard]] std::optional<std::size_t> first_bad_byte(std::string_view text);

inline constexpr std::string_view kBlanks = " \t\r\n";

/// Without blanks at its begin and end.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return text.substr(0, 0);
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// At most `most` bytes of the text, in whole characters, and "..." if that is not all.
[[nodiscard]] inline std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  while (most > 0 && !begins_character(text[most])) --most;
  return std::string(text.substr(0, most)) + "...";
}

/// "1 agent", "2 agents"
[[nodiscard]] inline std::string counted(std::uint64_t count, std::string_view noun) {
  return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

/// Without their line breaks; a break at the end begins no further line.
[[nodiscard]] inline std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

// The characters of names and numbers in programs and projects; ASCII, whatever the locale.
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
