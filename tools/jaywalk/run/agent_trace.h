// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lines of `--trace` about agents, a JSON object each. `percept`, `event`, `message`, `plan`,
// `failure` and `action` have the agent and the time: the tick of a test (TestTrace), or the
// agent's reasoning cycle in a program (ProgramTrace).

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "experiment/test_run/test_run.h"
#include "interpreter/agent/surroundings/observer.h"
#include "tools/jaywalk/run/trace_output.h"

namespace jaywalk {

/// Looks at agents. An action's line comes when its outcome is known; it says when the agent acted.
class AgentTrace : public ReasoningObserver {
 public:
  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override;
  void formula_executes(Agent& agent, const Intention& intention, const Step& step) override;
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override;
  void event_posted(Agent& agent, const Event& event) override;

 protected:
  /// Keys stay in the order in which they are written.
  using Line = nlohmann::ordered_json;
  struct Action {
    std::string text;
    std::uint64_t when = 0;
    bool failed = false;
    std::string reason;
  };
  /// `unit`: of `when`, a key: "tick", "cycle".
  explicit AgentTrace(std::string_view unit) : unit_(unit) {}

  /// The agent's current tick or cycle. Called before its lines are written.
  [[nodiscard]] virtual std::uint64_t now(Agent& agent) = 0;
  void append(const Line& line);
  void write(const Action& action, const std::string& agent);

  /// Actions whose outcome is not known yet, by the agents' names.
  std::map<std::string, Action> actions_;
  std::string lines_;

 private:
  [[nodiscard]] Line line(std::string_view kind, Agent& agent);
  /// Keeps an action until its outcome is known.
  void note_action(Agent& agent, Value action);
  /// Writes a message if the internal action sends one.
  void note_message(Agent& agent, Value action);

  std::string unit_;
};

/// `--trace FILE.jsonl` of programs. A line of the kind `run` comes first, `end` last. Between them
/// there is, in the order of time, a `cycle` for each reasoning cycle of an agent that has other
/// lines, followed by these lines. Lines between two cycles belong to the cycle
/// before; those before an agent's first cycle to cycle 0.
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

/// `--trace FILE.jsonl` of tests. A line of the kind `test` begins a test, `end` ends it. Between
/// them there are, in the order of time, a `tick` and the lines of the agents in the next one.
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
