// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/command_line.h"

#include <algorithm>

#include "interpreter/support/diagnostics.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

/// A shell takes such a word as it stands.
bool is_plain(std::string_view word) {
  constexpr std::string_view kSpecial = " \t\n\"'`$&|;<>()*?[]#~!\\{}";
  return !word.empty() && word.find_first_of(kSpecial) == std::string_view::npos;
}

/// On one line: what would end it or move the cursor is shown as a question mark.
std::string on_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7F'; }, '?');
  return text;
}

/// The text between the last two quotes of the message, as in "found 'x'"; may be empty.
std::string_view last_quoted(std::string_view message) {
  const std::size_t end = message.rfind('\'');
  if (end == std::string_view::npos || end == 0) return {};
  const std::size_t begin = message.rfind('\'', end - 1);
  if (begin == std::string_view::npos) return {};
  return message.substr(begin + 1, end - begin - 1);
}

/// The item of a list with commas that the message quotes, as a part of the list; or all of it.
std::string_view meant_item(std::string_view list, std::string_view message) {
  const std::string_view quoted = last_quoted(message);
  for (std::size_t begin = 0; !quoted.empty() && begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string_view item = trimmed(list.substr(begin, end - begin));
    if (item == quoted) return item;
    begin = end + 1;
  }
  return list;
}

}  // namespace

CommandLine::CommandLine(std::span<const std::string> words, std::span<const OptionSpec> options) {
  std::string line = "jaywalk";
  for (const std::string& text : words) {
    line += ' ';
    const Word& word =
        words_.emplace_back(Word{.text = text, .begin = line.size(), .is_quoted = !is_plain(text)});
    const std::string shown = on_one_line(text);
    line += word.is_quoted ? '\'' + shown + '\'' : shown;
  }
  const auto dashes = std::ranges::find(words, "--");
  operands_from_ = static_cast<std::size_t>(dashes - words.begin());
  for (const OptionSpec& option : options) {
    if (!option.value.empty()) with_value_.push_back(option.name.dashed());
  }
  line_ = std::make_shared<const Source>("", std::move(line));
}

CommandLine::Place CommandLine::place_of_option(std::size_t word, std::string_view name) const {
  const std::string& text = words_[word].text;
  if (text.size() > name.size()) return {.word = word, .from = name.size() + 1};
  const bool has_value =
      std::ranges::find(with_value_, name) != with_value_.end() && word + 1 < words_.size();
  return {.word = has_value ? word + 1 : word};
}

std::optional<CommandLine::Place> CommandLine::find(std::string_view subject) const {
  const std::size_t blank = subject.find(' ');
  const std::string_view name = subject.substr(0, blank);
  if (!name.starts_with('-')) return std::nullopt;
  // The value given last counts.
  for (std::size_t i = operands_from_; i-- > 0;) {
    const std::string_view text = words_[i].text;
    if (text != name && !text.starts_with(std::string(name) + '=')) continue;
    const Place place = place_of_option(i, name);
    const std::string_view value = std::string_view(words_[place.word].text).substr(place.from);
    if (blank == std::string_view::npos || value == subject.substr(blank + 1)) return place;
  }
  return std::nullopt;
}

Span CommandLine::span_of(const Place& place, std::string_view message) const {
  const Word& word = words_[place.word];
  const std::string_view value = std::string_view(word.text).substr(place.from);
  const std::string_view meant = meant_item(value, message);
  const auto offset = static_cast<std::size_t>(meant.data() - word.text.data());
  const std::size_t begin = word.begin + (word.is_quoted ? 1 : 0) + offset;
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + meant.size())};
}

std::optional<SourceSpan> CommandLine::place_of(const Diagnostic& diagnostic) const {
  if (diagnostic.where.source != nullptr) return std::nullopt;
  const auto place = find(diagnostic.subject);
  if (!place) return std::nullopt;
  return SourceSpan{line_, span_of(*place, diagnostic.message)};
}

std::string CommandLine::render(const Diagnostics& diagnostics, Colour colour) const {
  std::string text = diagnostics.render(colour);
  std::size_t at = 0;
  for (const Diagnostic& item : diagnostics.items()) {
    const std::string without = jaywalk::render(item, colour);
    if (const auto place = place_of(item)) {
      const std::size_t below = at + without.find('\n') + 1;
      const std::string shown = excerpt(*place, colour);
      text.insert(below, shown);
      at += shown.size();
    }
    at += without.size();
  }
  return text;
}

}  // namespace jaywalk
