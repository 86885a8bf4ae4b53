#include "env/world/world_spec.h"

#include <fmt/format.h>

#include "env/simulator/simulator.h"

namespace jaywalk {

std::string WorldSpec::agent_name(std::uint32_t number) const { return fmt::format("p{}", number); }

const SimulatorParameters& WorldSpec::simulator() const {
  static const SimulatorParameters kNone;
  return kNone;
}

std::optional<SimulatedSite> WorldSpec::site() const { return std::nullopt; }

std::vector<std::string> WorldSpec::command() const { return vehicle().command; }

}  // namespace jaywalk
