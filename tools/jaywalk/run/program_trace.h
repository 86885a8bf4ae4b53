#pragma once

// `--trace FILE.jsonl` of programs. A line of the kind `run` comes first, `end` last; between them
// stand, in the order in which it happens, a `cycle` for each reasoning cycle of an agent in which
// something can be said, and behind it what the agent does in it (agent_trace.h). What comes
// between two cycles is of the last one; before an agent's first, it is cycle 0.

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
