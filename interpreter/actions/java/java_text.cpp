// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/java/java_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace jaywalk::actions {
namespace {

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

std::size_t units_of(char32_t character) { return character > 0xFFFF ? 2 : 1; }

// Letters whose capital stands 32 places before: Latin-1, Greek, Cyrillic.
bool is_shifted_small(char32_t c) {
  return (c >= 0xE0 && c <= 0xFE && c != 0xF7) || (c >= 0x3B1 && c <= 0x3C9 && c != 0x3C2) ||
         (c >= 0x430 && c <= 0x44F);
}
bool is_shifted_capital(char32_t c) {
  return (c >= 0xC0 && c <= 0xDE && c != 0xD7) || (c >= 0x391 && c <= 0x3A9 && c != 0x3A2) ||
         (c >= 0x410 && c <= 0x42F);
}

// Latin Extended-A, where capital and small letter alternate; the parity changes twice.
bool is_alternating(char32_t c) {
  return c >= 0x100 && c <= 0x17E && c != 0x130 && c != 0x131 && c != 0x138 && c != 0x149 &&
         c != 0x178;
}
bool capital_is_even(char32_t c) { return c < 0x138 || (c >= 0x14A && c <= 0x177); }

}  // namespace

char32_t character_at(std::string_view text, std::size_t byte, std::size_t& size) {
  const auto first = static_cast<unsigned char>(text[byte]);
  size = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 1;
  if (size == 1 || byte + size > text.size()) {
    size = 1;
    return first;
  }
  char32_t character = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if (!is_continuation(text[byte + i])) {
      size = 1;
      return first;
    }
    character = character << 6U | (static_cast<unsigned char>(text[byte + i]) & 0x3FU);
  }
  return character;
}

void append_character(std::string& out, char32_t character) {
  const auto byte = [](char32_t bits) {
    return static_cast<char>(static_cast<unsigned char>(bits));
  };
  if (character < 0x80) {
    out += byte(character);
  } else if (character < 0x800) {
    out += byte(0xC0U | character >> 6U);
    out += byte(0x80U | (character & 0x3FU));
  } else if (character < 0x10000) {
    out += byte(0xE0U | character >> 12U);
    out += byte(0x80U | (character >> 6U & 0x3FU));
    out += byte(0x80U | (character & 0x3FU));
  } else {
    out += byte(0xF0U | character >> 18U);
    out += byte(0x80U | (character >> 12U & 0x3FU));
    out += byte(0x80U | (character >> 6U & 0x3FU));
    out += byte(0x80U | (character & 0x3FU));
  }
}

std::size_t utf16_length(std::string_view text) {
  std::size_t length = 0;
  for (const char byte : text) {
    if (is_continuation(byte)) continue;
    length += static_cast<unsigned char>(byte) >= 0xF0 ? 2 : 1;
  }
  return length;
}

std::size_t byte_of_unit(std::string_view text, std::size_t unit) {
  std::size_t byte = 0;
  std::size_t units = 0;
  while (units < unit && byte < text.size()) {
    std::size_t size = 0;
    units += units_of(character_at(text, byte, size));
    byte += size;
  }
  return byte;
}

std::string_view utf16_slice(std::string_view text, std::size_t begin, std::size_t end) {
  const std::size_t first = byte_of_unit(text, begin);
  return text.substr(first, byte_of_unit(text.substr(first), end - begin));
}

char32_t upper_case_of(char32_t c) {
  if (c < 0x80) return c >= 'a' && c <= 'z' ? c - 32 : c;
  if (is_shifted_small(c)) return c - 32;
  if (c >= 0x450 && c <= 0x45F) return c - 80;
  if (c == 0xFF) return 0x178;
  if (c == 0x3C2) return 0x3A3;
  if (is_alternating(c) && (c % 2 == 1) == capital_is_even(c)) return c - 1;
  return c;
}

char32_t lower_case_of(char32_t c) {
  if (c < 0x80) return c >= 'A' && c <= 'Z' ? c + 32 : c;
  if (is_shifted_capital(c)) return c + 32;
  if (c >= 0x400 && c <= 0x40F) return c + 80;
  if (c == 0x178) return 0xFF;
  if (is_alternating(c) && (c % 2 == 0) == capital_is_even(c)) return c + 1;
  return c;
}

std::string lower_case_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); i += size) {
    append_character(out, lower_case_of(character_at(text, i, size)));
  }
  return out;
}

std::string upper_case_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); i += size) {
    const char32_t character = character_at(text, i, size);
    if (character == 0xDF) {
      out += "SS";
    } else {
      append_character(out, upper_case_of(character));
    }
  }
  return out;
}

std::int32_t java_int(double value) {
  if (std::isnan(value)) return 0;
  constexpr double kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::clamp(std::trunc(value), kLeast, kMost));
}

}  // namespace jaywalk::actions
