// SPDX-License-Identifier: Apache-2.0
#include "env/config/parameter_settings.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <optional>

#include <fmt/format.h>

namespace jaywalk {
namespace {

// `1/11` is a number, too.
std::optional<double> parse_fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_number(text);
  const std::optional<double> above = parse_number(text.substr(0, slash));
  const std::optional<double> below = parse_number(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

bool read_value(const ConfigNode& node, const ConfigReader& reader,
                std::vector<ParameterValue>& values) {
  const bool scalar = node.kind == ConfigNode::Kind::scalar;
  if (scalar && (node.text == "true" || node.text == "false")) {
    reader.unexpected(node, "a number or an atom", "true and false are no terms in AgentSpeak");
    return false;
  }
  if (const auto value = scalar ? parse_fraction(node.text) : std::nullopt) {
    values.emplace_back(*value);
  } else if (scalar && is_atom(node.text)) {
    values.emplace_back(node.text);
  } else {
    reader.unexpected(node, "a number (15, 0.5, 1/11) or an atom (back)");
    return false;
  }
  return true;
}

bool read_values(const ConfigNode& node, const ConfigReader& reader,
                 std::vector<ParameterValue>& values) {
  if (node.kind == ConfigNode::Kind::list) {
    return std::all_of(node.items.begin(), node.items.end(),
                       [&](const ConfigNode& item) { return read_value(item, reader, values); });
  }
  return read_value(node, reader, values);
}

/// Where a world's installed behaviours are. Copies cannot be listed, so that the folders have
/// names.
std::array<std::string, 2> behaviour_folders(std::string_view world) {
  const std::string folder = fmt::format("{}{}", kLibraryPrefix, world);
  return {folder, folder + "/specialists"};
}

}  // namespace

bool is_atom(std::string_view text) {
  if (text.empty() || std::islower(static_cast<unsigned char>(text[0])) == 0) return false;
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

void read_parameters(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<ParameterSetting>& settings) {
  if (node.kind != ConfigNode::Kind::map) {
    reader.unexpected(node, "names of beliefs and their values, {radius: 15}");
    return;
  }
  for (const ConfigEntry& entry : node.entries) {
    ParameterSetting setting{entry.key, {}, entry.origin};
    if (!is_atom(entry.key)) {
      reader.error(entry.origin,
                   fmt::format("expected the name of a belief, found '{}'", entry.key));
      continue;
    }
    if (!read_values(entry.value, reader, setting.values)) continue;
    std::erase_if(settings, [&](const ParameterSetting& old) { return old.name == entry.key; });
    settings.push_back(std::move(setting));
  }
}

std::string path_in(const std::string& folder, const std::string& path) {
  if (path.starts_with(kLibraryPrefix)) return path;
  return (std::filesystem::path(folder) / path).lexically_normal().generic_string();
}

std::vector<std::string> installed_behaviours(std::string_view world, const SourceFiles& files) {
  std::vector<std::string> paths;
  for (const std::string& folder : behaviour_folders(world)) {
    std::ranges::move(files.installed_in(folder), std::back_inserter(paths));
  }
  std::ranges::sort(paths, {}, [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  });
  return paths;
}

std::string installed_behaviour(std::string_view world, std::string_view name,
                                const SourceFiles& files) {
  const std::array folders = behaviour_folders(world);
  const auto path_below = [&](const std::string& folder) {
    return fmt::format("{}/{}.asl", folder, name);
  };
  const auto found = std::ranges::find_if(
      folders, [&](const std::string& folder) { return files.has(path_below(folder)); });
  return path_below(found == folders.end() ? folders.front() : *found);
}

std::string program_path(const std::string& folder, const std::string& text, std::string_view world,
                         const SourceFiles& files) {
  if (text.ends_with(".asl") || text.find('/') != std::string::npos) return path_in(folder, text);
  return installed_behaviour(world, text, files);
}

}  // namespace jaywalk
