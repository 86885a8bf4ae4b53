// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/lsp/lsp_document.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/logic/action.h"
#include "interpreter/support/text.h"
#include "interpreter/syntax/lexer.h"
#include "interpreter/syntax/project/project.h"
#include "tools/jaywalk/programs/program_check.h"
#include "tools/jaywalk/programs/vocabulary.h"

namespace jaywalk::lsp {
namespace {

using What = Use::What;

struct DirectiveHelp {
  std::string_view name;
  std::string_view detail;
};
constexpr std::array kDirectives = {
    DirectiveHelp{"include", "the program of another file, perhaps in a namespace"},
    DirectiveHelp{"begin", "begins a block: namespace, or a goal pattern"},
    DirectiveHelp{"end", "ends a block"},
    DirectiveHelp{"namespace", "the namespace of a block, or a local one"},
    DirectiveHelp{"register_function", "a function that is a query"},
    DirectiveHelp{"dg", "declarative goal"},
    DirectiveHelp{"bdg", "backtracking declarative goal"},
    DirectiveHelp{"ebdg", "exclusive backtracking declarative goal"},
    DirectiveHelp{"bc", "blind commitment"},
    DirectiveHelp{"smc", "single-minded commitment"},
    DirectiveHelp{"rc", "relativised commitment"},
    DirectiveHelp{"omc", "open-minded commitment"},
    DirectiveHelp{"mg", "maintenance goal"},
    DirectiveHelp{"sga", "sequenced goal adoption"}};

bool is_in_dotted_name(char c) { return is_name_character(c) || c == '.'; }

std::string code(std::string_view text) { return fmt::format("```jason\n{}\n```", text); }

// The comment lines right above a place, without their slashes.
std::string comment_above(std::string_view text, std::size_t at) {
  std::vector<std::string_view> lines;
  std::size_t begin = text.rfind('\n', at == 0 ? 0 : at - 1);
  if (begin == text.npos) return {};
  while (begin > 0 && begin != text.npos) {
    const std::size_t before = text.rfind('\n', begin - 1);
    const std::size_t first = before == text.npos ? 0 : before + 1;
    std::string_view line = text.substr(first, begin - first);
    const std::size_t blank = line.find_first_not_of(" \t");
    if (blank == line.npos || !line.substr(blank).starts_with("//")) break;
    line.remove_prefix(std::min(line.find_first_not_of('/', blank), line.size()));
    lines.push_back(line);
    begin = before;
  }
  std::string comment;
  // They were gathered from below.
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    std::string_view trimmed = *line;
    while (trimmed.starts_with(' ')) trimmed.remove_prefix(1);
    while (!trimmed.empty() && (trimmed.back() == '\r' || trimmed.back() == ' ')) {
      trimmed.remove_suffix(1);
    }
    comment += fmt::format("{}\n", trimmed);
  }
  return comment;
}

// A plan up to its arrow.
std::string head_of(const ast::Plan& plan, const Source& source) {
  std::uint32_t end = plan.trigger.literal->span.end;
  if (plan.context != nullptr) end = std::max(end, plan.context->span.end);
  if (plan.goal_condition != nullptr) end = std::max(end, plan.goal_condition->span.end);
  return std::string(source.text(Span{plan.trigger.span.begin, end}));
}

bool misses_include(const SourceTree& program, std::span<const ast::Component> components) {
  return std::ranges::any_of(components, [&](const ast::Component& component) {
    if (component.kind != ast::ComponentKind::directive) return false;
    if (component.is_block) return misses_include(program, component.inner);
    return component.literal->text == "include" && !program.includes.contains(&component);
  });
}

std::string action_text(std::string_view name) {
  if (name.starts_with("jason.stdlib."))
    name.remove_prefix(std::string_view("jason.stdlib").size());
  if (const ActionDefinition* const action = standard_actions().action(name)) {
    return code(action->signature) + "\n" + action->summary;
  }
  for (const FunctionDefinition& function : standard_actions().functions()) {
    if (function.name == name) return code(function.signature) + "\n" + function.summary;
  }
  return {};
}

}  // namespace

