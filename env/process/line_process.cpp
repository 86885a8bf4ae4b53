// SPDX-License-Identifier: Apache-2.0
#include "env/process/line_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "env/process/guarded_child.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::size_t kMostErrorBytes = 8 * 1024;
constexpr std::size_t kMostLastWords = 200;
/// How long a process that closed its output may take to end, so that it can be said how.
constexpr milliseconds kLastBreath{500};

/// Closes a file descriptor at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// For so long reading waits by itself: most answers come sooner, and need no poll() then.
void set_patience(int channel) {
  const timeval patience{.tv_sec = 0, .tv_usec = 20'000};
  (void)setsockopt(channel, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n ");
  if (end == std::string::npos) return {};
  const std::size_t line_break = text.rfind('\n', end);
  const std::size_t begin = line_break == std::string::npos ? 0 : line_break + 1;
  return text.substr(begin, std::min(end - begin + 1, kMostLastWords));
}

std::string late(milliseconds limit) {
  return fmt::format("no answer within {} s", static_cast<double>(limit.count()) / 1000);
}

}  // namespace

LineProcess::LineProcess(std::vector<std::string> command, std::string folder)
    : command_(std::move(command)), folder_(std::move(folder)) {}

LineProcess::~LineProcess() { finish(); }

std::string LineProcess::start() {
  if (command_.empty()) return "no program is given";
  // A pair of sockets, since writing to one whose other end is closed need not raise a signal.
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) {
    return std::strerror(errno);
  }
  Descriptor ours(pair[0]);
  const Descriptor theirs(pair[1]);
  std::array<int, 2> pipe{-1, -1};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) return std::strerror(errno);
  Descriptor read_end(pipe[0]);
  const Descriptor write_end(pipe[1]);
  // Our end alone: programs do not expect that writing to standard error may fail with EAGAIN.
  (void)fcntl(read_end.get(), F_SETFL, O_NONBLOCK);

  if (std::string problem = start_guarded(
          command_, folder_, {.channel = theirs.get(), .errors = write_end.get()}, child_);
      !problem.empty()) {
    return problem;
  }
  channel_ = ours.release();
  set_patience(channel_);
  error_pipe_ = read_end.release();
  buffer_.clear();
  errors_.clear();
  lines_ = 0;
  return {};
}

/// Reads the child's standard error meanwhile, so that a full pipe never blocks the child.
std::string LineProcess::wait_for(short events, Deadline deadline) {
  while (true) {
    std::array<pollfd, 2> waits{pollfd{channel_, events, 0}, pollfd{error_pipe_, POLLIN, 0}};
    if (std::string why = wait_for_child(waits, deadline); !why.empty()) return why;
    if (waits[1].revents != 0) read_errors();
    if (waits[0].revents != 0) return {};
    // One that writes errors without end is always ready.
    if (steady_clock::now() >= deadline) return std::string(kLate);
  }
}

