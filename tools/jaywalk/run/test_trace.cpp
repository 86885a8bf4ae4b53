#include "tools/jaywalk/run/test_trace.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace jaywalk {

void TestTrace::begin(std::string_view behaviour, const TestSetup& setup) {
  append({{"kind", "test"},
          {"behaviour", behaviour},
          {"agents", setup.agents},
          {"test", setup.test},
          {"seed", setup.seed}});
}

void TestTrace::tick(const World& world, const Mas& mas) {
  const auto ticks = static_cast<std::uint64_t>(world.ticks());
  // Agents perceive a failed action one tick later: outcomes before this tick are known by now.
  for (auto it = actions_.begin(); it != actions_.end();) {
    if (it->second.when >= ticks && !world.finished()) {
      ++it;
      continue;
    }
    // After the last tick agents perceive nothing more; ask the world whether their actions failed.
    for (std::size_t i = 0; it->second.when >= ticks && i < mas.agent_count(); ++i) {
      if (mas.agent_name(static_cast<AgentId>(i)) != it->first) continue;
      it->second.failed = it->second.failed || world.last_action_failed(i);
    }
    write(it->second, it->first);
    it = actions_.erase(it);
  }
  append({{"kind", "tick"}, {"tick", world.ticks()}, {"time_s", world.ticks() * world.tick_s()}});
  tick_ = ticks + 1;
}

void TestTrace::end(const TestRun& result) {
  Line line{{"kind", "end"},
            {"completed", result.completed},
            {"met_precondition", result.outcome.success},
            {"ticks", result.outcome.ticks},
            {"score", result.outcome.score()},
            {"collisions", result.outcome.collisions.size()}};
  if (!result.completed) line["reason"] = result.message;
  append(line);
}

}  // namespace jaywalk
