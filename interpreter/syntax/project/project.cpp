// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/project/project.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/syntax/project/project_lexer.h"

namespace jaywalk {
namespace {

constexpr std::array<std::string_view, 8> kSections = {
    "infrastructure", "environment", "executionControl", "agents",
    "directives",     "classpath",   "aslSourcePath",    "MAS"};

constexpr std::array<std::string_view, 10> kOtherReserved = {
    "at",   "events", "intBels",    "nrcbp",          "verbose",
    "true", "false",  "agentClass", "agentArchClass", "beliefBaseClass"};

// Options whose value must be one of these words; the others take any.
struct ClosedOption {
  std::string_view name;
  std::array<std::string_view, 3> values;
};
constexpr std::array kClosedOptions = {
    ClosedOption{"events", {"discard", "requeue", "retrieve"}},
    ClosedOption{"intBels", {"sameFocus", "newFocus", "sameFocus"}},
    ClosedOption{"synchronised", {"true", "false", "true"}},
};

template <class Range>
bool contains(const Range& range, std::string_view name) {
  return std::find(range.begin(), range.end(), name) != range.end();
}

class ProjectParser {
 public:
  ProjectParser(const SourcePtr& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics), tokens_(project_tokens(source, diagnostics)) {
    project_.source = source;
  }

  Project run() {
    if (!expect("MAS", "a project begins with MAS and its name")) return std::move(project_);
    if (const ProjectToken* name = expect_name("the name of the system"))
      project_.name = name->text;
    if (!expect("{")) return std::move(project_);
    while (!is("}") && !is(ProjectTokenKind::end_of_text)) section();
    (void)expect("}");
    return std::move(project_);
  }

 private:
  [[nodiscard]] const ProjectToken& next() const { return tokens_[at_]; }
  [[nodiscard]] bool is(ProjectTokenKind kind) const { return next().kind == kind; }
  [[nodiscard]] bool is(std::string_view text) const {
    return (is(ProjectTokenKind::word) || is(ProjectTokenKind::symbol)) && next().text == text;
  }
  const ProjectToken& take() {
    const ProjectToken& token = tokens_[at_];
    if (token.kind != ProjectTokenKind::end_of_text) ++at_;
    return token;
  }
  bool take_if(std::string_view text) {
    if (!is(text)) return false;
    take();
    return true;
  }
  [[nodiscard]] SourceSpan where(Span span) const { return {source_, span}; }

  // Reports what stands here in place of something else; a bad token has been reported.
  void unexpected(std::string_view expected, std::string hint = {}) {
    if (is(ProjectTokenKind::bad)) return;
    const std::string found = is(ProjectTokenKind::end_of_text) ? "the end of the text"
                                                                : fmt::format("'{}'", next().text);
    diagnostics_.error(where(next().span), fmt::format("expected {}, found {}", expected, found),
                       std::move(hint));
  }

  bool expect(std::string_view text, std::string hint = {}) {
    if (take_if(text)) return true;
    unexpected(fmt::format("'{}'", text), std::move(hint));
    return false;
  }

  const ProjectToken* expect_kind(ProjectTokenKind kind, std::string_view what) {
    if (is(kind)) return &take();
    unexpected(what);
    return nullptr;
  }

  const ProjectToken* expect_name(std::string_view what) {
    if (!is(ProjectTokenKind::word)) {
      unexpected(what);
      return nullptr;
    }
    const ProjectToken& token = next();
    if (contains(kSections, token.text) || contains(kOtherReserved, token.text)) {
      unexpected(what, fmt::format("'{}' is a reserved word", token.text));
      return nullptr;
    }
    if (token.text.front() < 'a') unexpected(what, "names begin with a lower-case letter");
    return &take();
  }

  // To behind the next ';', or before what ends the section.
  void skip_entry() {
    while (!is(ProjectTokenKind::end_of_text) && !is("}") && !begins_section()) {
      if (take().text == ";") return;
    }
  }

  [[nodiscard]] bool begins_section() const {
    return is(ProjectTokenKind::word) && contains(kSections, next().text) &&
           tokens_[at_ + 1].text == ":";
  }

  void section() {
    const ProjectToken name = next();
    const auto* const found = std::find(kSections.begin(), kSections.end() - 1, name.text);
    if (!is(ProjectTokenKind::word) || found == kSections.end() - 1) {
      const std::vector<std::string> names(kSections.begin(), kSections.end() - 1);
      unexpected("a section such as 'agents'", did_you_mean(name.text, names));
      take();
      skip_entry();
      return;
    }
    // kSections is in the order that Jason's grammar asks for.
    const auto order = static_cast<int>(found - kSections.begin());
    if (order <= last_section_) {
      diagnostics_.error(where(name.span),
                         fmt::format("the section '{}' must stand before '{}'", name.text,
                                     kSections[static_cast<std::size_t>(last_section_)]));
    }
    last_section_ = std::max(last_section_, order);
    take();
    if (!expect(":")) {
      skip_entry();
      return;
    }
    section_content(name.text);
  }

