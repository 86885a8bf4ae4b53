#include "experiment/trial/simulator_version.h"

#include <fmt/format.h>

#include "env/simulator/simulator.h"

namespace jaywalk {

Result<std::string> simulator_version(const Scenario& scenario) {
  const SimulatorParameters& parameters = scenario.world->simulator();
  if (parameters.name.empty()) return std::string();
  Simulators simulators;
  SimulatorIdentity identity;
  const std::string why = simulators.of(parameters).identify(identity);
  if (!why.empty()) {
    Diagnostics diagnostics;
    diagnostics.error("world.simulator",
                      fmt::format("the simulator '{}': {}", parameters.name, why));
    return diagnostics;
  }
  std::string text = fmt::format("{} {}", identity.name, identity.version);
  if (!identity.network.empty()) text += fmt::format(", network {}", identity.network);
  return text;
}

}  // namespace jaywalk
