// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/sumo/sumo_process.h"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "env/process/guarded_child.h"

namespace jaywalk {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// A SUMO that takes longer to read its map, or for a step, is taken for dead.
constexpr milliseconds kStartLimit{60'000};
constexpr milliseconds kAnswerLimit{30'000};
constexpr int kTries = 8;
constexpr std::size_t kMostWords = 400;

/// Both streams of a child that says nothing.
class Nothing {
 public:
  Nothing() : number_(open("/dev/null", O_RDWR | O_CLOEXEC)) {}
  ~Nothing() {
    if (number_ >= 0) close(number_);
  }
  Nothing(const Nothing&) = delete;
  Nothing& operator=(const Nothing&) = delete;
  [[nodiscard]] int get() const { return number_; }

 private:
  int number_;
};

/// SUMO's output about an error, without the lines that it always writes.
std::string last_words(const std::string& text) {
  std::string last;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const bool usual = line.empty() || line.starts_with("Quitting") ||
                       line.find("SUMO_HOME") != std::string::npos ||
                       line.find("peer shutdown") != std::string::npos;
    if (!usual) last = std::move(line);
  }
  return last.substr(0, kMostWords);
}

/// The data folder (types of lanes, schemas) of the SUMO that PATH finds; empty if there is none.
std::string data_folder() {
  namespace fs = std::filesystem;
  const char* const path = std::getenv("PATH");
  std::istringstream folders{path == nullptr ? "" : path};
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code error;
    const fs::path program = fs::canonical(fs::path(folder) / "sumo", error);
    if (error) continue;
    const fs::path home = program.parent_path().parent_path() / "share" / "sumo";
    return fs::is_directory(home / "data", error) ? home.string() : "";
  }
  return {};
}

/// Without SUMO_HOME its programs do without their data, or look for it on the web.
std::string start_of_package(std::vector<std::string> command, ChildStreams streams,
                             GuardedChild& child) {
  const std::string home = std::getenv("SUMO_HOME") == nullptr ? data_folder() : "";
  if (!home.empty()) command.insert(command.begin(), {"env", "SUMO_HOME=" + home});
  std::string problem = start_guarded(command, {}, streams, child);
  if (problem.empty()) return {};
  return problem + "; it is part of the Debian package 'sumo' (apt-get install sumo)";
}

}  // namespace