std::string LineProcess::write_all(std::string_view text, Deadline deadline) {
  while (!text.empty()) {
    const ssize_t written = send(channel_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (written > 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      if (std::string why = wait_for(POLLOUT, deadline); !why.empty()) return why;
    } else if (errno != EINTR) {
      return ended();
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
      ++lines_;
      return answer;
    }
    searched = buffer_.size();
    if (searched > kMaxLineBytes) return {{}, "its answer is longer than 16 MB"};
    std::array<char, 4096> chunk{};  // answers are short, and clearing more costs more than they do
    const ssize_t count = recv(channel_, chunk.data(), chunk.size(), 0);
    if (count > 0) {
      buffer_.append(chunk.data(), static_cast<std::size_t>(count));
    } else if (count < 0 && errno == EAGAIN) {
      if (std::string why = wait_for(POLLIN, deadline); !why.empty()) return {{}, why};
    } else if (count == 0 || errno != EINTR) {
      return {{}, ended()};
    }
  }
}

std::optional<std::string> LineProcess::unasked(milliseconds settling) {
  const Deadline deadline = steady_clock::now() + settling;
  const bool patient = settling.count() > 0;
  if (buffer_.empty() && (!patient || wait_for(POLLIN, deadline).empty())) read_what_is_there();
  return unasked_so_far();
}

std::optional<std::string> LineProcess::unasked_so_far() const {
  if (buffer_.empty()) return std::nullopt;
  return buffer_.substr(0, buffer_.find('\n'));
}

/// Does not report the end of the child's output; the next question does.
void LineProcess::read_what_is_there() {
  std::array<char, 256> chunk{};
  const ssize_t count = recv(channel_, chunk.data(), chunk.size(), MSG_DONTWAIT);
  if (count > 0) buffer_.assign(chunk.data(), static_cast<std::size_t>(count));
}

LineAnswer LineProcess::ask(std::string_view line, milliseconds limit) {
  LineAnswer failed = send_lines(line, limit);
  return failed.error.empty() ? next_answer(limit) : failed;
}

LineAnswer LineProcess::send_lines(std::string_view text, milliseconds limit) {
  if (child_.guard < 0) {
    if (std::string problem = start(); !problem.empty()) return {{}, std::move(problem)};
  } else if (const auto unread = unasked(milliseconds(0))) {
    give_up();
    const std::string quoted = shortened(*unread, kMostQuoted);
    return {{}, fmt::format("it wrote '{}' without being asked", quoted), true};
  }
  const Deadline deadline = steady_clock::now() + limit;
  return checked({{}, write_all(fmt::format("{}\n", text), deadline)}, limit);
}

LineAnswer LineProcess::next_answer(milliseconds limit) {
  return checked(read_line(steady_clock::now() + limit), limit);
}

LineAnswer LineProcess::checked(LineAnswer answer, milliseconds limit) {
  if (answer.error == kLate) answer.error = late(limit);
  if (!answer.error.empty()) give_up();
  return answer;
}

void LineProcess::tell(std::string_view line, std::chrono::milliseconds limit) {
  if (child_.guard < 0) return;
  const std::string failed = write_all(fmt::format("{}\n", line), steady_clock::now() + limit);
  if (!failed.empty()) give_up();
}

void LineProcess::read_errors() {
  std::array<char, 4096> chunk{};
  // Twice what a pipe holds: a process that writes on and on must not keep us here.
  for (int chunks = 0; chunks < 32; ++chunks) {
    const ssize_t count = read(error_pipe_, chunk.data(), chunk.size());
    if (count < 0 && errno == EAGAIN) return;
    if (count <= 0) {
      // Closed at its other end: poll would return at once from now on.
      close(std::exchange(error_pipe_, -1));
      return;
    }
    errors_.append(chunk.data(), static_cast<std::size_t>(count));
    if (errors_.size() > 2 * kMostErrorBytes) errors_.erase(0, errors_.size() - kMostErrorBytes);
  }
}

std::string LineProcess::ended() {
  const int status = end(kLastBreath);
  std::string what = "it closed its output before it answered";
  if (status >= 0 && WIFSIGNALED(status)) {
    what = fmt::format("it died of signal {}", WTERMSIG(status));
  } else if (status >= 0 && WIFEXITED(status)) {
    what = fmt::format("it ended with exit code {} before it answered", WEXITSTATUS(status));
  }
  const std::string words = last_line(errors_);
  return words.empty() ? what : fmt::format("{}; its last words were '{}'", what, words);
}

std::string LineProcess::take_errors() {
  if (error_pipe_ >= 0) read_errors();
  std::string text = std::exchange(errors_, {});
  text.erase(text.find_last_not_of("\r\n ") + 1);
  if (text.size() <= kMostErrorBytes) return text;
  // From the beginning of a line.
  const std::size_t line_break = text.find('\n', text.size() - kMostErrorBytes);
  const std::size_t begin =
      line_break == std::string::npos ? text.size() - kMostErrorBytes : line_break + 1;
  return fmt::format("... (its last {} bytes)\n{}", text.size() - begin, text.substr(begin));
}

int LineProcess::end(milliseconds patience) {
  if (child_.guard < 0) return -1;
  shutdown(channel_, SHUT_RDWR);
  close(std::exchange(channel_, -1));
  const int status = end_guarded(child_, patience);
  if (error_pipe_ >= 0) read_errors();
  if (error_pipe_ >= 0) close(std::exchange(error_pipe_, -1));
  return status;
}

}  // namespace jaywalk
