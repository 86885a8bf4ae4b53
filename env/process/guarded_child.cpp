// SPDX-License-Identifier: Apache-2.0
#include "env/process/guarded_child.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// From here to guard_until_the_end() the code runs between fork and exec, where other threads may
// hold any lock: no memory is allocated and only async-signal-safe functions are called.

/// The program, arguments and descriptors of a process to start.
struct Plan {
  char* const* arguments;
  const char* folder;  // null: the current one
  ChildStreams streams;
  int trouble;  // takes the errno of what failed
};

void close_all_from(unsigned first, int except) {
  const auto kept = static_cast<unsigned>(except);
  if (kept > first) (void)syscall(SYS_close_range, first, kept - 1, 0U);
  (void)syscall(SYS_close_range, kept + 1, ~0U, 0U);
}

[[noreturn]] void give_up_start(const Plan& plan) {
  const int why = errno;
  (void)!write(plan.trouble, &why, sizeof why);
  _exit(127);
}

/// Puts signals back as a program expects them.
void reset_signals() {
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  for (const int signal : {SIGCHLD, SIGPIPE, SIGXFSZ, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    sigaction(signal, &usual, nullptr);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_program(Plan plan, pid_t guard) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != guard) _exit(127);  // the guard ended before prctl
  reset_signals();
  // Out of the way of the numbers 0 to 2, which are free if our own streams are closed.
  plan.trouble = fcntl(plan.trouble, F_DUPFD_CLOEXEC, 3);
  const int channel = fcntl(plan.streams.channel, F_DUPFD_CLOEXEC, 3);
  const bool own_errors = plan.streams.errors >= 0;
  const int errors = own_errors ? fcntl(plan.streams.errors, F_DUPFD_CLOEXEC, 3) : -1;
  if (dup2(channel, STDIN_FILENO) < 0) give_up_start(plan);
  if (dup2(channel, STDOUT_FILENO) < 0) give_up_start(plan);
  if (own_errors && dup2(errors, STDERR_FILENO) < 0) give_up_start(plan);
  if (plan.folder != nullptr && chdir(plan.folder) != 0) give_up_start(plan);
  execvp(plan.arguments[0], plan.arguments);
  give_up_start(plan);
}

/// Ends as the program did.
[[noreturn]] void repeat_end(int status) {
  if (WIFSIGNALED(status)) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    signal(WTERMSIG(status), SIG_DFL);
    reset_signals();
    raise(WTERMSIG(status));
  }
  _exit(WEXITSTATUS(status));
}

void note_child(int /*signal*/) {}

[[noreturn]] void guard_until_the_end(const Plan& plan, int lifeline) {
  setpgid(0, 0);
  struct sigaction noted {};
  noted.sa_handler = note_child;
  sigaction(SIGCHLD, &noted, nullptr);
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  sigprocmask(SIG_SETMASK, &child_ended, nullptr);
  const pid_t self = getpid();
  const pid_t program = fork();
  if (program < 0) give_up_start(plan);
  if (program == 0) become_program(plan, self);
  // A reader that waits for the end of a stream must not have to wait for this guard.
  close_all_from(0, lifeline);
  sigset_t nothing_blocked;
  sigemptyset(&nothing_blocked);
  while (true) {
    int status = 0;
    if (waitpid(program, &status, WNOHANG) == program) repeat_end(status);
    pollfd wait{lifeline, POLLIN, 0};
    if (ppoll(&wait, 1, nullptr, &nothing_blocked) > 0) kill(0, SIGKILL);
  }
}

/// A pair of descriptors that close at the end of its life, unless released.
class Pipe {
 public:
  Pipe() : failed_(pipe2(ends_.data(), O_CLOEXEC) != 0) {}
  ~Pipe() {
    for (int& end : ends_) close_end(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] int read_end() const { return ends_[0]; }
  [[nodiscard]] int write_end() const { return ends_[1]; }
  void close_write_end() { close_end(ends_[1]); }
  [[nodiscard]] int release_write_end() { return std::exchange(ends_[1], -1); }

 private:
  static void close_end(int& end) {
    if (end >= 0) close(std::exchange(end, -1));
  }
  std::array<int, 2> ends_{-1, -1};
  bool failed_;
};

/// Waits until the process has ended, but leaves it to be waited for: its number, and that of its
/// group, are not given to others until then.
bool has_ended(pid_t process) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == process;
}

}  // namespace

std::string wait_for_child(std::span<pollfd> descriptors,
                           std::chrono::steady_clock::time_point deadline) {
  using std::chrono::milliseconds;
  // A signal interrupts poll() in one thread only; the others have to look.
  constexpr std::int64_t kBetweenLooksMs = 50;
  while (!end_requested) {
    const auto left =
        std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    const auto patience = static_cast<int>(std::clamp<std::int64_t>(left, 0, kBetweenLooksMs));
    const int count = poll(descriptors.data(), descriptors.size(), patience);
    if (count > 0) return {};
    if (count < 0 && errno != EINTR) return std::strerror(errno);
    if (count == 0 && left <= kBetweenLooksMs) return std::string(kLate);
  }
  return std::string(kInterrupted);
}

std::string start_guarded(const std::vector<std::string>& command, const std::string& folder,
                          ChildStreams streams, GuardedChild& child) {
  Pipe trouble;
  Pipe lifeline;
  if (trouble.failed() || lifeline.failed()) return std::strerror(errno);
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& each : words) arguments.push_back(each.data());
  arguments.push_back(nullptr);
  const Plan plan{.arguments = arguments.data(),
                  .folder = folder.empty() ? nullptr : folder.c_str(),
                  .streams = streams,
                  .trouble = trouble.write_end()};
  const pid_t guard = fork();
  if (guard < 0) return fmt::format("cannot start '{}': {}", command[0], std::strerror(errno));
  if (guard == 0) {
    // Its own copy of the other end would keep it waiting.
    close(lifeline.write_end());
    guard_until_the_end(plan, lifeline.read_end());
  }
  setpgid(guard, guard);  // whichever of both is first
  trouble.close_write_end();
  int why = 0;
  ssize_t count = 0;
  do {
    count = read(trouble.read_end(), &why, sizeof why);
  } while (count < 0 && errno == EINTR);
  child = {.guard = guard, .lifeline = lifeline.release_write_end()};
  if (count <= 0) return {};
  end_guarded(child, milliseconds(1000));
  return fmt::format("cannot start '{}': {}", command[0], std::strerror(why));
}

int end_guarded(GuardedChild& child, milliseconds patience) {
  const auto deadline = steady_clock::now() + patience;
  bool ended = has_ended(child.guard);
  while (!ended && !end_requested && steady_clock::now() < deadline) {
    std::this_thread::sleep_for(milliseconds(1));
    ended = has_ended(child.guard);
  }
  kill(-child.guard, SIGKILL);  // before its number is free
  int status = 0;
  while (waitpid(child.guard, &status, 0) < 0 && errno == EINTR) {
  }
  close(child.lifeline);
  child = {};
  return ended ? status : -1;
}

}  // namespace jaywalk
