#pragma once

// A connection to a TraCI server on this machine.

#include <chrono>
#include <string>

#include "env/simulator/sumo/traci_message.h"

namespace jaywalk {

class TraciClient {
 public:
  TraciClient() = default;
  ~TraciClient() { disconnect(); }
  TraciClient(const TraciClient&) = delete;
  TraciClient& operator=(const TraciClient&) = delete;

  /// Whether somebody listens at that port of the loopback interface, and is connected now.
  [[nodiscard]] bool connect(int port);
  void disconnect();
  [[nodiscard]] bool is_connected() const { return socket_ >= 0; }

  /// Sends a message and waits for its answer. After an error, other than that a command was
  /// refused, nothing is connected. REQUIRES: it is connected.
  [[nodiscard]] TraciAnswer ask(const TraciMessage& message, std::chrono::milliseconds limit);

 private:
  using Deadline = std::chrono::steady_clock::time_point;

  [[nodiscard]] bool wait_for(short events, Deadline deadline, std::string& error);
  [[nodiscard]] std::string send_all(std::string_view bytes, Deadline deadline);
  [[nodiscard]] std::string receive(std::size_t count, Deadline deadline, std::string& bytes);

  int socket_ = -1;
};

/// A port of the loopback interface at which nobody listens now; 0: there is none.
[[nodiscard]] int free_port();

}  // namespace jaywalk