  void section_content(std::string_view name) {
    if (name == "infrastructure") {
      project_.infrastructure = class_name();
    } else if (name == "environment") {
      project_.environment = located_class();
    } else if (name == "executionControl") {
      project_.execution_control = located_class();
    } else if (name == "agents") {
      entries([this] { return agent(); });
    } else if (name == "directives") {
      entries([this] { return directive(); });
    } else if (name == "classpath") {
      entries([this] { return path_entry(project_.class_path); });
    } else {
      entries([this] { return path_entry(project_.asl_source_path); });
    }
  }

  // The entries from here to the next section, each with a semicolon.
  template <class Entry>
  void entries(Entry entry) {
    while (!is("}") && !is(ProjectTokenKind::end_of_text) && !begins_section()) {
      // A mistake costs its entry alone: the next one is read again.
      if (!entry() || !expect(";")) skip_entry();
    }
  }

  bool path_entry(std::vector<std::string>& paths) {
    const ProjectToken* const path = expect_kind(ProjectTokenKind::string, "a folder in quotes");
    if (path != nullptr) paths.push_back(string_content(path->text));
    return path != nullptr;
  }

  bool directive() {
    const ProjectToken* const name = expect_name("the name of a directive");
    if (name == nullptr || !expect("=")) return false;
    std::optional<ProjectClass> java = class_name();
    if (!java) return false;
    project_.directives.emplace_back(name->text, std::move(*java));
    return true;
  }

  std::optional<ProjectClass> located_class() {
    std::optional<ProjectClass> java = class_name();
    if (!java) {
      while (!is(ProjectTokenKind::end_of_text) && !is("}") && !begins_section()) take();
    } else if (take_if("at")) {
      expect_kind(ProjectTokenKind::string, "a host in quotes");
    }
    return java;
  }

  // A name with dots: `jason.bb.IndexedBB("student(key,_)")`.
  std::optional<ProjectClass> class_name() {
    const Span begin = next().span;
    if (!skip_dotted_name()) return std::nullopt;
    ProjectClass java;
    java.name = text_from(begin);
    if (take_if("(")) {
      do {
        if (is(")") && java.parameters.empty()) break;
        const Span parameter_begin = next().span;
        if (!skip_parameter(0)) return std::nullopt;
        java.parameters.push_back(text_from(parameter_begin));
      } while (take_if(","));
      if (!expect(")")) return std::nullopt;
    }
    java.where = where({begin.begin, tokens_[at_ - 1].span.end});
    return java;
  }

  [[nodiscard]] std::string text_from(Span begin) const {
    return std::string(source_->text({begin.begin, tokens_[at_ - 1].span.end}));
  }

  bool skip_dotted_name() {
    do {
      if (expect_kind(ProjectTokenKind::word, "the name of a class") == nullptr) return false;
    } while (take_if("."));
    return true;
  }

  bool skip_parameter(int depth) {
    constexpr int kDeepest = 50;
    if (depth > kDeepest) {
      diagnostics_.error(where(next().span), "parameters are nested too deeply");
      return false;
    }
    if (is(ProjectTokenKind::number) || is(ProjectTokenKind::string)) {
      take();
      return true;
    }
    if (take_if("[")) return skip_parameters("]", depth);
    if (!is(ProjectTokenKind::word)) {
      unexpected("a parameter");
      return false;
    }
    if (!skip_dotted_name()) return false;
    if (!take_if("(")) return true;
    return take_if(")") || skip_parameters(")", depth);
  }

  bool skip_parameters(std::string_view close, int depth) {
    do {
      if (!skip_parameter(depth + 1)) return false;
    } while (take_if(","));
    return expect(close);
  }

  bool agent() {
    const ProjectToken* const name = expect_name("the name of an agent");
    if (name == nullptr) return false;
    ProjectAgent agent;
    agent.name = name->text;
    agent.where = where(name->span);
    if (!agent_file(agent) || !agent_options(agent)) return false;
    while (!is(";")) {
      if (!agent_attribute(agent)) return false;
    }
    project_.agents.push_back(std::move(agent));
    return true;
  }

