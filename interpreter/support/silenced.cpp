#include "interpreter/support/silenced.h"

#include <algorithm>

namespace jaywalk {
namespace {

constexpr std::string_view kMark = "jaywalk: allow";
constexpr std::string_view kWholeFile = "-file";
constexpr std::string_view kBlanksInLine = " \t\r";

// The codes from `at` to the line's end: words, each but the first behind a comma.
void read_codes(const Source& source, std::size_t at, AllowedCode found,
                std::vector<AllowedCode>& codes) {
  const std::string_view text = source.text();
  const std::size_t end = std::min(text.find('\n', at), text.size());
  while (at < end) {
    at = std::min(text.find_first_not_of(kBlanksInLine, at), end);
    const std::size_t word_end = std::min(text.find_first_of(", \t\r\n", at), end);
    if (word_end > at) {
      found.code = text.substr(at, word_end - at);
      found.span = {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(word_end)};
      codes.push_back(found);
    }
    at = std::min(text.find_first_not_of(kBlanksInLine, word_end), end);
    if (at >= end || text[at] != ',') return;
    ++at;
  }
}

}  // namespace

std::vector<AllowedCode> allowed_codes(const Source& source) {
  std::vector<AllowedCode> codes;
  const std::string_view text = source.text();
  for (std::size_t at = text.find(kMark); at != text.npos; at = text.find(kMark, at + 1)) {
    const std::uint32_t line = source.position(static_cast<std::uint32_t>(at)).line;
    const std::string_view whole = source.line(line);
    const auto column = static_cast<std::size_t>(text.data() + at - whole.data());
    if (whole.substr(0, column).find("//") == whole.npos) continue;
    std::size_t next = at + kMark.size();
    const bool in_whole_file = text.substr(next).starts_with(kWholeFile);
    if (in_whole_file) next += kWholeFile.size();
    if (next >= text.size() || kBlanksInLine.find(text[next]) == kBlanksInLine.npos) continue;
    read_codes(source, next, {.code = {}, .span = {}, .line = line, .in_whole_file = in_whole_file},
               codes);
  }
  return codes;
}

bool is_silenced(const Source& source, std::uint32_t offset, std::string_view code) {
  const std::uint32_t line = source.position(offset).line;
  return std::ranges::any_of(allowed_codes(source), [&](const AllowedCode& allowed) {
    return allowed.code == code &&
           (allowed.in_whole_file || allowed.line == line || allowed.line + 1 == line);
  });
}

}  // namespace jaywalk
