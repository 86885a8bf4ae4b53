#pragma once

// `--trace FILE.jsonl` of programs. A line of the kind `run` comes first, `end` last. Between them
// there is, in the order of time, a `cycle` for each reasoning cycle of an agent that has other
// lines, followed by these lines (agent_trace.h). Lines between two cycles belong to the cycle
// before; those before an agent's first cycle to cycle 0.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/jaywalk/run/agent_trace.h"
#include "tools/jaywalk/run/trace_output.h"

namespace jaywalk {

/// Looks at the agents of one run, and writes as it goes: runs may be long.
class ProgramTrace final : public AgentTrace {
 public:
  /// `file` must outlive it.
  explicit ProgramTrace(TraceFile& file) : AgentTrace("cycle"), file_(file) {}

  void begin(std::string_view program, std::size_t agents, std::uint64_t seed);
  /// `how` it ended: "stopped", "idle", "limit" ...; `why`: perhaps more about it.
  void end(std::string_view how, std::string_view why, double time_s, int exit_code);

 private:
  [[nodiscard]] std::uint64_t now(Agent& agent) override;
  void hand_over();

  TraceFile& file_;
  std::uint64_t parts_ = 0;
  // The cycle in which something was last said, by the agents' numbers; 0: none.
  std::vector<std::uint64_t> cycles_;
};

}  // namespace jaywalk
