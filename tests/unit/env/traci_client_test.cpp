// SPDX-License-Identifier: Apache-2.0
// The TraCI client's requests and the answers that it waits for; a thread plays the server.

#include "env/simulator/sumo/traci_client.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using namespace std::chrono_literals;

/// A server of one connection.
class Server {
 public:
  explicit Server(std::function<void(Server&)> talk) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const as_any = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(listener_, as_any, size), 0);
    EXPECT_EQ(listen(listener_, 1), 0);
    EXPECT_EQ(getsockname(listener_, as_any, &size), 0);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this, talk = std::move(talk)] {
      connection_ = accept(listener_, nullptr, nullptr);
      talk(*this);
      close(connection_);
    });
  }
  ~Server() {
    thread_.join();
    close(listener_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] int port() const { return port_; }
  /// Reads a message: how many bytes it has; 0: the client has gone.
  std::size_t read_message() {
    std::array<unsigned char, 4> head{};
    if (recv(connection_, head.data(), head.size(), MSG_WAITALL) != 4) return 0;
    const std::size_t size = (std::size_t{head[0]} << 24U) | (std::size_t{head[1]} << 16U) |
                             (std::size_t{head[2]} << 8U) | head[3];
    std::string rest(size - head.size(), ' ');
    const ssize_t got = recv(connection_, rest.data(), rest.size(), MSG_WAITALL);
    return got == static_cast<ssize_t>(rest.size()) ? size : 0;
  }
  /// The answer to a step, with no subscriptions; the status of each command before it.
  void answer(std::size_t commands_before = 0) {
    std::string body;
    for (std::size_t i = 0; i < commands_before; ++i) body += std::string("\x07\xce\0\0\0\0\0", 7);
    body += std::string("\x07\x02\0\0\0\0\0\0\0\0\0", 11);
    const auto size = static_cast<std::uint32_t>(body.size() + 4);
    std::string message;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
      message += static_cast<char>((size >> shift) & 0xffU);
    }
    message += body;
    for (std::size_t sent = 0; sent < message.size();) {
      const ssize_t count =
          send(connection_, message.data() + sent, message.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }

 private:
  int listener_ = -1;
  int connection_ = -1;
  int port_ = 0;
  std::thread thread_;
};

std::vector<TraciMessage> steps(std::size_t count) {
  std::vector<TraciMessage> messages(count);
  for (TraciMessage& each : messages) each.step();
  return messages;
}

TEST(TraciClient, SendsWhatDoesNotDependOnAnswersAtOnce) {
  Server server([](Server& self) {
    for (int i = 0; i < 10; ++i) EXPECT_GT(self.read_message(), 0U);
    for (int i = 0; i < 10; ++i) self.answer();
  });
  TraciClient client;
  ASSERT_TRUE(client.connect(server.port()));
  const std::vector<TraciAnswer> answers = client.ask(steps(10), 10s);
  ASSERT_EQ(answers.size(), 10U);
  for (const TraciAnswer& each : answers) EXPECT_EQ(each.error, "");
  EXPECT_TRUE(client.is_connected());
}

TEST(TraciClient, EndsAtTheAnswerThatDoesNotCome) {
  Server server([](Server& self) {
    // All is read: a connection closed with unread bytes is reset, and may lose the answers.
    for (int i = 0; i < 10; ++i) {
      EXPECT_GT(self.read_message(), 0U);
      if (i < 3) self.answer();
    }
  });
  TraciClient client;
  ASSERT_TRUE(client.connect(server.port()));
  const std::vector<TraciAnswer> answers = client.ask(steps(10), 10s);
  ASSERT_EQ(answers.size(), 4U);
  EXPECT_EQ(answers[2].error, "");
  EXPECT_EQ(answers[3].error, "it closed the connection");
  EXPECT_FALSE(client.is_connected());
}

TEST(TraciClient, SaysWhenAnAnswerIsLate) {
  Server server([](Server& self) {
    EXPECT_GT(self.read_message(), 0U);
    self.answer();
    while (self.read_message() > 0) continue;
  });
  TraciClient client;
  ASSERT_TRUE(client.connect(server.port()));
  const std::vector<TraciAnswer> answers = client.ask(steps(2), 50ms);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[1].error, "no answer within 0.05 s");
}

// Crowds: ten messages of 2 MB, each answered by as much. If all were sent before anything is read,
// both sides would wait for each other.
TEST(TraciClient, ReadsBeforeTheBuffersAreFull) {
  constexpr std::size_t kPeople = 30'000;
  Server server([](Server& self) {
    while (self.read_message() > 0) self.answer(kPeople);
  });
  std::vector<TraciMessage> messages(10);
  for (TraciMessage& each : messages) {
    for (std::size_t i = 0; i < kPeople; ++i) {
      each.set(TraciCommand::person_set, TraciVariable::speed, "p" + std::to_string(i),
               traci_real(1));
    }
    each.step();
  }
  TraciClient client;
  ASSERT_TRUE(client.connect(server.port()));
  const std::vector<TraciAnswer> answers = client.ask(messages, 10s);
  ASSERT_EQ(answers.size(), 10U);
  EXPECT_EQ(answers.back().error, "");
  client.disconnect();
}

}  // namespace
}  // namespace jaywalk
