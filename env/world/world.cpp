#include "env/world/world.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

}  // namespace jaywalk