Document::Document(std::string uri, SourcePtr source, const IncludePath& include_path)
    : uri_(std::move(uri)),
      is_project_(uri_.ends_with(".mas2j")),
      source_(std::move(source)),
      places_(source_->text()) {
  if (is_project_) {
    Diagnostics found;
    (void)parse_project(source_, found);
    diagnostics_.assign(found.items().begin(), found.items().end());
  } else {
    analyse_program(include_path);
  }
}

void Document::analyse_program(const IncludePath& include_path) {
  Diagnostics found;
  program_ = load_agent(source_, include_path, found);
  misses_include_ = std::ranges::any_of(program_.files, [this](const auto& file) {
    return misses_include(program_, file->components);
  });
  check_alone(program_, source_->name(), found);
  for (const Diagnostic& diagnostic : found.items()) {
    if (diagnostic.where.source == source_) diagnostics_.push_back(diagnostic);
  }
  // The first error in another file is reported at the document's beginning.
  for (const Diagnostic& diagnostic : found.items()) {
    if (diagnostic.where.source == source_ || diagnostic.severity != Severity::error) continue;
    Diagnostic here = diagnostic;
    const std::string place =
        diagnostic.where.source == nullptr ? diagnostic.subject : diagnostic.where.source->name();
    here.message = fmt::format("{}: {}", place, diagnostic.message);
    here.where = {source_, Span{}};
    diagnostics_.push_back(std::move(here));
    break;
  }
  uses_ = uses_of_names(program_);
}

std::span<const ast::Component> Document::components() const {
  return program_.files.empty() ? std::span<const ast::Component>() : program_.main().components;
}

const Use* Document::use_there(Position at) const {
  if (program_.files.empty()) return nullptr;
  return use_at(uses_, program_.main(), places_.offset(at));
}

Place Document::place_of(const Use& use) const {
  if (use.file->source == source_) return {source_->name(), places_.range(use.span)};
  return {use.file->source->name(), TextPlaces(use.file->source->text()).range(use.span)};
}

std::string Document::goal_text(const Use& goal) const {
  std::string text;
  for (const Use& use : uses_) {
    if (!use.is_same_name(goal) || !use.defines || use.plan == nullptr) continue;
    const Source& source = *use.file->source;
    const std::string comment = comment_above(source.text(), use.plan->span.begin);
    if (!text.empty()) text += "\n\n";
    text += code(head_of(*use.plan, source));
    if (!comment.empty()) text += "\n" + comment;
  }
  return text;
}

std::optional<std::pair<std::string, Range>> Document::hover(Position at) const {
  const Use* const use = use_there(at);
  if (use == nullptr) return std::nullopt;
  std::string text;
  switch (use->what) {
    case What::internal_action:
      text = action_text(use->name);
      break;
    case What::goal:
      text = goal_text(*use);
      break;
    case What::belief:
    case What::action: {
      const Vocabulary vocabulary = vocabulary_for(environment_of(program_));
      const auto& known = use->what == What::belief ? vocabulary.percepts : vocabulary.actions;
      // One name may have several forms, as move(Way) and move(Way,Cells).
      const Vocabulary::Entry* found = entry_of(known, use->name);
      for (const Vocabulary::Entry& entry : known) {
        if (entry.name == use->name && takes(entry, use->arity)) found = &entry;
      }
      if (found != nullptr) text = fmt::format("`{}`: {}", found->name, found->summary);
      for (const Use& other : uses_) {
        if (!text.empty() || !other.is_same_name(*use) || !other.defines) continue;
        const std::string_view all = other.file->source->text();
        std::string comment = comment_above(all, other.span.begin);
        if (!comment.empty()) text = std::move(comment);
      }
      break;
    }
  }
  if (text.empty()) return std::nullopt;
  return std::pair(std::move(text), places_.range(use->span));
}

