// SPDX-License-Identifier: Apache-2.0
// Defects of the AV as scenarios name them.

#include <algorithm>

#include <fmt/format.h>

#include "env/vehicle/defects.h"
#include "env/vehicle/vehicle_section.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

/// Where a part of the node's text stands, if the text was written as it is read (not quoted, say).
ValueOrigin origin_of_part(const ConfigNode& node, std::string_view part, std::size_t offset) {
  ValueOrigin origin = node.origin;
  if (!origin.where.source) return origin;
  Span& span = origin.where.span;
  if (!origin.where.source->text().substr(span.begin).starts_with(node.text)) return origin;
  span.begin += static_cast<std::uint32_t>(offset);
  span.end = span.begin + static_cast<std::uint32_t>(part.size());
  return origin;
}

/// The texts between commas.
std::vector<ConfigNode> parts_of(const ConfigNode& node) {
  const std::string_view text = node.text;
  std::vector<ConfigNode> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = trimmed(text.substr(begin, end - begin));
    const std::size_t offset =
        part.empty() ? begin : static_cast<std::size_t>(part.data() - text.data());
    parts.push_back(node);
    parts.back().text = part;
    parts.back().origin = origin_of_part(node, part, offset);
    if (end == text.size()) return parts;
    begin = end + 1;
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
    items = parts_of(node);
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
