#include "interpreter/support/markup.h"

#include <fmt/format.h>

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

}  // namespace jaywalk
