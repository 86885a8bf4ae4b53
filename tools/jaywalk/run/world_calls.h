// SPDX-License-Identifier: Apache-2.0
#pragma once

// Internal actions and functions that a world's program has, as Jason's projects have them in Java:
// a call is a question of the environment protocol (docs/reference/environment_protocol.md).

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/environment_process/process_environment.h"
#include "interpreter/agent/circumstance/message.h"
#include "interpreter/logic/action.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// The names of the internal actions that a program calls and that no library has, and of the
/// functions that it registers by their names alone: classes of Java, in Jason's projects.
struct ForeignNames {
  std::vector<std::string> actions;
  std::vector<std::string> functions;
};
[[nodiscard]] ForeignNames foreign_names(const SourceTree& program);

class WorldCalls {
 public:
  /// `world` must outlive this, and this all programs that are compiled with its actions.
  explicit WorldCalls(ProcessEnvironment& world);
  WorldCalls(const WorldCalls&) = delete;
  WorldCalls& operator=(const WorldCalls&) = delete;

  /// The foreign actions and functions of a program become the world's.
  void add_missing(const SourceTree& program);
  /// The standard ones and those.
  [[nodiscard]] const ActionRegistry& actions() const { return actions_; }

  /// Hands over the results of calls that took their time, and the goals and beliefs that the world
  /// gives to agents. REQUIRES: no step of the system is under way.
  void deliver(Mas& mas);

 private:
  using Json = nlohmann::json;

  /// An intention that waits for the result of its call.
  struct Waiting {
    AgentId agent{};
    MessageId question;
  };

  [[nodiscard]] Outcome call(const std::string& name, ActionCall& call);
  [[nodiscard]] bool evaluate(const std::string& name, std::span<const Value> args,
                              const SymbolTable& symbols, Value& result);
  [[nodiscard]] Outcome outcome_of(const Json& answer, std::size_t number, ActionCall& call);
  [[nodiscard]] Outcome wait(std::size_t number, ActionCall& call);
  void finish(Mas& mas, const Json& called);
  void inform(Mas& mas, const Json& events);

  ProcessEnvironment& world_;
  ActionRegistry actions_;
  /// The actions that ask what the agent believes.
  std::set<std::string, std::less<>> needs_beliefs_;
  std::map<std::size_t, Waiting> waiting_;  // by the numbers of the questions
};

}  // namespace jaywalk
