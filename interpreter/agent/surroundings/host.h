// SPDX-License-Identifier: Apache-2.0
#pragma once

// The services that an agent needs from its system. Implemented by the multi-agent system
// (mas/system.h).

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/agent/circumstance/message.h"
#include "interpreter/logic/action.h"
#include "interpreter/term/value.h"
#include <jaywalk/run.h>

namespace jaywalk {

class Agent;
struct AgentTurn;
class OptionPolicies;
class Program;
class ReasoningObserver;
class ServiceDirectory;

/// A message as its sender gives it. The content is copied when it is sent.
struct OutgoingMessage {
  std::string_view receiver;  // `self`: the sender
  /// The receiver as an atom of the default namespace, if it was written so; then no text is
  /// needed.
  std::optional<Predicate> receiver_atom;
  Symbol performative{};
  Value content;
  /// Identifies the message, so that an answer can refer to it.
  MessageId id;
  MessageId in_reply_to;
};

/// The agents of the system: their names, creation and end.
class Society {
 public:
  /// The name that a new agent got, or why there is none.
  struct Creation {
    std::string name;
    std::string error;  // empty: all went well
  };

  virtual ~Society() = default;

  /// The agents' names, in the order of their creation.
  [[nodiscard]] virtual std::vector<std::string> names() const = 0;
  /// The program in a file, for agents of this run; null after setting `problem`. It lives as long
  /// as the run.
  [[nodiscard]] virtual std::shared_ptr<const Program> load(const ProgramRequest& request,
                                                            LoadProblem& problem) = 0;
  /// Writes a program to a file; false after setting `error`.
  [[nodiscard]] virtual bool save(const std::string& file, const std::string& text,
                                  std::string& error) = 0;
  /// Why agents may not list the files of a folder; empty: they may.
  [[nodiscard]] virtual std::string why_not_list(const std::string& folder) = 0;
  /// A new agent that runs the program in a file. A name that is taken gets a suffix.
  [[nodiscard]] virtual Creation create(const std::string& name, const std::string& file) = 0;
  /// A new agent with the beliefs, plans and goals of another.
  [[nodiscard]] virtual Creation clone(Agent& original, const std::string& name) = 0;
  /// The agent goes: at once, or after a time that it is informed about. False: there is no such
  /// agent.
  virtual bool kill(std::string_view name, double deadline_ms) = 0;
  /// The agent ends the run: at once, or after a time that all agents are informed about.
  virtual void stop(Agent& agent, double deadline_ms, int exit_code) = 0;
  /// The yellow pages.
  [[nodiscard]] virtual ServiceDirectory& services() = 0;
};

/// Time is virtual: a system begins at midnight of 1 January 2000, UTC, whenever it runs, so that
/// runs can be repeated. Milliseconds since 1970.
inline constexpr double kEpochMs = 946'684'800'000;

class AgentHost {
 public:
  virtual ~AgentHost() = default;

  [[nodiscard]] virtual double now_ms() const = 0;
  /// Calls Agent::timer_fired(token) at that time.
  virtual void set_timer(Agent& agent, double at_ms, std::uint64_t token) = 0;
  /// False: there is no such agent.
  virtual bool send(Agent& sender, const OutgoingMessage& message) = 0;
  /// An action for the environment; false: there is none, or the agent has no body in it.
  virtual bool act(Agent& agent) = 0;
  /// Text for the console, without line break and without `[agent]`.
  virtual void print(Agent& agent, std::string_view text) = 0;
  /// Text for the console as it is, for agents with `verbose=0`.
  virtual void write(Agent& agent, std::string_view text) = 0;
  virtual void log(Agent& agent, std::string_view text) = 0;
  /// Somebody reads the log; otherwise its lines need not be made.
  [[nodiscard]] virtual bool keeps_log() const { return true; }
  [[nodiscard]] virtual Society& society() = 0;
  /// The turn of agents that reason one after another.
  [[nodiscard]] virtual AgentTurn& common_turn() = 0;
  /// A limit has ended a step of the agent, or a query; `where` says which: "x.asl:2:21", "the
  /// context of @p1". Perhaps that ends the run.
  virtual void limit_reached(Agent& /*agent*/, ReachedLimit /*limit*/, std::string /*where*/) {}
  /// Whether the run is to end at once. Asked within queries and long actions.
  [[nodiscard]] virtual bool interrupted() { return false; }
  /// Gives the probabilities of the options of policies; null: all are equally probable.
  [[nodiscard]] virtual OptionPolicies* policies() { return nullptr; }
  /// The observer of the agents as they reason; null: none.
  [[nodiscard]] virtual ReasoningObserver* observer() { return nullptr; }
};

}  // namespace jaywalk
