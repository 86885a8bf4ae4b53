#include "env/process/line_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

extern char** environ;

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

int remaining_ms(steady_clock::time_point deadline) {
  const auto left = std::chrono::duration_cast<milliseconds>(deadline - steady_clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1'000'000));
}

/// Empty when the file is ready, else what is wrong.
std::string wait_for(int file, short events, steady_clock::time_point deadline) {
  while (true) {
    pollfd ready{file, events, 0};
    const int count = poll(&ready, 1, remaining_ms(deadline));
    if (count > 0) return {};
    if (count == 0) return "took too long to answer";
    if (errno != EINTR) return std::strerror(errno);
  }
}

}  // namespace

LineProcess::~LineProcess() { end(milliseconds(1000)); }

std::string LineProcess::start() {
  if (command_.empty()) return "no program is given";
  // A pair of sockets, since writing to one whose other end is gone need not raise a signal.
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) {
    return std::strerror(errno);
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pair[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pair[1], STDOUT_FILENO);
  std::vector<char*> arguments;
  for (std::string& each : command_) arguments.push_back(each.data());
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int failed =
      posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pair[1]);
  if (failed != 0) {
    close(pair[0]);
    return fmt::format("'{}' cannot be started: {}", command_[0], std::strerror(failed));
  }
  process_ = process;
  to_child_ = from_child_ = pair[0];
  buffer_.clear();
  return {};
}

std::string LineProcess::write_all(std::string_view text, Deadline deadline) {
  while (!text.empty()) {
    if (std::string problem = wait_for(to_child_, POLLOUT, deadline); !problem.empty()) {
      return problem;
    }
    const ssize_t written = send(to_child_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (written > 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EAGAIN && errno != EINTR) {
      return "ended without reading its question";
    }
  }
  return {};
}

LineAnswer LineProcess::read_line(Deadline deadline) {
  std::size_t searched = 0;
  while (true) {
    const std::size_t end_of_line = buffer_.find('\n', searched);
    if (end_of_line != std::string::npos) {
      LineAnswer answer{buffer_.substr(0, end_of_line), {}};
      buffer_.erase(0, end_of_line + 1);
      return answer;
    }
    searched = buffer_.size();
    if (searched > kMaxLineBytes) return {{}, "answers a line without end"};
    if (std::string problem = wait_for(from_child_, POLLIN, deadline); !problem.empty()) {
      return {{}, std::move(problem)};
    }
    std::array<char, 65536> chunk{};
    const ssize_t count = recv(from_child_, chunk.data(), chunk.size(), 0);
    if (count > 0) {
      buffer_.append(chunk.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return {{}, "ended without an answer"};
    }
  }
}

LineAnswer LineProcess::ask(std::string_view line, milliseconds limit) {
  if (process_ < 0) {
    if (std::string problem = start(); !problem.empty()) return {{}, std::move(problem)};
  }
  const Deadline deadline = steady_clock::now() + limit;
  LineAnswer answer;
  answer.error = write_all(fmt::format("{}\n", line), deadline);
  if (answer.error.empty()) answer = read_line(deadline);
  if (answer.error.empty()) return answer;
  const std::string how = end(milliseconds(0));
  answer.error = fmt::format("'{}' {}{}", command_[0], answer.error, how);
  return answer;
}

std::string LineProcess::end(milliseconds patience) {
  if (process_ < 0) return {};
  shutdown(to_child_, SHUT_RDWR);
  close(to_child_);
  int status = 0;
  const Deadline deadline = steady_clock::now() + patience;
  pid_t gone = waitpid(process_, &status, WNOHANG);
  while (gone == 0 && steady_clock::now() < deadline) {
    std::this_thread::sleep_for(milliseconds(2));
    gone = waitpid(process_, &status, WNOHANG);
  }
  if (gone == 0) {
    // One that is ending by itself shall be able to say how.
    std::this_thread::sleep_for(milliseconds(20));
    if (waitpid(process_, &status, WNOHANG) == 0) {
      kill(process_, SIGKILL);
      waitpid(process_, &status, 0);
      status = 0;
    }
  }
  process_ = to_child_ = from_child_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0) {
    return fmt::format(" (exit status {})", WEXITSTATUS(status));
  }
  if (WIFSIGNALED(status)) return fmt::format(" (killed by signal {})", WTERMSIG(status));
  return {};
}

}  // namespace jaywalk
