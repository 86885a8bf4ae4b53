#pragma once

// What an agent needs of the system that it lives in. Implemented by the multi-agent system.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/term/value.h"

namespace jaywalk {

class Agent;

/// A message as its sender gives it. The content is copied when it is sent.
struct OutgoingMessage {
  std::string_view receiver;
  Symbol performative{};
  Value content;
  /// Names the exchange: of a question, or of the question that is answered.
  std::string id;
  std::string in_reply_to;
};

class AgentHost {
 public:
  virtual ~AgentHost() = default;

  [[nodiscard]] virtual double now_ms() const = 0;
  /// Calls Agent::timer_fired(token) at that time.
  virtual void set_timer(Agent& agent, double at_ms, std::uint64_t token) = 0;
  /// False: there is no such agent.
  virtual bool send(Agent& sender, const OutgoingMessage& message) = 0;
  virtual void broadcast(Agent& sender, const OutgoingMessage& message) = 0;
  [[nodiscard]] virtual std::vector<std::string> agent_names() const = 0;
  /// An action for the environment; false: there is no environment.
  virtual bool act(Agent& agent) = 0;
  /// Text for the console, without line break and without `[agent]`.
  virtual void print(Agent& agent, std::string_view text) = 0;
  virtual void log(Agent& agent, std::string_view text) = 0;
  virtual void stop(int exit_code) = 0;
};

}  // namespace jaywalk