std::vector<Completion> Document::completions(Position at, Range& written) const {
  const std::string_view text = source_->text();
  const std::uint32_t end = places_.offset(at);
  std::uint32_t begin = end;
  while (begin > 0 && is_in_dotted_name(text[begin - 1])) --begin;
  written = places_.range({begin, end});
  const std::string_view prefix = text.substr(begin, end - begin);
  // The characters before the word decide what fits: `!` a goal, `{` a directive.
  std::size_t before = begin;
  while (before > 0 && (text[before - 1] == ' ' || text[before - 1] == '\t')) --before;
  const char previous = before == 0 ? '\n' : text[before - 1];

  std::map<std::string, Completion> found;  // by label
  const auto offer = [&](std::string_view label, std::string detail, What what) {
    if (!label.starts_with(prefix) || (label.size() == prefix.size() && begin != end)) return;
    found.try_emplace(std::string(label), Completion{std::string(label), std::move(detail), what});
  };
  if (previous == '{') {
    for (const DirectiveHelp& each : kDirectives) {
      offer(each.name, std::string(each.detail), What::internal_action);
    }
  }
  const bool wants_goal = previous == '!';
  const Vocabulary vocabulary = vocabulary_for(environment_of(program_));
  for (const Use& use : uses_) {
    // A goal without a plan may be a slip.
    const bool fits = use.what == What::goal ? wants_goal && use.plan != nullptr : !wants_goal;
    if (!fits || use.what == What::internal_action) continue;
    // The word that is being written is no proposal.
    if (use.span.begin <= begin && begin <= use.span.end && use.file->source == source_) continue;
    offer(use.name, fmt::format("{}/{}", use.name, use.arity), use.what);
  }
  if (!wants_goal) {
    for (const auto& entry : vocabulary.percepts) offer(entry.name, entry.summary, What::belief);
    for (const auto& entry : vocabulary.actions) offer(entry.name, entry.summary, What::action);
    for (const auto& entry : vocabulary.internal_actions) {
      offer(entry.name, entry.summary, What::internal_action);
    }
  }
  std::vector<Completion> completions;
  for (auto& [label, completion] : found) completions.push_back(std::move(completion));
  return completions;
}

std::vector<Place> Document::definitions(Position at) const {
  const Use* const use = use_there(at);
  if (use == nullptr) return {};
  std::vector<Place> places;
  for (const Use& other : uses_) {
    if (other.is_same_name(*use) && other.defines) places.push_back(place_of(other));
  }
  if (!places.empty()) return places;
  // A belief that is nowhere written down: the plans that react to it.
  for (const Use& other : uses_) {
    if (other.is_same_name(*use) && other.plan != nullptr) places.push_back(place_of(other));
  }
  return places;
}

std::optional<Place> Document::renamable(Position at) const {
  const Use* const use = use_there(at);
  if (use == nullptr || (use->what != What::goal && use->what != What::belief)) {
    return std::nullopt;
  }
  return place_of(*use);
}

bool Document::is_of_environment(const Use& use) const {
  const EnvironmentKind* const environment = environment_of(program_);
  if (environment == nullptr || use.what != What::belief) return false;
  return std::ranges::any_of(environment->percepts, [&](const EnvironmentWord& word) {
    return functor(word) == use.name && arity(word) == use.arity;
  });
}

bool Document::depends_on(std::string_view path) const {
  return misses_include_ || std::ranges::any_of(program_.files, [path](const auto& file) {
           return file->source->name() == path;
         });
}

bool is_good_name(std::string_view name) {
  Diagnostics ignored;
  const auto tokens = tokenize(std::make_shared<const Source>("name", std::string(name)), ignored);
  return tokens.size() == 2 && tokens[0].kind == TokenKind::atom &&
         tokens[0].span.end - tokens[0].span.begin == name.size() &&
         (name.front() == '\'' || name.find('.') == name.npos);
}

}  // namespace jaywalk::lsp
