#pragma once

// `--trace FILE.jsonl` of tests. A line of the kind `test` begins a test, `end` ends it. Between
// them there are, in the order of time, a `tick` and the lines of the agents in the next one
// (agent_trace.h).

#include <cstdint>
#include <string>
#include <string_view>

#include "experiment/test_run/test_run.h"
#include "tools/jaywalk/run/agent_trace.h"

namespace jaywalk {

/// Looks at the agents of one test. An action's outcome is known in the next tick.
class TestTrace final : public AgentTrace {
 public:
  TestTrace() : AgentTrace("tick") {}

  void begin(std::string_view behaviour, const TestSetup& setup);
  /// As TestOptions::observe: before the first tick and after each.
  void tick(const World& world, const Mas& mas);
  void end(const TestRun& result);
  /// The lines so far.
  [[nodiscard]] const std::string& lines() const { return lines_; }

 private:
  [[nodiscard]] std::uint64_t now(Agent& /*agent*/) override { return tick_; }

  std::uint64_t tick_ = 1;  // the one that agents reason in
};

}  // namespace jaywalk
