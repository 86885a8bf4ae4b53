#include "tools/jaywalk/scenario_options.h"

#include <utility>

#include "tools/jaywalk/shipped.h"

namespace jaywalk {

bool is_scenario_file(const std::string& path) {
  return path.ends_with(".yaml") || path.ends_with(".yml");
}

ScenarioOptions scenario_options(const Arguments& arguments, std::vector<std::string> behaviours) {
  // Programs may be installed ones, as scenarios may.
  for (std::string& behaviour : behaviours) {
    if (behaviour.ends_with(".asl")) behaviour = located(behaviour);
  }
  return {.preset = arguments.text("preset"),
          .sets = arguments.texts("set"),
          .behaviours = std::move(behaviours)};
}

std::shared_ptr<const PreparedScenario> prepare_scenario(const std::string& path,
                                                         const Arguments& arguments,
                                                         std::vector<std::string> behaviours,
                                                         Console& console) {
  const ScenarioOptions options = scenario_options(arguments, std::move(behaviours));
  Result<Scenario> scenario = read_scenario(path, options);
  if (!scenario) {
    console.report(scenario.diagnostics());
    return nullptr;
  }
  Diagnostics warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  console.report(warnings);
  if (!prepared) {
    console.report(prepared.diagnostics());
    return nullptr;
  }
  return std::move(prepared).value();
}

}  // namespace jaywalk
