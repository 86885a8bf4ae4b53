// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/input_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/scenario/scenario.h"
#include "experiment/scenario/scenario_yaml.h"
#include "interpreter/support/input/missing_file.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/shipped.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

bool ends_with_one_of(std::string_view name, std::span<const std::string_view> endings) {
  return std::ranges::any_of(endings, [name](auto ending) { return name.ends_with(ending); });
}

// Adds the folder's files; returns the system's message if that fails.
std::string add_files(const std::string& folder, std::span<const std::string_view> endings,
                      std::vector<std::string>& files) {
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, failure);
  for (const fs::recursive_directory_iterator end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) {
      entry.disable_recursion_pending();
    } else if (ends_with_one_of(name, endings) && entry->is_regular_file(ignored)) {
      files.push_back(entry->path().string());
    }
  }
  return failure ? failure.message() : std::string();
}

struct KindText {
  std::string_view name;
  /// A hint on what to do with such a file; {} stands for its path.
  std::string_view use;
};

/// In the order of InputKind.
constexpr std::array<KindText, 6> kTexts = {{
    {"a program of agents (.asl)",
     "`jaywalk run {0}` runs it; `jaywalk compare SCENARIO.yaml --behaviours {0}` compares it with "
     "others"},
    {"a project of agents (.mas2j)", "`jaywalk run {0}` runs it"},
    {"a scenario (.yaml)",
     "`jaywalk run {0}` runs one of its tests, `jaywalk compare {0}` compares its behaviours"},
    {"an experiment of searches (.yaml with 'sut')", "`jaywalk search {0}` runs it"},
    {"a list of assertions (.yaml)",
     "`jaywalk compare SCENARIO.yaml --assertions {0}` judges tests by it"},
    {"a store (.gpkg)",
     "`jaywalk report {0}` shows what it has; judge, replay, explain, coverage "
     "and export take stores, too"},
}};

const KindText& text_of(InputKind kind) { return kTexts[static_cast<std::size_t>(kind)]; }

bool begins_as_a_store(const std::string& path) {
  constexpr std::string_view kBegin = "SQLite format 3";
  std::array<char, kBegin.size()> begin{};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), begin.size()) == kBegin;
}

/// Nothing of a text that is no YAML, or has none of the keys that tell.
std::optional<InputKind> kind_of_yaml(const std::string& path) {
  const auto source = read_source(path, kMaxScenarioBytes);
  if (!source.ok()) return std::nullopt;
  Diagnostics ignored;
  const std::optional<ConfigNode> root = parse_config(source.value(), ignored);
  if (!root) return std::nullopt;
  if (root->find("sut") != nullptr) return InputKind::search;
  for (const std::string_view key : {"world", "behaviours", "experiment", "preset"}) {
    if (root->find(key) != nullptr) return InputKind::scenario;
  }
  const ConfigNode* const assertions = root->find("assertions");
  const bool listed = assertions != nullptr && assertions->kind == ConfigNode::Kind::list;
  return listed ? std::optional(InputKind::assertions) : std::nullopt;
}

/// The kind of a file by its name or content; nothing if neither shows it.
std::optional<InputKind> kind_of(const std::string& path) {
  if (path.ends_with(".asl")) return InputKind::program;
  if (path.ends_with(".mas2j")) return InputKind::project;
  if (is_scenario_file(path)) return kind_of_yaml(path);
  return begins_as_a_store(path) ? std::optional(InputKind::store) : std::nullopt;
}

}  // namespace

bool expand_folders(std::span<const std::string> operands,
                    std::span<const std::string_view> endings, Console& console,
                    std::vector<std::string>& files) {
  bool all = true;
  for (const std::string& operand : operands) {
    std::error_code ignored;
    if (!fs::is_directory(operand, ignored)) {
      files.push_back(operand);
      continue;
    }
    const std::size_t before = files.size();
    const std::string failure = add_files(operand, endings, files);
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    if (!failure.empty()) {
      console.error(fmt::format("{}: cannot be read: {}", operand, failure));
      all = false;
    } else if (files.size() == before) {
      console.error(fmt::format("{}: no file {} lies there", operand, fmt::join(endings, " or ")));
      all = false;
    }
  }
  return all;
}

std::optional<std::string> input_file(const std::string& word, std::span<const InputKind> wanted,
                                      Diagnostics& diagnostics) {
  if (word.starts_with(kLibraryPrefix)) return word;  // found by SourceFiles
  const std::string path = located(word);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    diagnostics.error(word, "no such file", hint_for_missing(path, shipped_folder()));
    return std::nullopt;
  }
  // A pipe can be read only once.
  if (!fs::is_regular_file(path, ignored)) return path;
  const auto kind = kind_of(path);
  if (!kind || std::ranges::find(wanted, *kind) != wanted.end()) return path;
  std::vector<std::string_view> names;
  for (const InputKind each : wanted) names.push_back(text_of(each).name);
  diagnostics.error(
      word, fmt::format("expected {}, found {}", fmt::join(names, " or "), text_of(*kind).name),
      fmt::format(fmt::runtime(text_of(*kind).use), word));
  return std::nullopt;
}

std::vector<std::string> input_files(std::span<const std::string> words,
                                     std::span<const InputKind> wanted, Diagnostics& diagnostics) {
  std::vector<std::string> files;
  for (const std::string& word : words) {
    if (auto file = input_file(word, wanted, diagnostics)) files.push_back(std::move(*file));
  }
  return files;
}

std::optional<std::string> only_input(const Arguments& arguments, std::string_view command,
                                      std::string_view what, std::span<const InputKind> wanted,
                                      Diagnostics& diagnostics) {
  const std::vector<std::string>& operands = arguments.operands();
  if (operands.size() == 1) return input_file(operands.front(), wanted, diagnostics);
  diagnostics.error(std::string(command),
                    fmt::format("expected one {}, found {}", what, operands.size()),
                    fmt::format("jaywalk {} --help shows how to write it", command));
  return std::nullopt;
}

}  // namespace jaywalk
