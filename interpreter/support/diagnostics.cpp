// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/diagnostics.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/support/markup.h"
#include "interpreter/support/remarks.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

// Lines are shown in a window of this many characters around the place that is meant.
constexpr std::size_t kShownBefore = 60;
constexpr std::size_t kShownCharacters = 100;

// The byte at which the character `characters` before `at` begins.
std::size_t step_back(std::string_view line, std::size_t at, std::size_t characters) {
  while (at > 0 && characters > 0) {
    --at;
    if (begins_character(line[at])) --characters;
  }
  return at;
}

std::size_t step_forward(std::string_view line, std::size_t at, std::size_t characters) {
  while (at < line.size()) {
    if (begins_character(line[at])) {
      if (characters == 0) break;
      --characters;
    }
    ++at;
  }
  return at;
}

// Control characters would move the caret or the terminal's cursor; each becomes one character, so
// that the caret below stays where it belongs.
std::string printable(std::string_view text) {
  std::string shown(text);
  std::replace_if(
      shown.begin(), shown.end(),
      [](char c) { return (static_cast<unsigned char>(c) < 0x20U && c != '\t') || c == '\x7F'; },
      '?');
  return shown;
}

// Blanks as wide as the text; tabs stay tabs, so that they are as wide as in the line above.
std::string blanks_like(std::string_view text) {
  std::string blanks;
  for (const char c : text) {
    if (begins_character(c)) blanks += c == '\t' ? '\t' : ' ';
  }
  return blanks;
}

struct Paint {
  Colour colour;

  [[nodiscard]] std::string operator()(std::string_view code, std::string_view text) const {
    if (colour == Colour::off) return std::string(text);
    return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
  }
};

constexpr std::string_view kBold = "1";
constexpr std::string_view kGreen = "1;32";

std::string_view code_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "1;31";
    case Severity::warning:
      return "1;35";
    case Severity::note:
      return "1;36";
  }
  return "";
}

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
  }
  return "";
}

// The line of the text that is meant, and below it the caret.
std::string marked_line(const Source& source, Span span, Paint paint) {
  const std::string_view line = source.line(source.position(span.begin).line);
  const auto line_begin = static_cast<std::size_t>(line.data() - source.text().data());
  const std::size_t caret = std::min<std::size_t>(span.begin - line_begin, line.size());
  const std::size_t last = std::clamp<std::size_t>(span.end - line_begin, caret, line.size());

  std::size_t begin = 0;
  std::size_t end = line.size();
  if (character_count(line) > kShownCharacters) {
    begin = step_back(line, caret, kShownBefore);
    end = step_forward(line, begin, kShownCharacters);
  }
  const std::string_view before = begin > 0 ? "..." : "";
  const std::string_view after = end < line.size() ? "..." : "";

  const std::size_t marked = character_count(line.substr(caret, std::min(last, end) - caret));
  std::string mark(std::max<std::size_t>(marked, 1), '~');
  mark.front() = '^';
  return fmt::format("  {}{}{}\n  {}{}{}\n", before, printable(line.substr(begin, end - begin)),
                     after, std::string(before.size(), ' '),
                     blanks_like(line.substr(begin, caret - begin)), paint(kGreen, mark));
}

// For people: of a very long text its begin and its end.
std::string without_middle(std::string_view text) {
  constexpr std::size_t kMostShown = 2000;
  if (text.size() <= kMostShown) return visible(text);
  const std::size_t begin = step_back(text, step_forward(text, 0, kMostShown * 3 / 4), 0);
  const std::size_t end = step_back(text, text.size(), kMostShown / 4);
  if (begin >= end) return visible(text);
  return fmt::format("{} ... ({} bytes left out) ... {}", visible(text.substr(0, begin)),
                     end - begin, visible(text.substr(end)));
}

// Names longer than this are not misspelt but something else.
constexpr std::size_t kLongestName = 64;

// Damerau-Levenshtein distance with adjacent transpositions (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) current[j] = std::min(current[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, current);
  }
  return last[b.size()];
}

}  // namespace

std::string render(const Diagnostic& diagnostic, Colour colour) {
  const Paint paint{colour};
  std::string place = without_middle(diagnostic.subject);
  if (diagnostic.where.source) {
    const auto [line, column] = diagnostic.where.source->position(diagnostic.where.span.begin);
    place = fmt::format("{}:{}:{}", visible(diagnostic.where.source->name()), line, column);
  }
  std::string text = place.empty() ? std::string() : paint(kBold, place + ":") + " ";
  text += fmt::format(
      "{} {}",
      paint(code_of(diagnostic.severity), fmt::format("{}:", name_of(diagnostic.severity))),
      paint(kBold, without_middle(diagnostic.message)));
  if (!diagnostic.code.empty()) text += fmt::format(" [{}]", diagnostic.code);
  text += '\n';
  if (diagnostic.where.source) {
    text += marked_line(*diagnostic.where.source, diagnostic.where.span, paint);
  }
  if (!diagnostic.hint.empty())
    text += fmt::format("  hint: {}\n", without_middle(diagnostic.hint));
  return text;
}

