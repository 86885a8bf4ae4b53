// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "interpreter/support/text.h"
#include <jaywalk/diagnostics.h>

namespace jaywalk {

Source::Source(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), line_starts_{0} {
  assert(text_.size() < std::numeric_limits<std::uint32_t>::max() && "offsets have 32 bits");
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) {
    line_starts_.push_back(static_cast<std::uint32_t>(at + 1));
  }
  std::size_t count = 0;
  const std::string_view all = text_;
  for (std::size_t at = 0; at + kBetweenMarks <= all.size(); at += kBetweenMarks) {
    count += character_count(all.substr(at, kBetweenMarks));
    characters_at_marks_.push_back(static_cast<std::uint32_t>(count));
  }
}

std::string_view Source::text(Span span) const {
  const std::size_t begin = std::min<std::size_t>(span.begin, text_.size());
  const std::size_t end = std::clamp<std::size_t>(span.end, begin, text_.size());
  return std::string_view(text_).substr(begin, end - begin);
}

// In a very long line, characters are not counted from its beginning for each position.
std::size_t Source::characters_before(std::uint32_t offset) const {
  const std::size_t mark = offset / kBetweenMarks;
  const auto begin = static_cast<std::uint32_t>(mark * kBetweenMarks);
  return (mark == 0 ? 0 : characters_at_marks_[mark - 1]) + character_count(text({begin, offset}));
}

Source::Position Source::position(std::uint32_t offset) const {
  const auto clamped = static_cast<std::uint32_t>(std::min<std::size_t>(offset, text_.size()));
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), clamped);
  const std::uint32_t start = *std::prev(next);
  Position position;
  position.line = static_cast<std::uint32_t>(next - line_starts_.begin());
  position.column += static_cast<std::uint32_t>(
      clamped - start < kBetweenMarks ? character_count(text({start, clamped}))
                                      : characters_before(clamped) - characters_before(start));
  return position;
}

std::string_view Source::line(std::uint32_t number) const {
  if (number == 0 || number > line_starts_.size()) return {};
  const std::uint32_t begin = line_starts_[number - 1];
  const std::size_t end = number < line_starts_.size() ? line_starts_[number] - 1 : text_.size();
  std::string_view line = std::string_view(text_).substr(begin, end - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace jaywalk
