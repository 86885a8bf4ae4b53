// SPDX-License-Identifier: Apache-2.0
#pragma once

// A connection to a TraCI server on this machine.

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/simulator/sumo/traci_message.h"

namespace jaywalk {

class TraciClient {
 public:
  TraciClient() = default;
  ~TraciClient() { disconnect(); }
  TraciClient(const TraciClient&) = delete;
  TraciClient& operator=(const TraciClient&) = delete;

  /// Connects to that port of the loopback interface; false if no server listens there.
  [[nodiscard]] bool connect(int port);
  void disconnect();
  [[nodiscard]] bool is_connected() const { return socket_ >= 0; }

  /// Sends a message and waits for its answer. After an error, other than that a command was
  /// refused, nothing is connected. REQUIRES: it is connected.
  [[nodiscard]] TraciAnswer ask(const TraciMessage& message, std::chrono::milliseconds limit);
  /// Sends messages that do not depend on each other's answers without waiting in between, so that
  /// neither side sleeps between two of them. The limit is that of one answer. Ends at the first
  /// error, which is the last answer.
  [[nodiscard]] std::vector<TraciAnswer> ask(std::span<const TraciMessage> messages,
                                             std::chrono::milliseconds limit);

 private:
  using Deadline = std::chrono::steady_clock::time_point;

  /// Why the connection is not ready; empty if it is.
  [[nodiscard]] std::string wait_for(short events, Deadline deadline);
  [[nodiscard]] std::string send_all(std::string_view bytes, Deadline deadline);
  /// Receives until at least `count` bytes have not been taken yet.
  [[nodiscard]] std::string receive(std::size_t count, Deadline deadline);
  [[nodiscard]] std::string_view take(std::size_t count);
  [[nodiscard]] TraciAnswer receive_answer(const TraciMessage& message,
                                           std::chrono::milliseconds limit);
  [[nodiscard]] TraciAnswer fail(std::string error, std::chrono::milliseconds limit);

  int socket_ = -1;
  /// The received bytes; the first `taken_` of them have been taken.
  std::vector<char> received_;
  std::size_t taken_ = 0;
  std::size_t end_ = 0;
};

/// A free port of the loopback interface; 0: there is none.
[[nodiscard]] int free_port();

}  // namespace jaywalk