MemoryFile::MemoryFile() : descriptor_(memfd_create("jaywalk", MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::string MemoryFile::path() const {
  return fmt::format("/proc/{}/fd/{}", getpid(), descriptor_);
}

bool MemoryFile::write(std::string_view text) {
  // Children that write to it share its place.
  if (ftruncate(descriptor_, 0) != 0 || lseek(descriptor_, 0, SEEK_SET) != 0) return false;
  off_t place = 0;
  while (!text.empty()) {
    const ssize_t written = pwrite(descriptor_, text.data(), text.size(), place);
    if (written <= 0) return false;
    place += written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string MemoryFile::read(std::size_t most) const {
  struct stat about {};
  if (fstat(descriptor_, &about) != 0) return {};
  const auto size = static_cast<std::size_t>(about.st_size);
  std::string text(std::min(size, most), '\0');
  const ssize_t count =
      pread(descriptor_, text.data(), text.size(), static_cast<off_t>(size - text.size()));
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return text;
}

std::string run_sumo_tool(const std::vector<std::string>& command, std::string* output) {
  const MemoryFile printed;
  const MemoryFile errors;
  GuardedChild child;
  std::string problem = start_of_package(
      command, {.channel = printed.descriptor(), .errors = errors.descriptor()}, child);
  if (!problem.empty()) return problem;
  const int status = end_guarded(child, kStartLimit);
  if (output != nullptr) *output = printed.read(1 << 16);
  if (status == 0) return {};
  const std::string words = last_words(errors.read(1 << 16));
  const std::string how = status < 0
                              ? fmt::format("took longer than {} s", kStartLimit.count() / 1000)
                          : WIFSIGNALED(status) ? fmt::format("died of signal {}", WTERMSIG(status))
                                                : fmt::format("failed ({})", WEXITSTATUS(status));
  return fmt::format("'{}' {}{}{}", command.front(), how, words.empty() ? "" : ": ", words);
}

std::string sumo_version(std::string& version) {
  std::string printed;
  std::string problem = run_sumo_tool({"sumo", "--version"}, &printed);
  if (!problem.empty()) return problem;
  // "Eclipse SUMO sumo Version 1.15.0"
  constexpr std::string_view kBefore = "Version ";
  const std::size_t begin = printed.find(kBefore);
  version = begin == std::string::npos
                ? "unknown"
                : printed.substr(begin + kBefore.size(),
                                 printed.find_first_of(" \n", begin + kBefore.size()) - begin -
                                     kBefore.size());
  return {};
}

bool SumoProcess::connect_within(int port, milliseconds limit) {
  const auto deadline = steady_clock::now() + limit;
  while (!client_.connect(port)) {
    siginfo_t info{};
    const bool ended =
        waitid(P_PID, static_cast<id_t>(child_.guard), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid == child_.guard;
    if (ended || end_requested || steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return true;
}

std::string SumoProcess::try_port(const std::vector<std::string>& options, const std::string& token,
                                  bool& again) {
  const int port = free_port();
  if (port == 0) return "there is no free port";
  std::vector<std::string> command{"sumo", "--remote-port", std::to_string(port), "--num-clients",
                                   "1"};
  command.insert(command.end(), options.begin(), options.end());
  const Nothing nothing;
  if (!errors_.write({})) return "there is no memory for its messages";
  std::string problem =
      start_of_package(command, {.channel = nothing.get(), .errors = errors_.descriptor()}, child_);
  if (!problem.empty()) return problem;
  if (!connect_within(port, kStartLimit)) {
    problem = with_last_words("it did not start");
    // Somebody else was quicker to take the port.
    again =
        problem.find("ddress") != std::string::npos || problem.find("bind") != std::string::npos;
    return problem;
  }
  TraciMessage hello;
  hello.version();
  hello.get(TraciCommand::vehicle_type_get, TraciVariable::ids, {});
  const TraciAnswer answer = client_.ask(hello, kStartLimit);
  if (!answer.error.empty()) {
    again = true;
    return with_last_words(answer.error);
  }
  version_ = answer.version;
  const TraciValue* const types = answer.objects.front().find(TraciVariable::ids, TraciType::texts);
  if (types != nullptr && std::ranges::find(types->texts, token) != types->texts.end()) return {};
  again = true;
  end();
  return "another program answers at its port";
}

std::string SumoProcess::start(const std::vector<std::string>& options, const std::string& token) {
  end();
  std::string problem;
  bool again = true;
  for (int i = 0; i < kTries && again && !end_requested; ++i) {
    again = false;
    problem = try_port(options, token, again);
    if (problem.empty()) return {};
  }
  return problem;
}

TraciAnswer SumoProcess::ask(const TraciMessage& message) {
  TraciAnswer answer = client_.ask(message, kAnswerLimit);
  if (!answer.error.empty()) answer.error = with_last_words(std::move(answer.error));
  return answer;
}

std::vector<TraciAnswer> SumoProcess::ask(std::span<const TraciMessage> messages) {
  std::vector<TraciAnswer> answers = client_.ask(messages, kAnswerLimit);
  if (answers.empty() || answers.back().error.empty()) return answers;
  answers.back().error = with_last_words(std::move(answers.back().error));
  return answers;
}

/// Ends it.
std::string SumoProcess::with_last_words(std::string what) {
  const bool refused = client_.is_connected();
  client_.disconnect();
  // A SUMO that closed the connection is ending; its exit status follows in a moment.
  const int status = child_.guard >= 0 ? end_guarded(child_, milliseconds(refused ? 0 : 500)) : -1;
  if (refused) return what;
  if (status >= 0 && WIFSIGNALED(status))
    what = fmt::format("it died of signal {}", WTERMSIG(status));
  const std::string words = last_words(errors_.read(1 << 16));
  return words.empty() ? what : fmt::format("{}; its last words were '{}'", what, words);
}

void SumoProcess::end() {
  client_.disconnect();
  if (child_.guard >= 0) (void)end_guarded(child_, milliseconds(0));
}

}  // namespace jaywalk
