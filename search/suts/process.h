#pragma once

// A program that runs beside us and is spoken to in lines, with a time limit for each answer. It
// gets its own process group, so that what it started ends with it.

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace jaywalk::search {

class Process {
 public:
  /// Why there is no line: in words for people ("it ended with signal 11").
  struct Trouble {
    std::string what;
  };
  using Line = std::variant<std::string, Trouble>;

  /// Starts a program, found as a shell finds it, in `folder` (empty: the current one).
  [[nodiscard]] static std::variant<std::unique_ptr<Process>, Trouble> start(
      const std::vector<std::string>& command, const std::string& folder);
  /// Ends the program and all that it started.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Sends a line and waits for the one that answers it.
  [[nodiscard]] Line ask(std::string_view line, std::chrono::milliseconds limit);
  /// Lines received so far.
  [[nodiscard]] std::size_t lines() const { return lines_; }

 private:
  Process(int pid, int channel, int errors) : pid_(pid), channel_(channel), errors_(errors) {}

  [[nodiscard]] Trouble ended();
  void read_errors();

  int pid_;
  int channel_;  // its standard input and output
  int errors_;   // its standard error
  std::string buffer_;
  std::string last_error_;
  std::size_t lines_ = 0;
  bool pid_gone_ = false;  // waited for already
};

}  // namespace jaywalk::search
