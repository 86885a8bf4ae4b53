#pragma once

// The lines of `--trace` about agents, a JSON object each. `percept`, `event`, `message`, `plan`,
// `failure` and `action` have the agent and the time: the tick of a test (test_trace.h), or the
// agent's reasoning cycle in a program (program_trace.h).

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "interpreter/agent/surroundings/observer.h"

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

  std::string unit_;
};

}  // namespace jaywalk
