// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/simulator_version.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "env/simulator/simulator.h"
#include "env/simulator/simulator_section.h"
#include "experiment/scenario/files/program_text.h"

namespace jaywalk {
namespace {

/// A map's name by its content, since its path differs between machines and in a store's copies.
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
  Simulator& simulator = simulators.of(parameters);
  SimulatorIdentity identity;
  std::vector<SettingProblem> problems;
  if (const std::string why = simulator.identify(identity); !why.empty()) {
    std::string message = fmt::format("the simulator '{}': {}", parameters.name, why);
    for (const std::string& note : simulator.take_notes()) message += '\n' + note;
    problems.push_back({{}, std::move(message)});
  } else if (const auto site = scenario.world->site()) {
    problems = simulator.survey(*site);
  }
  if (!problems.empty()) {
    Diagnostics diagnostics;
    report_settings(std::move(problems), scenario.origins, scenario.name, diagnostics);
    return diagnostics;
  }
  std::string text = fmt::format("{} {}", identity.name, identity.version);
  if (!identity.network.empty())
    text += fmt::format(", network {}", network_name(identity.network));
  return text;
}

}  // namespace jaywalk
