// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/vehicle_section.h"

#include <algorithm>

#include <fmt/format.h>

#include "env/config/reader.h"
#include "env/simulator/simulator.h"
#include "env/vehicle/defects.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

constexpr NumberRange kMetresFar{0, 1e6};
constexpr NumberRange kStandoff{0, 100};
constexpr NumberRange kAcceleration{0.01, 100};

// An external controller has its own reaction and brakes as it likes.
void check_external(const SectionContext& context) {
  for (const char* key : {"reaction", "deceleration", "acceleration", "standoff"}) {
    const auto given = context.origins.find(fmt::format("world.av.{}", key));
    if (given == context.origins.end()) continue;
    report(context.diagnostics, given->second,
           fmt::format("'{}' has no meaning for the model external", key),
           "it is for the program to decide; what a vehicle can do limits its answers");
  }
}

void check_command(const VehicleParameters& vehicle, const std::string& path,
                   const std::string& scenario, const SectionContext& context) {
  if (vehicle.model != "external" || !vehicle.command.empty()) return;
  if (context.origins.contains(path + ".command")) return;  // already diagnosed
  report(context.diagnostics, origin_of(context.origins, path + ".model", scenario),
         "no 'command' to start the controller with",
         "for example command: [python3, controller.py]");
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

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

void VehicleSection::add_keys(VehicleParameters& vehicle, std::optional<VehicleParameters>& twin,
                              std::vector<ConfigKey>& keys) {
  keys.insert(
      keys.end(),
      {
          {"model", [&, this](const ConfigNode& value,
                              const std::string& key) { read_model(value, key, vehicle); }},
          {"reaction", optional_number(vehicle.reaction_s, kWindow)},
          {"deceleration", optional_number(vehicle.deceleration_mps2, kAcceleration)},
          {"acceleration", number(vehicle.acceleration_mps2, kAcceleration)},
          {"range", number(vehicle.range_m, kMetresFar)},
          {"standoff", number(vehicle.standoff_m, kStandoff)},
          {"period", number(vehicle.period_s, kWindow)},
          {"command", [&, this](const ConfigNode& value,
                                const std::string& key) { read_command(value, key, vehicle); }},
          {"process", choice<bool>(vehicle.keeps_process, {{"test", false}, {"kept", true}})},
          {"defect", [&, this](const ConfigNode& value,
                               const std::string& key) { read_defects(value, key, vehicle); }},
          {"twin", [&, this](const ConfigNode& value,
                             const std::string& key) { read_twin(value, key, twin); }},
      });
}

void VehicleSection::read_model(const ConfigNode& node, const std::string& path,
                                VehicleParameters& vehicle) {
  note_origin(node, path);
  const std::optional<std::string> name = reader_.text(node, "how the AV drives");
  if (!name) return;
  if (find_vehicle_model(*name) != nullptr) {
    vehicle.model = *name;
    return;
  }
  std::vector<std::string> names;
  for (const VehicleModel& model : vehicle_models()) names.emplace_back(model.name);
  reader_.error(node.origin, fmt::format("unknown model '{}' of the AV", *name),
                did_you_mean(*name, names));
}

// One defect or a list of them, which replaces the former list.
void VehicleSection::read_defects(const ConfigNode& node, const std::string& path,
                                  VehicleParameters& vehicle) {
  note_origin(node, path);
  std::vector<VehicleDefect> defects;
  const bool is_list = node.kind == ConfigNode::Kind::list;
  if (is_list && node.items.size() > kMaxItems) {
    reader_.unexpected(node, fmt::format("{} defects at most", kMaxItems));
    return;
  }
  for (const ConfigNode& item : is_list ? node.items : std::vector{node}) {
    if (auto defect = read_defect(item, reader_)) defects.push_back(std::move(*defect));
  }
  vehicle.defects = std::move(defects);
}

// A model, a command, or some of the keys that say how an AV drives.
void VehicleSection::read_twin(const ConfigNode& node, const std::string& path,
                               std::optional<VehicleParameters>& target) {
  note_origin(node, path);
  VehicleParameters twin;
  if (node.kind == ConfigNode::Kind::list) {
    twin.model = "external";
    read_command(node, path, twin);
  } else if (node.kind == ConfigNode::Kind::scalar) {
    read_model(node, path, twin);
  } else {
    if (target) twin = *target;
    read_twin_keys(node, path, twin);
  }
  target = std::move(twin);
}

void VehicleSection::read_twin_keys(const ConfigNode& node, const std::string& path,
                                    VehicleParameters& twin) {
  if (node.kind != ConfigNode::Kind::map) {
    reader_.unexpected(node, "the healthy twin: a model, a command or keys and values");
    return;
  }
  read_keys(node, path,
            {
                {"model", [&](const ConfigNode& value,
                              const std::string& key) { read_model(value, key, twin); }},
                {"reaction", optional_number(twin.reaction_s, kWindow)},
                {"deceleration", optional_number(twin.deceleration_mps2, kAcceleration)},
                {"acceleration", number(twin.acceleration_mps2, kAcceleration)},
                {"standoff", number(twin.standoff_m, kStandoff)},
                {"command", [&](const ConfigNode& value,
                                const std::string& key) { read_command(value, key, twin); }},
            });
}

void VehicleSection::read_command(const ConfigNode& node, const std::string& path,
                                  VehicleParameters& vehicle) {
  note_origin(node, path);
  auto command = read_command_words(node, context_, reader_);
  if (command) vehicle.command = *std::move(command);
}

void check_vehicle(const VehicleParameters& vehicle, const std::optional<VehicleParameters>& twin,
                   const std::string& scenario, const SectionContext& context) {
  if (vehicle.model == "external") check_external(context);
  check_command(vehicle, "world.av", scenario, context);
  if (twin) check_command(*twin, "world.av.twin", scenario, context);
}

void warn_of_speed(double mps, const std::string& path, std::string unit,
                   const SectionContext& context) {
  constexpr double kFastMps = 60;
  constexpr double kKmhInMps = 3.6;
  const auto given = context.origins.find(path);
  if (mps <= kFastMps || given == context.origins.end()) return;
  context.diagnostics.add(
      {.severity = Severity::warning,
       .message = fmt::format("the AV drives at {:.4g} m/s ({:.4g} km/h)", mps, mps * kKmhInMps),
       .where = given->second.where,
       .hint = std::move(unit),
       .code = {},
       .subject = given->second.option});
}

void check_defects(const VehicleParameters& vehicle, const std::optional<VehicleParameters>& twin,
                   std::vector<ParameterProblem>& found) {
  if (!vehicle.defects.empty() && vehicle.model == "constant") {
    found.push_back({"world.av.defect",
                     "the AV's model 'constant' does not brake, so that no defect of it shows"});
  }
  if (!twin) return;
  if (twin->model == "constant") {
    found.push_back({"world.av.twin",
                     "the model 'constant' does not brake, so that it is nobody's "
                     "healthy twin"});
  }
  if (vehicle.model == "constant") {
    found.push_back({"world.av.twin",
                     "the AV's model 'constant' does not brake, so that it has no healthy twin"});
  }
}

VehicleParameters healthy_twin(const VehicleParameters& vehicle,
                               const std::optional<VehicleParameters>& given) {
  VehicleParameters twin = given.value_or(vehicle);
  twin.defects.clear();
  twin.range_m = vehicle.range_m;
  twin.period_s = vehicle.period_s;
  twin.keeps_process = vehicle.keeps_process;
  return twin;
}

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
