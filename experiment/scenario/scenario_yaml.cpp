// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/scenario_yaml.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace jaywalk {
namespace {

// yaml-cpp counts lines and columns from 0, columns in bytes.
SourceSpan span_of(const SourcePtr& source, const YAML::Mark& mark, std::size_t length) {
  const std::string_view text = source->text();
  std::size_t begin = 0;
  for (int line = 0; line < mark.line; ++line) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) break;
    begin = end + 1;
  }
  begin = std::min(begin + static_cast<std::size_t>(std::max(mark.column, 0)), text.size());
  const std::size_t end = std::min(begin + length, text.size());
  return {source, {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}};
}

ConfigNode::Kind kind_of(const YAML::Node& node) {
  if (node.IsScalar()) return ConfigNode::Kind::scalar;
  if (node.IsSequence()) return ConfigNode::Kind::list;
  if (node.IsMap()) return ConfigNode::Kind::map;
  return ConfigNode::Kind::null;
}

// yaml-cpp's sentences, as ours: without a capital and a final stop.
std::string as_message(std::string text) {
  while (text.ends_with('.')) text.pop_back();
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] + 32);
  return text;
}

/// A frequent mistake in YAML, and why YAML reads it otherwise than it was meant.
struct Slip {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string message;
  std::string hint;
};

bool is_key_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == '-';
}

// `length:60`: the length of the key, if a text is of that form, as far as its first blank.
std::size_t glued_key(std::string_view text) {
  std::size_t key = 0;
  while (key < text.size() && is_key_character(text[key])) ++key;
  const bool glued = key > 0 && key + 1 < text.size() && text[key] == ':' &&
                     std::string_view(" \t\r\n/").find(text[key + 1]) == std::string_view::npos;
  return glued ? key : 0;
}

Slip glued_slip(std::string_view text, std::size_t begin, std::size_t key) {
  const std::size_t end = std::min(text.find_first_of(" \t\r\n,}", begin + key), text.size());
  return {begin, end, "expected a blank behind the ':' of a key",
          fmt::format("write '{}: {}'", text.substr(begin, key),
                      text.substr(begin + key + 1, end - begin - key - 1))};
}

// In a line of a text that is no YAML.
std::optional<Slip> slip_in(std::string_view text, std::size_t begin) {
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  const std::size_t first = std::min(text.find_first_not_of(" \t-", begin), end);
  const std::size_t tab = text.find('\t', begin);
  if (tab < first) {
    return Slip{tab, tab + 1, "a tab in the indentation", "YAML wants blanks there"};
  }
  const std::size_t key = glued_key(text.substr(first, end - first));
  if (key == 0) return std::nullopt;
  return glued_slip(text, first, key);
}

// The nearest one at or shortly above the line, from 0, in which yaml-cpp noticed the trouble.
std::optional<Slip> slip_above(std::string_view text, int line) {
  constexpr int kLinesAbove = 2;
  std::optional<Slip> slip;
  std::size_t begin = 0;
  for (int i = 0; i <= line && begin < text.size(); ++i) {
    if (i + kLinesAbove >= line) {
      if (auto found = slip_in(text, begin)) slip = std::move(found);
    }
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) break;
    begin = end + 1;
  }
  return slip;
}

/// Copies yaml-cpp's nodes; an option's text has no lines and columns worth naming.
class Converter {
 public:
  Converter(SourcePtr source, std::string option, Diagnostics& diagnostics)
      : source_(std::move(source)), option_(std::move(option)), diagnostics_(diagnostics) {}

  [[nodiscard]] ValueOrigin origin(const YAML::Mark& mark, std::size_t length) const {
    if (!option_.empty()) return {{}, option_};
    return {span_of(source_, mark, std::max<std::size_t>(length, 1)), {}};
  }

  void report_slip(Slip slip) {
    diagnostics_.error(
        {source_, {static_cast<std::uint32_t>(slip.begin), static_cast<std::uint32_t>(slip.end)}},
        std::move(slip.message), std::move(slip.hint));
  }

  // Reports the error in a text that yaml-cpp refuses.
  void report_failure(const YAML::Exception& error) {
    auto slip = source_ == nullptr ? std::nullopt : slip_above(source_->text(), error.mark.line);
    if (slip) {
      report_slip(std::move(*slip));
    } else {
      report(diagnostics_, origin(error.mark, 1), as_message(error.msg));
    }
  }

  ConfigNode convert(const YAML::Node& node, int depth) {
    ConfigNode result;
    result.kind = kind_of(node);
    if (result.kind == ConfigNode::Kind::scalar) result.text = node.Scalar();
    result.origin = origin(node.Mark(), result.text.size());
    if (!within_limits(result, depth)) return result;
    if (result.kind == ConfigNode::Kind::scalar && begins_line(result.origin)) {
      look_for_glued_key(result.origin);
    }
    if (result.kind == ConfigNode::Kind::list) {
      for (const YAML::Node& item : node) result.items.push_back(convert(item, depth + 1));
    } else if (result.kind == ConfigNode::Kind::map) {
      convert_entries(node, depth, result);
    }
    return result;
  }