std::string excerpt(const SourceSpan& where, Colour colour) {
  return marked_line(*where.source, where.span, Paint{colour});
}

std::uint32_t offset_of(const Source& source, Source::Position position) {
  const std::string_view line = source.line(position.line);
  if (line.data() == nullptr) return static_cast<std::uint32_t>(source.text().size());
  const std::size_t at = step_forward(line, 0, position.column == 0 ? 0 : position.column - 1);
  return static_cast<std::uint32_t>(line.data() - source.text().data()) +
         static_cast<std::uint32_t>(at);
}

Diagnostics with_errors(const Diagnostics& diagnostics, std::string_view code,
                        std::string_view hint) {
  Diagnostics changed;
  for (Diagnostic item : diagnostics.items()) {
    if (item.severity == Severity::warning && item.code == code) {
      item.severity = Severity::error;
      item.code.clear();
      item.hint += fmt::format("{}{}", item.hint.empty() ? "" : "; ", hint);
    }
    changed.add(std::move(item));
  }
  return changed;
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++errors_;
  if (diagnostic.severity == Severity::warning) ++warnings_;
  if (items_.size() < kLimit) items_.push_back(std::move(diagnostic));
}

void Diagnostics::error(SourceSpan where, std::string message, std::string hint) {
  add({.severity = Severity::error,
       .message = std::move(message),
       .where = std::move(where),
       .hint = std::move(hint),
       .code = {},
       .subject = {}});
}

void Diagnostics::warning(SourceSpan where, std::string code, std::string message,
                          std::string hint) {
  // Beyond the limit nothing is shown, so that no comments need be looked for.
  const bool is_shown = items_.size() < kLimit;
  if (where.source && is_shown && is_silenced(*where.source, where.span.begin, code)) return;
  add({.severity = Severity::warning,
       .message = std::move(message),
       .where = std::move(where),
       .hint = std::move(hint),
       .code = std::move(code),
       .subject = {}});
}

void Diagnostics::error(std::string subject, std::string message, std::string hint) {
  add({.severity = Severity::error,
       .message = std::move(message),
       .where = {},
       .hint = std::move(hint),
       .code = {},
       .subject = std::move(subject)});
}

void Diagnostics::append(Diagnostics other) {
  errors_ += other.errors_;
  warnings_ += other.warnings_;
  const std::size_t room = kLimit - items_.size();
  const auto taken = static_cast<std::ptrdiff_t>(std::min(room, other.items_.size()));
  std::move(other.items_.begin(), other.items_.begin() + taken, std::back_inserter(items_));
}

void Diagnostics::sort_by_place() {
  std::stable_sort(items_.begin(), items_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.where.span.begin < b.where.span.begin;
  });
}

std::string Diagnostics::render(Colour colour) const {
  std::string text;
  for (const Diagnostic& item : items_) text += jaywalk::render(item, colour);
  const std::size_t shown_errors_and_warnings = static_cast<std::size_t>(
      std::count_if(items_.begin(), items_.end(),
                    [](const Diagnostic& item) { return item.severity != Severity::note; }));
  const std::size_t hidden = errors_ + warnings_ - shown_errors_and_warnings;
  if (hidden > 0) text += fmt::format("... and {} more\n", hidden);
  return text;
}

std::optional<std::string> closest(std::string_view name, std::span<const std::string> candidates) {
  if (name.size() > kLongestName) return std::nullopt;
  std::optional<std::string> best;
  std::size_t best_distance = 0;
  for (const std::string& candidate : candidates) {
    if (candidate == name || candidate.size() > kLongestName) continue;
    const std::size_t allowed = std::max(name.size(), candidate.size()) / 3;
    const std::size_t difference =
        std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size());
    if (difference > allowed) continue;
    const std::size_t found = distance(name, candidate);
    if (found > allowed || (best && found >= best_distance)) continue;
    best = candidate;
    best_distance = found;
  }
  return best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  const std::optional<std::string> candidate = closest(name, candidates);
  return candidate ? fmt::format("did you mean '{}'?", *candidate) : std::string();
}

}  // namespace jaywalk
