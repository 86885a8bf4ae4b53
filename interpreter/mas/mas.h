// SPDX-License-Identifier: Apache-2.0
#pragma once

// A multi-agent system: agents, their messages, a clock and perhaps an environment. It runs in
// ticks; <jaywalk/run.h> says in which order and with which options.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/agent/surroundings/settings.h"
#include <jaywalk/environment.h>
#include <jaywalk/run.h>

namespace jaywalk {

class Agent;
class Program;
class SymbolTable;
struct Customisation;

/// A belief given from outside: it replaces the program's initial beliefs of that name
/// and arity (`radius(15)`: radius/1). Arguments are numbers and atoms.
struct Parameter {
  Predicate predicate{};
  std::vector<Value> args;
};

struct AgentSpec {
  std::string name;
  std::shared_ptr<const Program> program;
  std::vector<Parameter> parameters;
  /// Functions of its own (agent/surroundings/customisation.h); null: none.
  std::shared_ptr<const Customisation> customisation;
  ReasoningSettings settings;
};

class Mas {
 public:
  /// `symbols` is the table into which the programs were compiled; it must not change any more.
  /// `environment` may be null; it must outlive the system.
  Mas(std::shared_ptr<const SymbolTable> symbols, MasOptions options, Environment* environment);
  ~Mas();
  Mas(const Mas&) = delete;
  Mas& operator=(const Mas&) = delete;

  /// Begins anew, as if it had just been made with these: there are no agents, and no time has
  /// passed. What agents were made of is used again.
  void restart(MasOptions options, Environment* environment);

  /// Names that are taken get a suffix, as in Jason (`ann_1`).
  AgentId add_agent(const AgentSpec& spec);

  /// Agents that others create have a body in the environment, too, which has to expect that.
  void embody_newcomers();

  /// Runs to the end.
  RunOutcome run();
  /// Runs one tick (without an environment: one cycle of every active agent); false: it has ended.
  bool step();
  /// As many steps as take little time and are best done at once; false: it has ended.
  bool stride();
  [[nodiscard]] const RunOutcome& outcome() const;

  /// How many agents there have been; those that were killed count.
  [[nodiscard]] std::size_t agent_count() const;
  /// False for those that were killed, and for ids that this system has not given.
  [[nodiscard]] bool is_alive(AgentId id) const;
  /// REQUIRES: the agent is alive.
  [[nodiscard]] const Agent& agent(AgentId id) const;
  /// This and what follows is empty of an agent that is not alive.
  [[nodiscard]] const std::string& agent_name(AgentId id) const;
  /// An agent's goals, for people: those of each intention, the outermost first
  /// ("test_av > cross > step(right)"), in the order of the intentions.
  [[nodiscard]] std::vector<std::string> describe_intentions(AgentId id) const;
  /// The agent's beliefs as texts, in the order of the belief base.
  [[nodiscard]] std::vector<std::string> describe_beliefs(AgentId id) const;
  void each_belief(AgentId id, const std::function<void(Value belief)>& callback) const;
  /// Does something with an agent between two steps: `work` may ask it, or change its beliefs,
  /// goals and plans. False: a limit stopped it, or the agent is not alive, and `problem` says so.
  /// A run that ended because all agents were idle goes on with the next step. REQUIRES: no step is
  /// under way.
  [[nodiscard]] bool intervene(AgentId id, const std::function<void(Agent& agent)>& work,
                               std::string& problem);
  /// The run's own names, above those of the programs.
  [[nodiscard]] SymbolTable& symbols();
  [[nodiscard]] double now_ms() const;
  /// When the next timer is due that an agent waits for; nothing if none is.
  [[nodiscard]] std::optional<double> next_timer_ms();
  /// Seconds of CPU spent in reasoning so far (0 unless measured).
  [[nodiscard]] double reasoning_cpu_s() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace jaywalk
