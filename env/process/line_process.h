// SPDX-License-Identifier: Apache-2.0
#pragma once

// A child process that receives one line and answers one line: external controllers and systems
// under test are attached so. It and the processes that it started end with us (guarded_child.h).

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/process/guarded_child.h"

namespace jaywalk {

/// The answer to a question, or why there is none.
struct LineAnswer {
  /// Without its line break; of meaning only if `error` is empty.
  std::string line;
  /// Why there is none, in words for people: "it died of signal 11".
  std::string error;
  /// The error is that the process had written something without being asked.
  bool unasked = false;
};

class LineProcess {
 public:
  /// Longer answers are refused.
  static constexpr std::size_t kMaxLineBytes = std::size_t{16} << 20U;

  /// Started when first asked. `command`: a program, found as the shell does, and its arguments;
  /// `folder`: where it runs, empty for the current one.
  explicit LineProcess(std::vector<std::string> command, std::string folder = {});
  /// Ends the process: its input is closed; if it does not go within a second it is killed.
  ~LineProcess();
  LineProcess(const LineProcess&) = delete;
  LineProcess& operator=(const LineProcess&) = delete;

  /// Sends a line and waits for the answer, until the program is asked to end (guarded_child.h).
  /// Output that is unread before the line is sent answers nothing: it is an error, since all
  /// answers after it would belong to other questions. After an error the process is gone; the next
  /// question starts it anew.
  [[nodiscard]] LineAnswer ask(std::string_view line, std::chrono::milliseconds limit);
  /// ask() in two parts, for several questions at once. send_lines() sends `text`, lines without
  /// the last line break, and returns only an error; next_answer() waits for the answer to the next
  /// of those lines.
  [[nodiscard]] LineAnswer send_lines(std::string_view text, std::chrono::milliseconds limit);
  [[nodiscard]] LineAnswer next_answer(std::chrono::milliseconds limit);
  /// Sends a line that needs no answer, to a process that was asked before. Kills a process that
  /// does not read it within the limit.
  void tell(std::string_view line, std::chrono::milliseconds limit);
  /// The first line, or its beginning, that the process has written without being asked, or writes
  /// within `settling`.
  [[nodiscard]] std::optional<std::string> unasked(std::chrono::milliseconds settling);
  /// Like unasked(), but looks only at output that was read together with the last answer.
  [[nodiscard]] std::optional<std::string> unasked_so_far() const;
  /// Kills the process, as after an error: for an answer that makes no sense.
  void give_up() { end(std::chrono::milliseconds(0)); }
  /// Ends the process as the destructor does, so that take_errors() has its last words.
  void finish() { end(std::chrono::milliseconds(1000)); }
  /// Its standard error since the last call, without the last line break; a long text is cut at its
  /// beginning. If the process ends early, the last line is part of the error, too.
  [[nodiscard]] std::string take_errors();
  /// Lines answered since the process was started.
  [[nodiscard]] std::size_t lines() const { return lines_; }

 private:
  using Deadline = std::chrono::steady_clock::time_point;

  [[nodiscard]] std::string start();
  /// Why the channel is not ready; empty if it is.
  [[nodiscard]] std::string wait_for(short events, Deadline deadline);
  [[nodiscard]] std::string write_all(std::string_view text, Deadline deadline);
  [[nodiscard]] LineAnswer read_line(Deadline deadline);
  void read_what_is_there();
  void read_errors();
  /// Waits for the process to end by itself, then kills it: the status of waitpid, -1 if killed.
  int end(std::chrono::milliseconds patience);
  [[nodiscard]] std::string ended();
  [[nodiscard]] LineAnswer checked(LineAnswer answer, std::chrono::milliseconds limit);

  std::vector<std::string> command_;
  std::string folder_;
  GuardedChild child_;
  int channel_ = -1;     // its standard input and output
  int error_pipe_ = -1;  // its standard error
  std::string buffer_;   // read, but not yet answered
  std::string errors_;   // the end of its standard error, as far as that was not taken
  std::size_t lines_ = 0;
};

/// The most bytes of a process's output that messages quote.
inline constexpr std::size_t kMostQuoted = 80;

}  // namespace jaywalk
