// SPDX-License-Identifier: Apache-2.0
// Assertions out of YAML.

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "env/config/parameter_settings.h"
#include "env/config/reader.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/judge/metrics/metrics.h"
#include "experiment/scenario/expression_node.h"
#include "experiment/scenario/scenario.h"
#include "experiment/scenario/scenario_yaml.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMaxAssertions = 200;
constexpr NumberRange kParameters{-1e9, 1e9};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The place of each byte of a scalar in the file: YAML folds lines and strips indentation, but
/// keeps every character that is not a blank. If it does not (an escape), all bytes get the place
/// where the scalar begins.
std::vector<std::uint32_t> places_of(const ConfigNode& node) {
  const std::string_view file = node.origin.where.source->text();
  const std::uint32_t begin = node.origin.where.span.begin;
  std::uint32_t at = begin;
  if (at < file.size() && (file[at] == '|' || file[at] == '>')) {
    while (at < file.size() && file[at] != '\n') ++at;
  } else if (at < file.size() && (file[at] == '"' || file[at] == '\'')) {
    ++at;
  }
  std::vector<std::uint32_t> places;
  for (const char c : node.text) {
    if (is_blank(c)) {
      places.push_back(std::min<std::uint32_t>(at, static_cast<std::uint32_t>(file.size())));
      if (at < file.size() && is_blank(file[at])) ++at;
      continue;
    }
    while (at < file.size() && is_blank(file[at])) ++at;
    if (at >= file.size() || file[at] != c) {
      return std::vector<std::uint32_t>(node.text.size(), begin);
    }
    places.push_back(at++);
  }
  return places;
}

class FileReader {
 public:
  explicit FileReader(Diagnostics& diagnostics) : diagnostics_(diagnostics), reader_(diagnostics) {}

  std::vector<Assertion> read(const ConfigNode& root) {
    const std::array keys = {
        ConfigKey{"assertions", [&](const ConfigNode& node, const std::string&) { list(node); }}};
    reader_.read_map(root, "", keys);
    if (root.kind == ConfigNode::Kind::map && root.find("assertions") == nullptr) {
      reader_.error(root.origin, "no assertions", "list them under 'assertions'");
    }
    return std::move(assertions_);
  }

 private:
  void list(const ConfigNode& node) {
    if (node.kind == ConfigNode::Kind::list && node.items.size() > kMaxAssertions) {
      reader_.error(node.origin,
                    fmt::format("expected at most {} assertions, found {}", kMaxAssertions,
                                node.items.size()),
                    "each test is judged by each of them, and the limit bounds what a file costs; "
                    "--assertions takes several files");
      return;
    }
    if (node.kind != ConfigNode::Kind::list || node.items.empty()) {
      reader_.unexpected(node, fmt::format("a list of 1 to {} assertions", kMaxAssertions));
      return;
    }
    for (const ConfigNode& item : node.items) read_one(item);
  }

  void read_one(const ConfigNode& node) {
    Assertion assertion;
    const std::size_t errors = diagnostics_.error_count();
    std::array<const ConfigNode*, 3> expressions{};
    const auto keep = [&](std::size_t which) {
      return [&expressions, which](const ConfigNode& value, const std::string&) {
        expressions[which] = &value;
      };
    };
    const std::array keys = {
        ConfigKey{"id", [&](const ConfigNode& value,
                            const std::string&) { read_id(value, assertion.id); }},
        ConfigKey{"summary", text_of(assertion.summary)},
        ConfigKey{"source", text_of(assertion.source)},
        ConfigKey{"severity", [&](const ConfigNode& value,
                                  const std::string&) { read_severity(value, assertion); }},
        ConfigKey{"parameters", [&](const ConfigNode& value,
                                    const std::string&) { read_parameters(value, assertion); }},
        ConfigKey{"precondition", keep(0)},
        ConfigKey{"requirement", keep(1)},
        ConfigKey{"unavoidable", keep(2)},
    };
    reader_.read_map(node, "", keys);
    if (node.kind != ConfigNode::Kind::map) return;
    for (const std::string_view needed : {"id", "source", "precondition", "requirement"}) {
      if (node.find(needed) == nullptr) {
        reader_.error(node.origin, fmt::format("an assertion without '{}'", needed));
      }
    }
    auto precondition = expression(expressions[0], assertion);
    auto requirement = expression(expressions[1], assertion);
    assertion.unavoidable = expression(expressions[2], assertion);
    if (diagnostics_.error_count() > errors) return;
    assertion.precondition = std::move(*precondition);
    assertion.requirement = std::move(*requirement);
    assertions_.push_back(std::move(assertion));
  }

  std::function<void(const ConfigNode&, const std::string&)> text_of(std::string& target) {
    return [this, &target](const ConfigNode& value, const std::string&) {
      if (auto text = reader_.text(value, "a text")) target = std::move(*text);
    };
  }

