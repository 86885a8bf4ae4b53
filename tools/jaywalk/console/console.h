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
  /// The same for codes of the terminal: what they do is up to the caller. Texts of others are for
  /// print(), which lets none of theirs but colours come to a terminal.
  void control(std::string_view codes);
  /// Everything printed so far leaves the program.
  void flush();
  /// What is printed still gets somewhere: the reader has not closed the pipe.
  [[nodiscard]] static bool can_print();
  /// Of the words that errors of options are shown in from now on.
  void set_command_line(CommandLine line);
  /// Diagnostics of what the user wrote.
  void report(const Diagnostics& diagnostics);
  /// `error: message` and, on a line of its own, the hint.
  void error(std::string_view message, std::string_view hint = {});
  /// A plain line to standard error: what a long run says at its end.
  void note(std::string_view line);
  /// Remembers a file or folder that was written, for tell_written().
  void wrote(const std::string& path);
  /// Names what was written, in one line; nothing if that is nothing, or a device.
  void tell_written();
  /// A line of a run's log. `message` may have several lines.
  void log(LogLevel level, std::string_view message);
  /// Like log(), of a warning `[agent] text`: the same text, of whichever agent, is logged a few
  /// times and then only counted.
  void warn_of_agent(std::string_view message);
  /// Logs how often warnings were counted, once a run is over.
  void tell_counted();
  /// What is less than this is not logged: warnings and errors are, at first.
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
