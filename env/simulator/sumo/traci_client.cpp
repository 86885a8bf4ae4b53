// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/traci_client.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "env/process/guarded_child.h"

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// How much is read at a time at least.
constexpr std::size_t kChunk = 1 << 16;
/// No more than fits into the sockets' buffers, so that neither side waits for the other to read.
constexpr std::size_t kMostUnanswered = 1 << 14;
constexpr std::string_view kClosed = "it closed the connection";

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  return address;
}

}  // namespace

int free_port() {
  const int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return 0;
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof address;
  auto* const as_any = reinterpret_cast<sockaddr*>(&address);
  const bool found = bind(probe, as_any, size) == 0 && getsockname(probe, as_any, &size) == 0;
  close(probe);
  return found ? ntohs(address.sin_port) : 0;
}

bool TraciClient::connect(int port) {
  disconnect();
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket_ < 0) return false;
  const sockaddr_in address = loopback(port);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    disconnect();
    return false;
  }
  // A step is one small message: it must not wait for more to send.
  const int yes = 1;
  setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  return true;
}

void TraciClient::disconnect() {
  taken_ = end_ = 0;
  if (socket_ >= 0) close(std::exchange(socket_, -1));
}

std::string TraciClient::wait_for(short events, Deadline deadline) {
  std::array<pollfd, 1> wait{pollfd{socket_, events, 0}};
  return wait_for_child(wait, deadline);
}

std::string TraciClient::send_all(std::string_view bytes, Deadline deadline) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN) {
      if (std::string why = wait_for(POLLOUT, deadline); !why.empty()) return why;
    } else if (errno != EINTR) {
      return std::string(kClosed);
    }
  }
  return {};
}

std::string TraciClient::receive(std::size_t count, Deadline deadline) {
  if (taken_ == end_) taken_ = end_ = 0;
  if (received_.size() < std::max(taken_ + count, kChunk)) {
    received_.resize(std::max(taken_ + count, kChunk));
  }
  while (end_ - taken_ < count) {
    const ssize_t got =
        recv(socket_, received_.data() + end_, received_.size() - end_, MSG_DONTWAIT);
    if (got > 0) {
      end_ += static_cast<std::size_t>(got);
    } else if (got < 0 && errno == EAGAIN) {
      if (std::string why = wait_for(POLLIN, deadline); !why.empty()) return why;
    } else if (got == 0 || errno != EINTR) {
      return std::string(kClosed);
    }
  }
  return {};
}

std::string_view TraciClient::take(std::size_t count) {
  const std::string_view bytes(received_.data() + taken_, count);
  taken_ += count;
  return bytes;
}

TraciAnswer TraciClient::fail(std::string error, milliseconds limit) {
  if (error == kLate) {
    error = fmt::format("no answer within {:g} s", static_cast<double>(limit.count()) / 1000);
  }
  disconnect();
  TraciAnswer answer;
  answer.error = std::move(error);
  return answer;
}

TraciAnswer TraciClient::receive_answer(const TraciMessage& message, milliseconds limit) {
  const Deadline deadline = steady_clock::now() + limit;
  std::string error = receive(4, deadline);
  if (!error.empty()) return fail(std::move(error), limit);
  const std::int64_t rest = traci_rest(take(4));
  if (rest < 0) return fail("its answer has an impossible length", limit);
  error = receive(static_cast<std::size_t>(rest), deadline);
  if (!error.empty()) return fail(std::move(error), limit);
  return read_traci_answer(message.commands(), take(static_cast<std::size_t>(rest)));
}

std::vector<TraciAnswer> TraciClient::ask(std::span<const TraciMessage> messages,
                                          milliseconds limit) {
  std::vector<TraciAnswer> answers;
  std::vector<std::size_t> sizes;  // of the messages that have been sent
  std::size_t unanswered = 0;
  while (answers.size() < messages.size()) {
    std::string bytes;
    while (sizes.size() < messages.size() && unanswered < kMostUnanswered) {
      const std::string message = messages[sizes.size()].bytes();
      bytes += message;
      sizes.push_back(message.size());
      unanswered += message.size();
    }
    std::string error = send_all(bytes, steady_clock::now() + limit);
    if (!error.empty()) {
      answers.push_back(fail(std::move(error), limit));
      return answers;
    }
    const TraciMessage& next = messages[answers.size()];
    answers.push_back(receive_answer(next, limit));
    if (!answers.back().error.empty()) return answers;
    unanswered -= sizes[answers.size() - 1];
  }
  return answers;
}

TraciAnswer TraciClient::ask(const TraciMessage& message, milliseconds limit) {
  return std::move(ask(std::span(&message, 1), limit).front());
}

}  // namespace jaywalk
