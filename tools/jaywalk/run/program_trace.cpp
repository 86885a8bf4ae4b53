#include "tools/jaywalk/run/program_trace.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "interpreter/agent/agent.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMostKept = std::size_t{1} << 16U;

}  // namespace

void ProgramTrace::begin(std::string_view program, std::size_t agents, std::uint64_t seed) {
  append({{"kind", "run"}, {"program", program}, {"agents", agents}, {"seed", seed}});
}

std::uint64_t ProgramTrace::now(Agent& agent) {
  if (agent.number() >= cycles_.size()) cycles_.resize(agent.number() + 1);
  const std::uint64_t cycle = agent.cycles();
  std::uint64_t& last = cycles_[agent.number()];
  if (std::exchange(last, cycle) == cycle) return cycle;
  if (lines_.size() >= kMostKept) hand_over();
  append({{"kind", "cycle"},
          {"cycle", cycle},
          {"agent", agent.name()},
          {"time_s", agent.host().now_ms() / 1000}});
  return cycle;
}

void ProgramTrace::hand_over() { file_.add(parts_++, std::exchange(lines_, {})); }

void ProgramTrace::end(std::string_view how, std::string_view why, double time_s, int exit_code) {
  for (const auto& [agent, action] : actions_) write(action, agent);
  actions_.clear();
  Line line{{"kind", "end"}, {"ended", how}, {"time_s", time_s}, {"exit_code", exit_code}};
  if (!why.empty()) line["reason"] = why;
  append(line);
  hand_over();
}

}  // namespace jaywalk
