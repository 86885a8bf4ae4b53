// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/checking.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "interpreter/check/check.h"
#include "interpreter/support/remarks.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

std::set<std::string, std::less<>> allowed_in(const Source& source) {
  std::set<std::string, std::less<>> codes;
  for (const Remark& remark : remarks(source)) {
    if (remark.word == Remark::kAllowFile) codes.emplace(remark.item);
  }
  return codes;
}

bool has_goal(std::span<const ast::Component> components) {
  return std::ranges::any_of(components, [](const ast::Component& component) {
    return component.kind == ast::ComponentKind::goal || has_goal(component.inner);
  });
}

std::set<std::string_view> asked_in(const Source& source) {
  std::set<std::string_view> names;
  for (const Remark& remark : remarks(source)) {
    if (remark.word == Remark::kAsks && asked_name(remark.item)) names.insert(remark.item);
  }
  return names;
}

constexpr std::array kChecks = {
#define JAYWALK_CHECK(function, code, summary) CheckInfo{code, summary},
#define JAYWALK_READING(code, summary) CheckInfo{code, summary},
#include "interpreter/check/checks.def"
};

constexpr std::size_t kShortestMisspelt = 5;

}  // namespace

Checking::Checking(const SourceTree& program, ProgramWords words, const Vocabulary& vocabulary)
    : program_(program),
      vocabulary_(vocabulary),
      index_(std::move(words.index)),
      mentions_([&program] { return mentions_in(program); }),
      has_other_agents_([&program] { return shows_other_agents(program); }),
      libraries_([&vocabulary] {
        return vocabulary.libraries ? vocabulary.libraries() : std::vector<Vocabulary::Library>();
      }),
      answers_(index_.beliefs) {
  for (const Vocabulary::Entry& percept : vocabulary.percepts) {
    for (int arity = percept.least_args; arity <= percept.most_args; ++arity) {
      answers_.add(percept.name, arity);
    }
  }
  for (const std::string& test : index_.planned_tests.names()) {
    for (const int arity : index_.planned_tests.arities(test)) answers_.add(test, arity);
  }
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    files_.push_back({.file = program.files[i].get(),
                      .uses = std::move(words.uses[i]),
                      .is_main = i == 0,
                      .allowed = allowed_in(*program.files[i]->source),
                      .asked = asked_in(*program.files[i]->source),
                      .reported = {},
                      .found = {}});
  }
  has_initial_goal_ = std::ranges::any_of(
      program.files, [](const auto& file) { return has_goal(file->components); });
}

bool Checking::asked_by_nobody() const {
  if (index_.has_open_goals || index_.has_open_beliefs) return false;
  if (vocabulary_.others_known) return true;
  return has_initial_goal_ &&
         (told_everything() || (vocabulary_.may_be_alone && !*has_other_agents_));
}

bool Checking::is_mentioned(std::string_view name) const {
  return mentions().names.contains(name) || vocabulary_.named_by_others.contains(name);
}

std::string Checking::library_defining(std::string_view name) const {
  const auto found = std::ranges::find_if(*libraries_, [&](const Vocabulary::Library& library) {
    return library.defines.contains(name);
  });
  return found == libraries_->end() ? "" : fmt::format("include(\"{}\") defines it", found->name);
}

std::string Checking::library_asking(std::string_view name) const {
  const auto found = std::ranges::find_if(
      *libraries_, [&](const Vocabulary::Library& library) { return library.asks.contains(name); });
  return found == libraries_->end() ? "" : fmt::format("include(\"{}\") asks for it", found->name);
}

void Checking::warn(CheckedFile& file, Span where, std::string message, std::string hint) {
  if (file.allowed.contains(code_)) return;
  if (!file.reported.emplace(where.begin, code_).second) return;
  file.found.warning({file.file->source, where}, std::string(code_), std::move(message),
                     std::move(hint));
}

void Checking::warn(const Vocabulary::Setting& setting, std::string message, std::string hint) {
  about_settings_.add({.severity = Severity::warning,
                       .message = std::move(message),
                       .where = setting.where,
                       .hint = std::move(hint),
                       .code = std::string(code_),
                       .subject = setting.option});
}

Diagnostics Checking::finish() {
  Diagnostics all = std::move(about_settings_);
  for (CheckedFile& file : files_) {
    file.found.sort_by_place();
    all.append(std::move(file.found));
  }
  return all;
}

std::span<const CheckInfo> checks() { return kChecks; }

void check_program(const SourceTree& program, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics) {
  check_program(program, words_of(program), vocabulary, diagnostics);
}

void check_program(const SourceTree& program, ProgramWords words, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics) {
  Checking checking(program, std::move(words), vocabulary);
#define JAYWALK_CHECK(function, code, summary) \
  checking.begin(code);                        \
  function(checking);
#include "interpreter/check/checks.def"
  diagnostics.append(checking.finish());
}

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
