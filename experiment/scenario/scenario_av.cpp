// The automated vehicle: its body, its speed and how it drives.

#include <fmt/format.h>

#include "env/vehicle/defects.h"
#include "experiment/scenario/scenario_layer.h"
#include "experiment/scenario/scenario_ranges.h"

namespace jaywalk {
namespace {

constexpr NumberRange kMetresFar{0, 1e6};
constexpr NumberRange kStandoff{0, 100};
constexpr NumberRange kAcceleration{0.01, 100};

class AvReader : LayerPart {
 public:
  AvReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : LayerPart(folder, draft, diagnostics) {}

  void read_av(const ConfigNode& node, const std::string& path) {
    AvParameters& av = world().av;
    if (node.find("speed") != nullptr && node.find("speed_mps") != nullptr) {
      reader_.error(node.origin, "give either 'speed' or 'speed_mps'");
    }
    read_keys(
        node, path,
        {
            {"length", integer(av.length, kCells)},
            {"rows", interval(av.rows, kRows)},
            {"start", integer(av.start, kCellsFromAnywhere)},
            {"stopping_distance", integer(av.stopping_distance, {0, kCells.most})},
            {"carry_over", choice<bool>(av.carry_over, {{"true", true}, {"false", false}})},
            {"model", [&](const ConfigNode& value,
                          const std::string& key) { read_model(value, key, av.vehicle); }},
            {"reaction", optional_number(av.vehicle.reaction_s, kWindow)},
            {"deceleration", optional_number(av.vehicle.deceleration_mps2, kAcceleration)},
            {"acceleration", number(av.vehicle.acceleration_mps2, kAcceleration)},
            {"range", number(av.vehicle.range_m, kMetresFar)},
            {"standoff", number(av.vehicle.standoff_m, kStandoff)},
            {"period", number(av.vehicle.period_s, kWindow)},
            {"command", [&](const ConfigNode& value,
                            const std::string& key) { read_command(value, key, av.vehicle); }},
            {"process", choice<bool>(av.vehicle.keeps_process, {{"test", false}, {"kept", true}})},
            {"defect",
             [&](const ConfigNode& value, const std::string& key) { read_defects(value, key); }},
            {"twin",
             [&](const ConfigNode& value, const std::string& key) { read_twin(value, key); }},
            {"speed",
             [&](const ConfigNode& value, const std::string&) {
               if (const auto speed = reader_.number(value, kSpeed)) {
                 av.speed = *speed;
                 draft_.speed_mps.reset();
               }
             }},
            {"speed_mps",
             [&](const ConfigNode& value, const std::string&) {
               if (const auto speed = reader_.number(value, kSpeed)) {
                 draft_.speed_mps = *speed;
               }
             }},
        });
  }

 private:
  void read_model(const ConfigNode& node, const std::string& path, VehicleParameters& vehicle) {
    draft_.origins[path] = node.origin;
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

  // One defect or a list of them, which takes the place of what was there.
  void read_defects(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    std::vector<VehicleDefect> defects;
    const bool is_list = node.kind == ConfigNode::Kind::list;
    if (is_list && node.items.size() > kMaxItems) {
      reader_.unexpected(node, fmt::format("{} defects at most", kMaxItems));
      return;
    }
    for (const ConfigNode& item : is_list ? node.items : std::vector{node}) {
      if (auto defect = read_defect(item, reader_)) defects.push_back(std::move(*defect));
    }
    world().av.vehicle.defects = std::move(defects);
  }

  // A model, a command, or some of the keys that say how an AV drives.
  void read_twin(const ConfigNode& node, const std::string& path) {
    draft_.origins[path] = node.origin;
    VehicleParameters twin;
    if (node.kind == ConfigNode::Kind::list) {
      twin.model = "external";
      read_command(node, path, twin);
    } else if (node.kind == ConfigNode::Kind::scalar) {
      read_model(node, path, twin);
    } else {
      read_twin_keys(node, path, twin);
    }
    world().av.twin = std::move(twin);
  }

  void read_twin_keys(const ConfigNode& node, const std::string& path, VehicleParameters& twin) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "the healthy twin: a model, a command or keys and values");
      return;
    }
    if (world().av.twin) twin = *world().av.twin;
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

  void read_command(const ConfigNode& node, const std::string& path, VehicleParameters& vehicle) {
    draft_.origins[path] = node.origin;
    auto command = read_command_words(node, folder_, draft_.scenario.files, reader_);
    if (command) vehicle.command = *std::move(command);
  }
};

}  // namespace

void read_av(const ConfigNode& node, const std::string& path, const std::string& folder,
             ScenarioDraft& draft, Diagnostics& diagnostics) {
  AvReader(folder, draft, diagnostics).read_av(node, path);
}

}  // namespace jaywalk
