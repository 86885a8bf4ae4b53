// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/repl/repl_completion.h"

#include <algorithm>
#include <cctype>
#include <span>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

std::string_view last_word(std::string_view text) {
  std::size_t begin = text.size();
  while (begin > 0 && is_of_name(text[begin - 1])) --begin;
  return text.substr(begin);
}

void add_matches(std::span<const std::string> names, std::string_view word,
                 std::vector<std::string>& found) {
  for (const std::string& name : names) {
    if (name.starts_with(word)) found.push_back(name);
  }
}

bool is_within_string(std::string_view text) { return std::ranges::count(text, '"') % 2 == 1; }

}  // namespace

std::string Completion::common() const {
  if (candidates.empty()) return {};
  std::string shared = candidates.front();
  for (const std::string& candidate : candidates) {
    const auto [end, other] = std::ranges::mismatch(shared, candidate);
    shared.erase(end, shared.end());
  }
  return shared;
}

Completion complete_input(std::string_view before, const ReplNames& names) {
  Completion completion;
  const std::string_view word = last_word(before);
  const std::string_view ahead = before.substr(0, before.size() - word.size());
  completion.replaced = word.size();
  if (is_within_string(before)) return completion;
  const std::string_view line = trimmed(before);
  const bool is_command = line.starts_with(':');
  if (is_command && trimmed(ahead) == ":") {
    add_matches(names.commands, word, completion.candidates);
  } else if (ahead.ends_with('!') || line.starts_with(":trace") || line.starts_with(":plans")) {
    add_matches(names.goals, word, completion.candidates);
  } else if (is_command) {
    if (line.starts_with(":beliefs")) add_matches(names.predicates, word, completion.candidates);
  } else if (word.find('.') != word.npos) {
    add_matches(names.actions, word, completion.candidates);
  } else {
    add_matches(names.predicates, word, completion.candidates);
    add_matches(names.goals, word, completion.candidates);
    if (!word.empty()) add_matches(names.actions, word, completion.candidates);
  }
  std::ranges::sort(completion.candidates);
  completion.candidates.erase(
      std::unique(completion.candidates.begin(), completion.candidates.end()),
      completion.candidates.end());
  return completion;
}

}  // namespace jaywalk
