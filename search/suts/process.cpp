#include "search/suts/process.h"

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
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

namespace jaywalk::search {
namespace {

constexpr std::size_t kMostLine = std::size_t{1} << 24U;
constexpr std::size_t kShownError = 200;

using Clock = std::chrono::steady_clock;

/// Closes a file descriptor at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
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

/// posix_spawn's settings: the streams, the folder, a process group of its own.
class SpawnSettings {
 public:
  SpawnSettings(int channel, int errors, const std::string& folder) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_adddup2(&actions_, channel, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, channel, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n ");
  if (end == std::string::npos) return {};
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin + 1) + 1);
}

bool send_all(int channel, std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = send(channel, text.data(), text.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

}  // namespace

std::variant<std::unique_ptr<Process>, Process::Trouble> Process::start(
    const std::vector<std::string>& command, const std::string& folder) {
  std::array<int, 2> channel{};
  std::array<int, 2> errors{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel.data()) != 0) {
    return Trouble{std::strerror(errno)};
  }
  Descriptor ours(channel[0]);
  const Descriptor theirs(channel[1]);
  if (pipe2(errors.data(), O_CLOEXEC | O_NONBLOCK) != 0) return Trouble{std::strerror(errno)};
  Descriptor read_end(errors[0]);
  const Descriptor write_end(errors[1]);

  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const SpawnSettings settings(theirs.get(), write_end.get(), folder);
  pid_t pid = 0;
  const int failure = posix_spawnp(&pid, arguments[0], settings.actions(), settings.attributes(),
                                   arguments.data(), environ);
  if (failure != 0) {
    return Trouble{fmt::format("cannot start '{}': {}", command.front(), std::strerror(failure))};
  }
  return std::unique_ptr<Process>(new Process(pid, ours.release(), read_end.release()));
}

Process::~Process() {
  kill(-pid_, SIGKILL);
  if (!pid_gone_) waitpid(pid_, nullptr, 0);
  close(channel_);
  close(errors_);
}

void Process::read_errors() {
  std::array<char, 4096> chunk{};
  while (true) {
    const ssize_t count = read(errors_, chunk.data(), chunk.size());
    if (count <= 0) return;
    last_error_.append(chunk.data(), static_cast<std::size_t>(count));
    if (last_error_.size() > kMostLine) last_error_.erase(0, last_error_.size() - chunk.size());
  }
}

Process::Trouble Process::ended() {
  // It closed its output, so it is ending by itself or will not answer any more.
  constexpr int kTries = 50;
  int status = 0;
  pid_t waited = 0;
  for (int i = 0; i < kTries && waited == 0; ++i) {
    waited = waitpid(pid_, &status, WNOHANG);
    if (waited == 0) usleep(10'000);
  }
  kill(-pid_, SIGKILL);
  std::string what = "it closed its output before it answered";
  if (waited == pid_) {
    pid_gone_ = true;
    if (WIFSIGNALED(status)) what = fmt::format("it died of signal {}", WTERMSIG(status));
    if (WIFEXITED(status)) {
      what = fmt::format("it ended with exit code {} before it answered", WEXITSTATUS(status));
    }
  }
  read_errors();
  const std::string words = last_line(last_error_).substr(0, kShownError);
  if (!words.empty()) what += fmt::format("; its last words were '{}'", words);
  return {what};
}

Process::Line Process::ask(std::string_view line, std::chrono::milliseconds limit) {
  const auto deadline = Clock::now() + limit;
  if (!send_all(channel_, std::string(line) + '\n')) return ended();
  while (true) {
    const std::size_t end = buffer_.find('\n');
    if (end != std::string::npos) {
      std::string answer = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      ++lines_;
      return answer;
    }
    if (buffer_.size() > kMostLine) return Trouble{"its answer is longer than 16 MB"};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) {
      return Trouble{
          fmt::format("no answer within {} s", static_cast<double>(limit.count()) / 1000)};
    }
    std::array<pollfd, 2> waits{pollfd{channel_, POLLIN, 0}, pollfd{errors_, POLLIN, 0}};
    const int ready =
        poll(waits.data(), waits.size(), static_cast<int>(std::min<long>(left.count(), 60'000)));
    if (ready <= 0) continue;
    if ((waits[1].revents & POLLIN) != 0) read_errors();
    if (waits[0].revents == 0) continue;
    std::array<char, 65536> chunk{};
    const ssize_t count = recv(channel_, chunk.data(), chunk.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return ended();
    buffer_.append(chunk.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace jaywalk::search
