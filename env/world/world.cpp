// SPDX-License-Identifier: Apache-2.0
#include "env/world/world.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/simulator/simulator.h"
#include "env/world/world_spec.h"
#include "interpreter/support/text.h"

namespace jaywalk {

double WorldResult::score() const {
  if (agents.empty()) return 0;
  double sum = 0;
  for (const AgentOutcome& outcome : agents) sum += outcome.reward - outcome.cost;
  return sum / static_cast<double>(agents.size());
}

std::string World::describe_result() const {
  const WorldResult& of = result();
  if (!of.success) {
    const auto ticks = static_cast<std::uint64_t>(of.ticks);
    return fmt::format("precondition not met in {}, score {:.2f}", counted(ticks, "tick"),
                       of.score());
  }
  const std::vector<Actor> all = actors();
  std::vector<std::string> names;
  for (const std::size_t agent : of.met_by) names.push_back(all[agent + 1].name);
  return fmt::format("precondition met in tick {} by {}, score {:.2f}", of.ticks,
                     fmt::join(names, ", "), of.score());
}

std::string WorldSpec::agent_name(std::uint32_t number) const { return fmt::format("p{}", number); }

const SimulatorParameters& WorldSpec::simulator() const {
  static const SimulatorParameters kNone;
  return kNone;
}

std::optional<SimulatedSite> WorldSpec::site() const { return std::nullopt; }

std::vector<std::string> WorldSpec::command() const { return vehicle().command; }

}  // namespace jaywalk
