#include "interpreter/check/checking.h"

#include <algorithm>
#include <utility>

namespace jaywalk {
namespace {

// The codes in a comment that has the mark, "allow " or "allow-file ", as a list after it.
bool names_code(std::string_view line, std::string_view mark, std::string_view code) {
  const std::size_t comment = line.find("//");
  if (comment == std::string_view::npos) return false;
  const std::size_t at = line.find(mark, comment);
  if (at == std::string_view::npos) return false;
  std::string_view codes = line.substr(at + mark.size());
  while (!codes.empty()) {
    const std::size_t end = codes.find_first_of(", \t\r");
    if (codes.substr(0, end) == code) return true;
    if (end == std::string_view::npos) return false;
    codes.remove_prefix(end + 1);
  }
  return false;
}

std::set<std::string, std::less<>> allowed_in(const Source& source) {
  constexpr std::string_view kMark = "jaywalk: allow-file ";
  std::set<std::string, std::less<>> codes;
  std::string_view text = source.text();
  for (std::size_t at = text.find(kMark); at != std::string_view::npos;
       at = text.find(kMark, at + 1)) {
    const std::uint32_t line = source.position(static_cast<std::uint32_t>(at)).line;
    for (const CheckInfo& check : checks()) {
      if (names_code(source.line(line), kMark, check.name)) codes.emplace(check.name);
    }
  }
  return codes;
}

}  // namespace

Checking::Checking(const SourceTree& program, const Vocabulary& vocabulary)
    : vocabulary_(vocabulary),
      index_(index_of(program)),
      mentions_(mentions_in(program)),
      answers_(index_.beliefs) {
  for (const Vocabulary::Entry& percept : vocabulary.percepts) {
    for (int arity = percept.least_args; arity <= percept.most_args; ++arity) {
      answers_.add(percept.name, arity);
    }
  }
  for (const std::string& test : index_.planned_tests.names()) {
    for (const int arity : index_.planned_tests.arities(test)) answers_.add(test, arity);
  }
  for (const auto& file : program.files) {
    files_.push_back({.file = file.get(),
                      .uses = uses_in(file->components),
                      .is_main = file == program.files.front(),
                      .allowed = allowed_in(*file->source),
                      .told = {},
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
         (told_everything() || (vocabulary_.may_be_alone && !mentions_.other_agents));
}

bool Checking::is_mentioned(std::string_view name) const {
  return mentions_.names.contains(name) || vocabulary_.named_by_others.contains(name);
}

void Checking::warn(CheckedFile& file, Span where, std::string message, std::string hint) {
  constexpr std::string_view kMark = "jaywalk: allow ";
  const SourcePtr& source = file.file->source;
  const std::uint32_t line = source->position(where.begin).line;
  if (file.allowed.contains(code_) || names_code(source->line(line), kMark, code_) ||
      (line > 1 && names_code(source->line(line - 1), kMark, code_))) {
    return;
  }
  if (!file.told.emplace(where.begin, code_).second) return;
  file.found.warning({source, where}, std::string(code_), std::move(message), std::move(hint));
}

Diagnostics Checking::finish() {
  Diagnostics all;
  for (CheckedFile& file : files_) {
    file.found.sort_by_place();
    all.append(std::move(file.found));
  }
  return all;
}

}  // namespace jaywalk
