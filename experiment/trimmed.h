#pragma once

// Blanks around what people write on a command line.

#include <string_view>

namespace jaywalk {

inline constexpr std::string_view kBlanks = " \t\r\n";

[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace jaywalk