  // [ PATH ] ASID [ "." ASID ]
  bool agent_file(ProjectAgent& agent) {
    // Without a file the attributes follow at once; the file is then the agent's name.
    const bool is_attribute = is(ProjectTokenKind::word) && contains(kOtherReserved, next().text);
    if (!is(ProjectTokenKind::path) && (!is(ProjectTokenKind::word) || is_attribute)) return true;
    const Span begin = next().span;
    if (is(ProjectTokenKind::path)) take();
    if (expect_name("the name of a file") == nullptr) return false;
    if (is(ProjectTokenKind::path)) {
      unexpected("'.asl', '[' or ';'",
                 fmt::format("a file in a folder is written './{}...'", text_from(begin)));
      return false;
    }
    bool has_extension = false;
    if (take_if(".")) {
      if (expect_kind(ProjectTokenKind::word, "the extension of a file") == nullptr) return false;
      has_extension = true;
    }
    agent.file = text_from(begin) + (has_extension ? "" : ".asl");
    return true;
  }

  bool agent_options(ProjectAgent& agent) {
    if (!take_if("[")) return true;
    do {
      if (!agent_option(agent)) return false;
    } while (take_if(","));
    return expect("]");
  }

  bool agent_option(ProjectAgent& agent) {
    const ProjectToken* const name = expect_kind(ProjectTokenKind::word, "the name of an option");
    if (name == nullptr || !expect("=")) return false;
    const ProjectToken value = next();
    if (!is(ProjectTokenKind::word) && !is(ProjectTokenKind::number) &&
        !is(ProjectTokenKind::string)) {
      unexpected(fmt::format("the value of the option '{}'", name->text));
      return false;
    }
    take();
    ProjectOption option{.name = std::string(name->text),
                         .value = std::string(value.text),
                         .where = where(value.span)};
    if (value.kind == ProjectTokenKind::string) {
      option.value = string_content(value.text);
      option.where = where({value.span.begin + 1, value.span.end - 1});
    }
    check_option(option);
    agent.options.push_back(std::move(option));
    return true;
  }

  void check_option(const ProjectOption& option) {
    for (const auto& [name, values] : kClosedOptions) {
      if (option.name != name || contains(values, option.value)) continue;
      const std::vector<std::string> candidates(values.begin(), values.end());
      diagnostics_.error(option.where,
                         fmt::format("the option '{}' cannot be '{}'", name, option.value),
                         did_you_mean(option.value, candidates));
    }
    const bool needs_number = option.name == "verbose" || option.name == "nrcbp";
    if (needs_number && (option.value.empty() ||
                         option.value.find_first_not_of("0123456789") != std::string::npos)) {
      diagnostics_.error(option.where, fmt::format("the option '{}' must be a number, not '{}'",
                                                   option.name, option.value));
    }
  }

  bool agent_attribute(ProjectAgent& agent) {
    if (take_if("agentArchClass")) return (agent.arch_class = class_name()).has_value();
    if (take_if("agentClass")) return (agent.agent_class = class_name()).has_value();
    if (take_if("beliefBaseClass")) return (agent.belief_base_class = class_name()).has_value();
    if (take_if("#")) return agent_count(agent);
    if (take_if("at")) {
      const ProjectToken* const host = expect_kind(ProjectTokenKind::string, "a host in quotes");
      if (host != nullptr) agent.at = string_content(host->text);
      return host != nullptr;
    }
    // A misspelt attribute looks like the name of a file.
    const std::vector<std::string> names = {"agentArchClass", "agentClass", "beliefBaseClass"};
    const std::string hint = did_you_mean(next().text, names);
    unexpected("';'", hint.empty() ? did_you_mean(tokens_[at_ - 1].text, names) : hint);
    return false;
  }

  bool agent_count(ProjectAgent& agent) {
    const ProjectToken* const number =
        expect_kind(ProjectTokenKind::number, "the number of agents");
    if (number == nullptr) return false;
    const std::string_view text = number->text;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), agent.count);
    if (code == std::errc() && end == text.data() + text.size() && agent.count > 0) {
      std::int64_t all = agent.count;
      for (const ProjectAgent& other : project_.agents) all += other.count;
      if (all > kMostProjectAgents) {
        diagnostics_.error(where(number->span),
                           fmt::format("{} agents, more than {}", all, kMostProjectAgents));
      }
      return true;
    }
    diagnostics_.error(where(number->span), fmt::format("'{}' is not a number of agents", text));
    return true;
  }

  const SourcePtr& source_;
  Diagnostics& diagnostics_;
  std::vector<ProjectToken> tokens_;
  std::size_t at_ = 0;
  int last_section_ = -1;
  Project project_;
};

}  // namespace

std::string string_content(std::string_view quoted) {
  std::string value;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\' && quoted[i + 1] == '"') continue;
    value += quoted[i];
  }
  return value;
}

std::optional<Project> parse_project(SourcePtr source, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  Project project = ProjectParser(source, diagnostics).run();
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  return project;
}

}  // namespace jaywalk
