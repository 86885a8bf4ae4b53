#include "env/simulator/sumo/traci_client.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

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
  if (socket_ >= 0) close(std::exchange(socket_, -1));
}

bool TraciClient::wait_for(short events, Deadline deadline, std::string& error) {
  while (true) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now()).count();
    pollfd wait{socket_, events, 0};
    const int count =
        poll(&wait, 1, static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000)));
    if (count > 0) return true;
    if (count < 0 && errno == EINTR) continue;
    error = count == 0 ? "late" : std::strerror(errno);
    return false;
  }
}

std::string TraciClient::send_all(std::string_view bytes, Deadline deadline) {
  std::string error;
  while (!bytes.empty()) {
    if (!wait_for(POLLOUT, deadline, error)) return error;
    const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (errno != EAGAIN && errno != EINTR) {
      return std::string(kClosed);
    }
  }
  return {};
}

std::string TraciClient::receive(std::size_t count, Deadline deadline, std::string& bytes) {
  std::string error;
  bytes.clear();
  std::array<char, 65536> chunk{};
  while (bytes.size() < count) {
    if (!wait_for(POLLIN, deadline, error)) return error;
    const ssize_t got =
        recv(socket_, chunk.data(), std::min(chunk.size(), count - bytes.size()), MSG_DONTWAIT);
    if (got > 0) {
      bytes.append(chunk.data(), static_cast<std::size_t>(got));
    } else if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      return std::string(kClosed);
    }
  }
  return {};
}

TraciAnswer TraciClient::ask(const TraciMessage& message, milliseconds limit) {
  const Deadline deadline = steady_clock::now() + limit;
  std::string bytes;
  std::string error = send_all(message.bytes(), deadline);
  if (error.empty()) error = receive(4, deadline, bytes);
  if (error.empty()) {
    const std::int64_t rest = traci_rest(bytes);
    error = rest < 0 ? "its answer has an impossible length"
                     : receive(static_cast<std::size_t>(rest), deadline, bytes);
  }
  if (error.empty()) return read_traci_answer(message.commands(), bytes);
  if (error == "late") {
    error = fmt::format("no answer within {:g} s", static_cast<double>(limit.count()) / 1000);
  }
  disconnect();
  TraciAnswer answer;
  answer.error = std::move(error);
  return answer;
}

}  // namespace jaywalk