  void read_id(const ConfigNode& node, std::string& id) {
    const auto text = reader_.text(node, "a name");
    if (!text) return;
    if (!is_atom(*text)) {
      reader_.error(node.origin, fmt::format("'{}' cannot be the id of an assertion", *text),
                    "ids are atoms, so that agents can believe them: a lower-case letter, then "
                    "letters, digits and _");
    } else if (find_metric(*text) != nullptr) {
      reader_.error(node.origin, fmt::format("'{}' is the name of a metric", *text));
    } else if (!ids_.insert(*text).second) {
      reader_.error(node.origin, fmt::format("a second assertion with the id '{}'", *text));
    }
    id = *text;
  }

  void read_severity(const ConfigNode& node, Assertion& assertion) {
    static constexpr std::array kChoices = {
        Choice<AssertionSeverity>{"minor", AssertionSeverity::minor},
        Choice<AssertionSeverity>{"major", AssertionSeverity::major},
        Choice<AssertionSeverity>{"critical", AssertionSeverity::critical}};
    if (const auto value =
            reader_.choice(node, std::span<const Choice<AssertionSeverity>>(kChoices))) {
      assertion.severity = *value;
    }
  }

  void read_parameters(const ConfigNode& node, Assertion& assertion) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "names and numbers, {limit: 9}");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      const bool known = std::ranges::any_of(
          signals(), [&](const Signal& signal) { return signal.name == entry.key; });
      const bool valid = !entry.key.empty() && !known &&
                         std::isalpha(static_cast<unsigned char>(entry.key[0])) != 0 &&
                         std::ranges::all_of(entry.key, [](unsigned char c) {
                           return std::isalnum(c) != 0 || c == '_';
                         });
      if (!valid) {
        reader_.error(entry.origin,
                      known
                          ? fmt::format("'{}' is a signal already", entry.key)
                          : fmt::format("expected the name of a parameter, found '{}'", entry.key));
        continue;
      }
      // 0 if it is wrong, so that its uses are no mistakes of their own.
      assertion.parameters[entry.key] = reader_.number(entry.value, kParameters).value_or(0);
    }
  }

  std::optional<stl::Expression> expression(const ConfigNode* node, const Assertion& assertion) {
    if (node == nullptr) return std::nullopt;
    if (!reader_.text(*node, "a condition, as eventually ttc <= 1")) return std::nullopt;
    auto parsed = stl::parse(expression_text(*node), diagnostics_);
    if (!parsed) return std::nullopt;
    return stl::resolve(std::move(*parsed), signal_vocabulary(), assertion.parameters,
                        diagnostics_);
  }

  Diagnostics& diagnostics_;
  ConfigReader reader_;
  std::vector<Assertion> assertions_;
  std::set<std::string> ids_;
};

}  // namespace

stl::ExpressionText expression_text(const ConfigNode& node) {
  // An option has no lines and columns worth naming.
  if (node.origin.where.source == nullptr) {
    return {.text = node.text, .source = {}, .offsets = {}, .subject = node.origin.option};
  }
  return {.text = node.text,
          .source = node.origin.where.source,
          .offsets = places_of(node),
          .subject = {}};
}

Result<std::vector<Assertion>> parse_assertions(const SourcePtr& source) {
  Diagnostics diagnostics;
  const std::optional<ConfigNode> root = parse_config(source, diagnostics);
  std::vector<Assertion> assertions;
  if (root && root->kind == ConfigNode::Kind::null) {
    diagnostics.error(source->name(), "the file is empty",
                      "docs/reference/assertions.md describes what to write");
  } else if (root) {
    assertions = FileReader(diagnostics).read(*root);
  }
  if (diagnostics.has_errors()) {
    diagnostics.sort_by_place();
    return diagnostics;
  }
  return assertions;
}

Result<std::vector<Assertion>> read_assertions(const std::string& path) {
  Result<SourcePtr> source = read_source(path, kMaxScenarioBytes);
  if (!source.ok()) return std::move(source.diagnostics());
  return parse_assertions(source.value());
}

Result<AssertionFiles> read_assertion_files(const std::vector<std::string>& paths,
                                            const SourceFiles& files, SameId same_id) {
  AssertionFiles all;
  Diagnostics diagnostics;
  for (const std::string& path : paths) {
    auto source = files.read(path, kMaxScenarioBytes);
    auto more = source ? parse_assertions(source.value()) : std::move(source.diagnostics());
    if (!more) {
      diagnostics.append(std::move(more.diagnostics()));
      continue;
    }
    all.sources.push_back(source.value());
    for (Assertion& assertion : more.value()) {
      const auto earlier = std::ranges::find(all.assertions, assertion.id, &Assertion::id);
      if (earlier == all.assertions.end()) {
        all.assertions.push_back(std::move(assertion));
      } else if (same_id == SameId::replaced) {
        *earlier = std::move(assertion);
      } else {
        diagnostics.error(path, fmt::format("a second assertion with the id '{}'", assertion.id));
      }
    }
  }
  if (diagnostics.has_errors()) return diagnostics;
  return all;
}

}  // namespace jaywalk
