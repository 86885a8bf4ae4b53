#pragma once

// A child process that is asked one line and answers one line: how controllers and systems under
// test are attached that live outside of this program. The child's standard error is left alone.

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// What came of a question.
struct LineAnswer {
  /// Without its line break; of meaning only if `error` is empty.
  std::string line;
  /// Why there is none: the process could not be started, ended, or took too long.
  std::string error;
};

class LineProcess {
 public:
  /// Longer answers are refused.
  static constexpr std::size_t kMaxLineBytes = std::size_t{16} << 20U;

  /// Started when first asked. `command`: a program, found as the shell does, and its arguments.
  explicit LineProcess(std::vector<std::string> command) : command_(std::move(command)) {}
  /// Ends the process: its input is closed; if it does not go within a second it is killed.
  ~LineProcess();
  LineProcess(const LineProcess&) = delete;
  LineProcess& operator=(const LineProcess&) = delete;

  /// Sends a line and waits for the answer. After an error the process is gone; the next question
  /// starts it anew.
  [[nodiscard]] LineAnswer ask(std::string_view line, std::chrono::milliseconds limit);

 private:
  using Deadline = std::chrono::steady_clock::time_point;

  [[nodiscard]] std::string start();
  [[nodiscard]] std::string write_all(std::string_view text, Deadline deadline);
  [[nodiscard]] LineAnswer read_line(Deadline deadline);
  /// Ends the process and says how it ended.
  std::string end(std::chrono::milliseconds patience);

  std::vector<std::string> command_;
  int process_ = -1;
  int to_child_ = -1;
  int from_child_ = -1;
  std::string buffer_;  // read, but not yet answered
};

}  // namespace jaywalk
