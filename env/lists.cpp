// SPDX-License-Identifier: Apache-2.0
#include "env/environments.h"
#include "env/vehicle/defects.h"
#include "env/vehicle/vehicle.h"
#include <jaywalk/world.h>

namespace jaywalk {

std::vector<WorldInfo> world_list() {
  std::vector<WorldInfo> worlds;
  for (const EnvironmentKind& kind : environments()) {
    WorldInfo& world = worlds.emplace_back();
    world.name = kind.name;
    world.summary = kind.summary;
    world.percepts = kind.percepts;
    world.actions = kind.actions;
    for (const Preset& preset : kind.presets)
      world.presets.push_back({preset.name, preset.summary});
  }
  return worlds;
}

std::vector<NamedOption> vehicle_model_list() {
  std::vector<NamedOption> models;
  for (const VehicleModel& model : vehicle_models()) models.push_back({model.name, model.summary});
  return models;
}

std::vector<DefectInfo> defect_list() {
  std::vector<DefectInfo> defects;
  for (const DefectModel& defect : defect_models()) {
    defects.push_back({.name = defect.name,
                       .summary = defect.summary,
                       .source = defect.source,
                       .unit = defect.unit,
                       .severities = defect.severities});
  }
  return defects;
}

}  // namespace jaywalk
