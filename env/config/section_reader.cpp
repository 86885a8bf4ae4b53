// SPDX-License-Identifier: Apache-2.0
#include "env/config/section_reader.h"

#include <filesystem>

#include "env/config/parameter_settings.h"

namespace jaywalk {

ValueOrigin origin_of(const ValueOrigins& origins, std::string path, std::string_view scenario) {
  while (true) {
    const auto found = origins.find(path);
    if (found != origins.end()) return found->second;
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {{}, std::string(scenario)};
    path.resize(dot);
  }
}

std::optional<std::vector<std::string>> read_command_words(const ConfigNode& node,
                                                           const SectionContext& context,
                                                           const ConfigReader& reader) {
  std::vector<std::string> command;
  if (node.kind != ConfigNode::Kind::list || node.items.empty()) {
    reader.unexpected(node, "a program and its arguments as [python3, controller.py]");
    return std::nullopt;
  }
  for (const ConfigNode& item : node.items) {
    const auto word = reader.text(item, "a word of a command");
    if (!word) return std::nullopt;
    std::string beside = path_in(context.folder, *word);
    // Without a slash a program would be looked for as the shell does.
    if (beside.find('/') == std::string::npos) beside.insert(0, "./");
    std::error_code ignored;
    const bool found =
        context.files.has(beside) || std::filesystem::is_regular_file(beside, ignored);
    command.push_back(found ? beside : *word);
  }
  return command;
}

}  // namespace jaywalk
