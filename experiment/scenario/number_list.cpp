// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/number_list.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

struct Range {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

std::optional<std::uint32_t> parse_count(std::string_view text) {
  text = trimmed(text);
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number > 0 && number <= kMaxAgents ? std::optional(number) : std::nullopt;
}

std::optional<Range> parse_range(std::string_view text) {
  const auto dots = text.find("..");
  const auto first = parse_count(text.substr(0, dots));
  const auto last = dots == std::string_view::npos ? first : parse_count(text.substr(dots + 2));
  if (!first || !last || *first > *last) return std::nullopt;
  return Range{.first = *first, .last = *last};
}

}  // namespace

Result<std::vector<std::uint32_t>> parse_number_list(std::string_view text,
                                                     std::string_view subject) {
  Diagnostics diagnostics;
  std::vector<std::uint32_t> numbers;
  while (true) {
    const auto comma = text.find(',');
    const std::string_view item = trimmed(text.substr(0, comma));
    const auto range = parse_range(item);
    if (!range) {
      diagnostics.error(
          std::string(subject),
          fmt::format("expected a number from 1 to {} or a range, found '{}'", kMaxAgents, item),
          "write a list as 1..10,15,20");
    } else {
      for (std::uint32_t number = range->first; number <= range->last; ++number) {
        if (std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
      }
    }
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  if (diagnostics.has_errors()) return diagnostics;
  return numbers;
}

}  // namespace jaywalk
