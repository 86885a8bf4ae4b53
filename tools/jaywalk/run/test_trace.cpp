#include "tools/jaywalk/run/test_trace.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace jaywalk {

void TestTrace::begin(std::string_view behaviour, const TrialInput& input) {
  append({{"kind", "test"},
          {"behaviour", behaviour},
          {"agents", input.agents},
          {"test", input.test},
          {"seed", input.seed}});
}

void TestTrace::tick(const Crossing& crossing, const Mas& mas) {
  const auto ticks = static_cast<std::uint64_t>(crossing.ticks());
  // Whoever had failed in the tick before has heard of it by now.
  for (auto it = actions_.begin(); it != actions_.end();) {
    if (it->second.when >= ticks && !crossing.finished()) {
      ++it;
      continue;
    }
    // Of the last tick nobody hears any more: a step that led nowhere has failed.
    if (it->second.when >= ticks && it->second.text.starts_with("move(")) {
      const std::size_t bodies = std::min<std::size_t>(crossing.bodies().size(), mas.agent_count());
      for (std::size_t i = 0; i < bodies; ++i) {
        if (mas.agent_name(static_cast<AgentId>(i)) != it->first) continue;
        it->second.failed = crossing.bodies()[i].stepped_in != crossing.ticks();
      }
    }
    write(it->second, it->first);
    it = actions_.erase(it);
  }
  append({{"kind", "tick"},
          {"tick", crossing.ticks()},
          {"time_s", crossing.ticks() * crossing.parameters().tick_s}});
  tick_ = ticks + 1;
}

void TestTrace::end(const TrialResult& result) {
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
