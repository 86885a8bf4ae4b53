#include "interpreter/check/checking.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/remarks.h"

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

}  // namespace jaywalk
