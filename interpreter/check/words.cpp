#include "interpreter/check/words.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/characters.h"

namespace jaywalk {
namespace {

constexpr std::size_t kShortestMisspelt = 5;

}  // namespace

bool is_misspelling(std::string_view name, std::string_view meant) {
  if (std::min(name.size(), meant.size()) < kShortestMisspelt) return false;
  if (name.size() == meant.size() &&
      name.substr(0, name.size() - 1) == meant.substr(0, meant.size() - 1)) {
    return false;
  }
  const bool plural = name.size() + 1 == meant.size() ? meant == std::string(name) + "s"
                                                      : name == std::string(meant) + "s";
  if (plural) return false;
  return std::none_of(name.begin(), name.end(), is_digit) ||
         std::none_of(meant.begin(), meant.end(), is_digit);
}

bool is_one_slip(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() > a.size() + 1) return false;
  const auto at = static_cast<std::size_t>(std::ranges::mismatch(a, b).in2 - b.begin());
  if (at == b.size()) return false;  // equal
  if (a.size() < b.size()) return a.substr(at) == b.substr(at + 1);
  if (a.substr(at + 1) == b.substr(at + 1)) return true;
  return at + 1 < a.size() && a[at] == b[at + 1] && a[at + 1] == b[at] &&
         a.substr(at + 2) == b.substr(at + 2);
}

std::string counted(const std::set<int>& arities) {
  std::string text;
  for (const int arity : arities) {
    if (!text.empty()) text += " or ";
    text += arity < 0 ? "any number of" : std::to_string(arity);
  }
  const bool one = arities.size() == 1 && *arities.begin() == 1;
  return text + (one ? " argument" : " arguments");
}

std::string counted(const Vocabulary::Entry& entry) {
  if (entry.most_args < 0) return fmt::format("at least {} arguments", entry.least_args);
  if (entry.least_args != entry.most_args) {
    return fmt::format("{} to {} arguments", entry.least_args, entry.most_args);
  }
  return counted(std::set{entry.least_args});
}

std::string_view short_name(std::string_view action) {
  constexpr std::string_view kPackage = "jason.stdlib";
  if (action.starts_with(kPackage) && action.substr(kPackage.size()).starts_with('.')) {
    action.remove_prefix(kPackage.size());
  }
  return action;
}

const Vocabulary::Entry* entry_of(std::span<const Vocabulary::Entry> entries,
                                  std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

bool takes(const Vocabulary::Entry& entry, int arity) {
  return arity >= entry.least_args && (entry.most_args < 0 || arity <= entry.most_args);
}

std::vector<std::string> names_of(std::span<const Vocabulary::Entry> entries) {
  std::vector<std::string> names;
  for (const Vocabulary::Entry& entry : entries) names.push_back(entry.name);
  return names;
}

}  // namespace jaywalk