 private:
  bool within_limits(const ConfigNode& node, int depth) {
    if (refused_) return false;
    if (++values_ > kMaxConfigValues) {
      report(diagnostics_, node.origin, fmt::format("more than {} values", kMaxConfigValues),
             "an alias counts as often as it is used");
      refused_ = true;
    } else if (depth > kMaxConfigDepth) {
      report(diagnostics_, node.origin,
             fmt::format("nested more than {} levels deep", kMaxConfigDepth));
      refused_ = true;
    }
    return !refused_;
  }

  void convert_entries(const YAML::Node& node, int depth, ConfigNode& result) {
    for (const auto& entry : node) {
      if (refused_) return;
      const YAML::Node& key = entry.first;
      if (!key.IsScalar()) {
        report(diagnostics_, origin(key.Mark(), 1), "a key is a single word or number");
        continue;
      }
      const ValueOrigin where = origin(key.Mark(), key.Scalar().size());
      if (entry.second.IsNull() && look_for_glued_key(where)) continue;
      if (result.find(key.Scalar()) != nullptr) {
        report(diagnostics_, where, fmt::format("the key '{}' is given twice", key.Scalar()));
        continue;
      }
      result.entries.push_back({key.Scalar(), where, convert(entry.second, depth + 1)});
    }
  }

  // A text that stands alone on its line, `length:60`, was meant as an entry.
  [[nodiscard]] static bool begins_line(const ValueOrigin& origin) {
    if (origin.where.source == nullptr) return false;
    const std::string_view before = origin.where.source->text().substr(0, origin.where.span.begin);
    const std::size_t last = before.find_last_not_of(' ');
    return last == std::string_view::npos || before[last] == '\n';
  }

  bool look_for_glued_key(const ValueOrigin& origin) {
    if (origin.where.source == nullptr) return false;
    const std::string_view text = origin.where.source->text();
    const std::size_t begin = origin.where.span.begin;
    const std::size_t key = glued_key(text.substr(begin, text.find('\n', begin) - begin));
    if (key == 0) return false;
    report_slip(glued_slip(text, begin, key));
    return true;
  }

  SourcePtr source_;
  std::string option_;
  Diagnostics& diagnostics_;
  std::size_t values_ = 0;
  bool refused_ = false;
};

/// Notes where the documents of a text begin.
class DocumentStarts : public YAML::EventHandler {
 public:
  std::vector<YAML::Mark> marks;

  void OnDocumentStart(const YAML::Mark& mark) override { marks.push_back(mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

// Where the first documents begin, two at most. yaml-cpp's own LoadAll never ends on a text such as
// `, a`, which it takes for documents without end that all begin at the same place.
std::vector<YAML::Mark> document_starts(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStarts starts;
  while (starts.marks.size() < 2 && parser.HandleNextDocument(starts)) {
  }
  return std::move(starts.marks);
}

std::optional<ConfigNode> convert_text(const std::string& text, Converter& converter,
                                       Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  try {
    const std::vector<YAML::Mark> starts = document_starts(text);
    if (starts.empty()) return ConfigNode{};
    if (starts.size() > 1) {
      const bool stuck = starts[1].pos == starts[0].pos;
      report(diagnostics, converter.origin(starts[1], 1),
             stuck ? "expected keys and values" : "a second document, only one is expected");
      return std::nullopt;
    }
    ConfigNode result = converter.convert(YAML::Load(text), 0);
    if (diagnostics.error_count() > errors) return std::nullopt;
    return result;
  } catch (const YAML::Exception& error) {
    converter.report_failure(error);
    return std::nullopt;
  }
}

bool is_path(std::string_view path) {
  return !path.empty() && !path.starts_with('.') && !path.ends_with('.') &&
         path.find("..") == std::string_view::npos;
}

}  // namespace

std::optional<ConfigNode> parse_config(const SourcePtr& source, Diagnostics& diagnostics) {
  Converter converter(source, {}, diagnostics);
  return convert_text(std::string(source->text()), converter, diagnostics);
}

std::optional<ConfigNode> parse_setting(const std::string& setting, Diagnostics& diagnostics,
                                        const SourcePtr& value) {
  const std::string option =
      value == nullptr ? fmt::format("--set {}", setting) : std::string(value->name());
  const std::size_t equals = setting.find('=');
  const std::string path = setting.substr(0, equals);
  if (equals == std::string::npos || !is_path(path)) {
    diagnostics.error(option, "expected KEY=VALUE, the key a dotted path",
                      "for example --set world.av.speed=8");
    return std::nullopt;
  }
  Converter converter(value, value == nullptr ? option : std::string(), diagnostics);
  std::optional<ConfigNode> node = convert_text(setting.substr(equals + 1), converter, diagnostics);
  if (!node) return std::nullopt;
  node->origin.option = option;
  // From the innermost key outwards.
  for (std::size_t end = path.size();;) {
    const std::size_t dot = path.rfind('.', end - 1);
    const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
    ConfigNode outer;
    outer.kind = ConfigNode::Kind::map;
    outer.origin.option = option;
    outer.entries.push_back({path.substr(begin, end - begin), {{}, option}, std::move(*node)});
    node = std::move(outer);
    if (begin == 0) return node;
    end = dot;
  }
}

}  // namespace jaywalk
