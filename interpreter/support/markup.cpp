// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/markup.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

void append_escaped(std::string& result, char c) {
  switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
  }
}

/// The control character at `at`, those of two bytes (U+0080 to U+009F) too; 0: there is none, or
/// it is a tab.
unsigned control_at(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  if (byte == 0xC2U && at + 1 < text.size()) {
    const auto next = static_cast<unsigned char>(text[at + 1]);
    return next >= 0x80U && next < 0xA0U ? next : 0;
  }
  return (byte < 0x20U && byte != '\t') || byte == 0x7FU ? byte : 0;
}

/// Behind the colours that begin with the ESC at `at`; `at` if it begins something else.
std::size_t colour_end(std::string_view text, std::size_t at) {
  if (at + 1 >= text.size() || text[at + 1] != '[') return at;
  const std::size_t end = text.find_first_not_of("0123456789;", at + 2);
  return end != std::string_view::npos && text[end] == 'm' ? end + 1 : at;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) append_escaped(result, c);
  return result;
}

std::string escaped_xml(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n' || c == '\t') {
      result += fmt::format("&#{};", byte);
    } else {
      append_escaped(result, byte < 0x20 ? '?' : c);
    }
  }
  return result;
}

std::string escaped_uri(std::string_view path) {
  std::string result;
  for (const char c : path) {
    const bool stays = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (stays) {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

std::string in_script(std::string_view json) {
  std::string result;
  for (const char c : json) {
    // Within JSON it stands in strings alone.
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

std::string visible(std::string_view text, LineBreaks breaks) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') {
      result += breaks == LineBreaks::kept ? "\n" : "\\n";
    } else if (const unsigned control = control_at(text, i); control != 0) {
      result += fmt::format("\\x{:02x}", control);
      if (control >= 0x80) ++i;
    } else if (text[i] == '\0') {
      result += "\\x00";
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string shell_quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

bool is_identifier(std::string_view text) {
  constexpr std::size_t kLongest = 100;
  return !text.empty() && text.size() <= kLongest && text.front() != '-' &&
         std::ranges::all_of(text, [](char c) { return is_name_character(c) || c == '-'; });
}

bool is_label(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  constexpr std::string_view kNotInFront = "=+-@ ";
  if (text.empty() || text.size() > kLongest ||
      kNotInFront.find(text.front()) != std::string_view::npos)
    return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\0' || text[i] == '\t' || control_at(text, i) != 0) return false;
  }
  return !first_bad_byte(text);
}

std::string visible_with_colours(std::string_view lines) {
  std::string result;
  std::size_t plain = 0;
  for (std::size_t at = lines.find('\x1b'); at != std::string_view::npos;
       at = lines.find('\x1b', at + 1)) {
    const std::size_t end = colour_end(lines, at);
    if (end == at) continue;
    result += visible(lines.substr(plain, at - plain), LineBreaks::kept);
    result += lines.substr(at, end - at);
    plain = end;
  }
  return result + visible(lines.substr(plain), LineBreaks::kept);
}

}  // namespace jaywalk
