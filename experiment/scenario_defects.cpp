// Defects of the AV as scenarios name them.

#include <algorithm>

#include <fmt/format.h>

#include "env/vehicle/defects.h"
#include "experiment/scenario_layer.h"

namespace jaywalk {
namespace {

/// What stands between commas.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = std::min(text.find(','), text.size());
    parts.push_back(text.substr(0, end));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Every row with each of the severities that it is measured with.
std::vector<VehicleDefect> all_defects() {
  std::vector<VehicleDefect> all;
  for (const DefectModel& model : defect_models()) {
    for (const double severity : model.severities) {
      all.push_back({std::string(model.name), severity});
    }
  }
  return all;
}

}  // namespace

std::optional<VehicleDefect> read_defect(const ConfigNode& node, const ConfigReader& reader) {
  const auto text = reader.text(node, "a defect as latency or latency=0.6, or a list of them");
  if (!text) return std::nullopt;
  if (auto defect = parse_defect(*text)) return defect;
  const std::string name = text->substr(0, text->find('='));
  if (const DefectModel* const model = find_defect(name)) {
    const std::string expected =
        model->unit.empty() ? fmt::format("'{}' alone, it has no severity", name)
                            : fmt::format("'{}=' and a positive number of {}{}", name, model->unit,
                                          model->unit == "%" ? " up to 100" : "");
    reader.unexpected(node, expected);
    return std::nullopt;
  }
  std::vector<std::string> names;
  for (const DefectModel& model : defect_models()) names.emplace_back(model.name);
  std::string hint = did_you_mean(name, names);
  if (hint.empty()) hint = "`jaywalk list defects` shows them";
  reader.error(node.origin, fmt::format("unknown defect '{}'", name), std::move(hint));
  return std::nullopt;
}

std::vector<VehicleDefect> read_defect_list(const ConfigNode& node, const ConfigReader& reader) {
  std::vector<VehicleDefect> defects;
  if (node.kind == ConfigNode::Kind::scalar && node.text == "all") return all_defects();
  std::vector<ConfigNode> items;
  if (node.kind == ConfigNode::Kind::list) {
    items = node.items;
  } else if (node.kind == ConfigNode::Kind::scalar) {
    for (const std::string_view text : parts_of(node.text)) {
      items.push_back(node);
      items.back().text = text;
    }
  } else {
    reader.unexpected(node, "all, or a list of defects as [latency, short-range=12]");
  }
  for (const ConfigNode& item : items) {
    const auto defect = read_defect(item, reader);
    if (!defect) continue;
    if (std::ranges::find(defects, *defect) == defects.end()) {
      defects.push_back(*defect);
    } else {
      reader.error(item.origin, fmt::format("a second '{}'", text_of(*defect)));
    }
  }
  return defects;
}

}  // namespace jaywalk
