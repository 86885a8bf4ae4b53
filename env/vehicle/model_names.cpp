// The models of the AV that an experiment compares: those of the world, or of its simulator.

#include <algorithm>

#include <fmt/format.h>

#include "env/simulator/simulator.h"
#include "env/vehicle/section.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

}  // namespace

std::vector<std::string> av_model_names(const SimulatorParameters& simulator) {
  std::vector<std::string> names;
  if (simulator.name.empty()) {
    for (const VehicleModel& model : vehicle_models()) {
      if (model.name != "external") names.emplace_back(model.name);
    }
    return names;
  }
  const SimulatorKind* const kind = find_simulator(simulator.name);
  if (kind == nullptr) return names;
  const auto key = std::ranges::find(kind->keys, kAvModelKey, &SettingKey::name);
  return key == kind->keys.end() ? names : words_of(key->words);
}

std::vector<std::string> read_av_list(const ConfigNode& node, const ConfigReader& reader) {
  std::vector<std::string> names;
  if (node.kind == ConfigNode::Kind::map) {
    reader.unexpected(node, "a list of the AV's models as [constant, Krauss]");
    return names;
  }
  for (const ConfigNode& item :
       node.kind == ConfigNode::Kind::list ? node.items : std::vector{node}) {
    const auto text = reader.text(item, "a model of the AV");
    if (!text) continue;
    std::string_view rest = *text;
    for (std::size_t begin = 0; begin <= rest.size();) {
      const std::size_t end = std::min(rest.find(',', begin), rest.size());
      std::string name(trimmed(rest.substr(begin, end - begin)));
      begin = end + 1;
      if (std::ranges::find(names, name) != names.end()) {
        reader.error(item.origin, fmt::format("a second '{}'", name));
      } else if (!name.empty()) {
        names.push_back(std::move(name));
      }
    }
  }
  return names;
}

}  // namespace jaywalk
