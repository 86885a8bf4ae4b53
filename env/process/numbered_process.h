// SPDX-License-Identifier: Apache-2.0
#pragma once

// A child process that answers questions in lines of JSON, each question with its number. The
// answer may repeat the number; if it does, it is checked, so that question and answer cannot get
// out of step. Read line_process.h first.

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/process/line_process.h"

namespace jaywalk {

/// The answer to a question, or why there is none.
struct JsonAnswer {
  /// An object; of meaning only if `error` is empty.
  nlohmann::json json;
  /// Why there is none, in words for people.
  std::string error;
  /// The process said nothing in answer (it hung, it died), rather than something wrong.
  bool silent = false;
};

class NumberedProcess {
 public:
  struct Settings {
    /// As LineProcess takes them.
    std::vector<std::string> command;
    std::string folder;
    /// The key of the number, in question and answer.
    std::string_view key;
    /// How long to look, after an answer that does not repeat its number, whether the process says
    /// more than it was asked.
    std::chrono::milliseconds settling{0};
  };

  explicit NumberedProcess(Settings settings);

  /// Sends `question`, an object, with its number. After an error, other than one that the process
  /// reports about itself, the process is gone; the next question starts it anew.
  [[nodiscard]] JsonAnswer ask(nlohmann::json question, std::size_t number,
                               std::chrono::milliseconds limit);
  /// Like ask(), for a question that is one line of text already and contains its number.
  [[nodiscard]] JsonAnswer ask_text(std::string_view question, std::size_t number,
                                    std::chrono::milliseconds limit);
  /// Several of those, whose numbers count on from `first`; the process may read one while it
  /// answers another. The answers up to the first error.
  [[nodiscard]] std::vector<JsonAnswer> ask_texts(std::span<const std::string> questions,
                                                  std::size_t first,
                                                  std::chrono::milliseconds limit);
  /// An error if it has answered the last question with more than one line, or does so within
  /// `settling`; the process is ended then. Empty otherwise.
  [[nodiscard]] std::string said_more(std::chrono::milliseconds settling);
  /// Sends an object that needs no answer; does nothing if the process is gone.
  void tell(const nlohmann::json& line, std::chrono::milliseconds limit);
  /// Ends the process because its last answer makes no sense. Returns the message for the user: the
  /// answer, the number of that line of its output, and `why`.
  [[nodiscard]] std::string refuse(std::string_view why);
  /// Like the functions of LineProcess.
  void finish() { process_.finish(); }
  [[nodiscard]] std::string take_errors() { return process_.take_errors(); }

 private:
  [[nodiscard]] std::string complaint(const std::optional<std::string>& text);
  [[nodiscard]] JsonAnswer read(LineAnswer answer, std::size_t number);
  /// Why an object is no answer to that question; empty if it is one.
  [[nodiscard]] std::string mismatch(const nlohmann::json& answer, std::size_t number);

  Settings settings_;
  LineProcess process_;
  std::string last_;  // the last line that it answered
  bool asked_ = false;
  bool repeats_ = false;  // it repeated a number, and has to from then on
};

/// A number as it is written for other programs: rounded to nine digits after the point, as the
/// rest is noise of the arithmetic; -0 becomes 0.
[[nodiscard]] double tidy(double value);

/// A list of both.
[[nodiscard]] nlohmann::json tidy_pair(double first, double second);

}  // namespace jaywalk
