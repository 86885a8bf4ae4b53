#include "experiment/test_run/simulator_version.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "env/simulator/simulator.h"
#include "experiment/scenario/files/sha256.h"

namespace jaywalk {
namespace {

/// A map by what is in it: its path is another one on each machine, and in a store's copies.
std::string network_name(const std::string& network) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(network, ignored)) return network;
  constexpr std::size_t kDigits = 16;
  std::ostringstream text;
  text << std::ifstream(network, std::ios::binary).rdbuf();
  return "sha256 " + sha256(text.str()).substr(0, kDigits);
}

}  // namespace

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
  if (!identity.network.empty())
    text += fmt::format(", network {}", network_name(identity.network));
  return text;
}

}  // namespace jaywalk
