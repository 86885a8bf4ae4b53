// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/remarks.h"

#include <algorithm>
#include <charconv>

namespace jaywalk {
namespace {

constexpr std::string_view kMark = "jaywalk:";
constexpr std::string_view kBlanksInLine = " \t\r";

/// Reads the words of one line, from a place in it on.
class Words {
 public:
  Words(std::string_view text, std::size_t at)
      : text_(text), at_(at), end_(std::min(text.find('\n', at), text.size())) {}

  [[nodiscard]] bool at_blank() const {
    return at_ < end_ && kBlanksInLine.find(text_[at_]) != kBlanksInLine.npos;
  }
  /// The word that follows the blanks, up to a blank or comma; empty at the line's end.
  Span next() {
    skip_blanks();
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(", \t\r\n", at_), end_);
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
  }
  /// Goes on behind a comma, if one follows.
  bool skip_comma() {
    skip_blanks();
    if (at_ >= end_ || text_[at_] != ',') return false;
    ++at_;
    return true;
  }

 private:
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlanksInLine, at_), end_); }

  std::string_view text_;
  std::size_t at_;
  std::size_t end_;
};

}  // namespace

std::vector<Remark> remarks(const Source& source) {
  std::vector<Remark> found;
  const std::string_view text = source.text();
  for (std::size_t at = text.find(kMark); at != text.npos; at = text.find(kMark, at + 1)) {
    const std::uint32_t line = source.position(static_cast<std::uint32_t>(at)).line;
    const std::string_view whole = source.line(line);
    const auto column = static_cast<std::size_t>(text.data() + at - whole.data());
    if (whole.substr(0, column).find("//") == whole.npos) continue;
    Words words(text, at + kMark.size());
    if (!words.at_blank()) continue;
    const Span word = words.next();
    if (word.begin == word.end) continue;
    do {
      const Span item = words.next();
      found.push_back({.word = source.text(word),
                       .word_span = word,
                       .item = source.text(item),
                       .item_span = item,
                       .line = line});
    } while (words.skip_comma());
  }
  return found;
}

bool is_silenced(const Source& source, std::uint32_t offset, std::string_view code) {
  const std::uint32_t line = source.position(offset).line;
  return std::ranges::any_of(remarks(source), [&](const Remark& remark) {
    const bool is_here =
        remark.word == Remark::kAllowFile || remark.line == line || remark.line + 1 == line;
    return remark.allows() && is_here && !code.empty() && remark.item == code;
  });
}

std::optional<AskedName> asked_name(std::string_view item) {
  AskedName asked;
  asked.is_goal = item.starts_with('!');
  if (asked.is_goal) item.remove_prefix(1);
  const std::size_t slash = item.rfind('/');
  if (slash == item.npos || slash == 0) return std::nullopt;
  asked.name = item.substr(0, slash);
  const char* const end = item.data() + item.size();
  const auto [behind, error] = std::from_chars(item.data() + slash + 1, end, asked.arity);
  if (error != std::errc() || behind != end || asked.arity < 0) return std::nullopt;
  return asked;
}

}  // namespace jaywalk
