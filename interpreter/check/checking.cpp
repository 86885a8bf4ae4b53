#include "interpreter/check/checking.h"

#include <algorithm>
#include <utility>

#include "interpreter/support/silenced.h"

namespace jaywalk {
namespace {

std::set<std::string, std::less<>> allowed_in(const Source& source) {
  std::set<std::string, std::less<>> codes;
  for (const AllowedCode& allowed : allowed_codes(source)) {
    if (allowed.in_whole_file) codes.emplace(allowed.code);
  }
  return codes;
}

}  // namespace

Checking::Checking(const SourceTree& program, ProgramWords words, const Vocabulary& vocabulary)
    : vocabulary_(vocabulary),
      index_(std::move(words.index)),
      mentions_([&program] { return mentions_in(program); }),
      has_other_agents_([&program] { return shows_other_agents(program); }),
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
                      .reported = {},
                      .found = {}});
  }
  has_initial_goal_ = std::ranges::any_of(
      program.main().components,
      [](const ast::Component& component) { return component.kind == ast::ComponentKind::goal; });
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
