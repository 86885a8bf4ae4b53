// SPDX-License-Identifier: Apache-2.0
#pragma once

// The terminal, as the commands see it: results on standard output, everything else on standard
// error, colours where they are wanted.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "tools/jaywalk/options/command_line.h"

namespace spdlog {
class logger;
}

namespace jaywalk {

enum class ExitCode : int {
  success = 0,
  failed = 1,     // the run failed, or a verdict asked for
  usage = 2,      // wrong usage or input
  internal = 70,  // our mistake
  interrupted = 130,
};

enum class ColourChoice { automatic, always, never };

enum class LogLevel { debug, info, warning, error };

class Console {
 public:
  explicit Console(ColourChoice choice = ColourChoice::automatic);

  /// To standard output, buffered; what goes to standard error meanwhile comes after it.
  void print(std::string_view text);
  /// Prints control codes of the terminal unchanged. Texts that we did not write must go through
  /// print(), which removes their control codes, except for colours.
  void control(std::string_view codes);
  /// Writes all buffered output.
  void flush();
  /// Whether standard output still has a reader; false once a pipe is closed.
  [[nodiscard]] static bool can_print();
  /// Sets the command line in which errors of options are shown from now on.
  void set_command_line(CommandLine line);
  /// Prints diagnostics of the user's files and options.
  void report(const Diagnostics& diagnostics);
  /// `error: message` and, on a line of its own, the hint.
  void error(std::string_view message, std::string_view hint = {});
  /// Prints a plain line to standard error, such as the last line of a long run.
  void note(std::string_view line);
  /// Remembers a file or folder that was written, for tell_written().
  void wrote(const std::string& path);
  /// Prints one line that names the written files; no line if there are none, or only devices.
  void tell_written();
  /// A line of a run's log. `message` may have several lines.
  void log(LogLevel level, std::string_view message);
  /// Like log(), of a warning `[agent] text`: the same text, of whichever agent, is logged a few
  /// times and then only counted.
  void warn_of_agent(std::string_view message);
  /// Logs how often warnings were counted, once a run is over.
  void tell_counted();
  /// Messages below this level are not logged. The default is to log warnings and errors.
  void set_log_level(LogLevel level);

  [[nodiscard]] Colour output_colour() const { return output_colour_; }
  [[nodiscard]] Colour error_colour() const { return error_colour_; }
  [[nodiscard]] bool output_is_terminal() const { return output_is_terminal_; }
  [[nodiscard]] bool error_is_terminal() const { return error_is_terminal_; }

  /// Flushes; false, after reporting it, if not everything could be written.
  [[nodiscard]] bool finish();

 private:
  bool output_is_terminal_;
  bool error_is_terminal_;
  Colour output_colour_;
  Colour error_colour_;
  CommandLine command_line_;
  std::shared_ptr<spdlog::logger> logger_;
  std::vector<std::string> written_;
  /// How often agents had a warning, by its text without the agent's name.
  std::map<std::string, std::uint64_t, std::less<>> warnings_;
};

}  // namespace jaywalk
