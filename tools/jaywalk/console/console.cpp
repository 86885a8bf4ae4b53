// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/console.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/ansicolor_sink.h>

#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

/// Files that are named when a command has written them; further ones are counted.
constexpr std::size_t kMostWrittenNamed = 10;

/// Warnings of agents with the same text that are logged; further ones are counted.
constexpr std::uint64_t kSameWarnings = 5;
/// Texts that are counted; all warnings with others are logged.
constexpr std::size_t kMostDistinctWarnings = 1000;

Colour colour_for(ColourChoice choice, bool is_terminal) {
  if (choice != ColourChoice::automatic) {
    return choice == ColourChoice::always ? Colour::on : Colour::off;
  }
  // See no-color.org: set and not empty.
  const char* const no_colour = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool unwanted = (no_colour != nullptr && *no_colour != '\0') ||
                        (terminal != nullptr && std::string_view(terminal) == "dumb");
  return is_terminal && !unwanted ? Colour::on : Colour::off;
}

/// To standard error. Text that cannot be written there is lost; fmt::print() would throw.
void print_error(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

constexpr spdlog::level::level_enum spdlog_level(LogLevel level) {
  constexpr std::array kLevels = {spdlog::level::debug, spdlog::level::info, spdlog::level::warn,
                                  spdlog::level::err};
  return kLevels[static_cast<std::size_t>(level)];
}

std::shared_ptr<spdlog::logger> make_logger(Colour colour) {
  const auto mode = colour == Colour::on ? spdlog::color_mode::always : spdlog::color_mode::never;
  auto sink = std::make_shared<spdlog::sinks::ansicolor_stderr_sink_mt>(mode);
  sink->set_pattern("%^%l%$: %v");
  auto logger = std::make_shared<spdlog::logger>("jaywalk", std::move(sink));
  logger->set_level(spdlog::level::warn);
  return logger;
}

}  // namespace

Console::Console(ColourChoice choice)
    : output_is_terminal_(::isatty(STDOUT_FILENO) == 1),
      error_is_terminal_(::isatty(STDERR_FILENO) == 1),
      output_colour_(colour_for(choice, output_is_terminal_)),
      error_colour_(colour_for(choice, error_is_terminal_)),
      logger_(make_logger(error_colour_)) {}

void Console::print(std::string_view text) {
  if (output_is_terminal_) {
    control(visible_with_colours(text));
  } else {
    control(text);
  }
}

void Console::control(std::string_view codes) {
  std::fwrite(codes.data(), 1, codes.size(), stdout);
}

void Console::flush() { std::fflush(stdout); }

bool Console::can_print() { return std::ferror(stdout) == 0; }

void Console::set_command_line(CommandLine line) { command_line_ = std::move(line); }

void Console::report(const Diagnostics& diagnostics) {
  flush();
  print_error(command_line_.render(diagnostics, error_colour_));
}

void Console::error(std::string_view message, std::string_view hint) {
  const bool colour = error_colour_ == Colour::on;
  flush();
  print_error(fmt::format("{}error:{} {}\n", colour ? "\x1b[1;31m" : "", colour ? "\x1b[0m" : "",
                          visible(message, LineBreaks::kept)));
  if (!hint.empty()) note(fmt::format("  hint: {}", hint));
}

void Console::note(std::string_view line) {
  flush();
  print_error(visible(line, LineBreaks::kept) + '\n');
}

void Console::wrote(const std::string& path) {
  const bool is_known = std::ranges::find(written_, path) != written_.end();
  if (!is_known && !path.starts_with("/dev/")) written_.push_back(path);
}

void Console::tell_written() {
  if (written_.empty()) return;
  const std::size_t shown = std::min(kMostWrittenNamed, written_.size());
  std::string names = fmt::format("{}", fmt::join(std::span(written_).first(shown), ", "));
  if (written_.size() > shown) names += fmt::format(" and {} more", written_.size() - shown);
  note("wrote " + names);
  written_.clear();
}

void Console::log(LogLevel level, std::string_view message) {
  if (!logger_->should_log(spdlog_level(level))) return;
  flush();
  logger_->log(spdlog_level(level), visible(message, LineBreaks::kept));
}

void Console::warn_of_agent(std::string_view message) {
  constexpr std::string_view kNameEnd = "] ";
  const std::size_t end = message.find(kNameEnd);
  const std::string_view text =
      end == message.npos ? message : message.substr(end + kNameEnd.size());
  auto found = warnings_.find(text);
  if (found == warnings_.end() && warnings_.size() < kMostDistinctWarnings) {
    found = warnings_.emplace(text, 0).first;
  }
  if (found == warnings_.end() || ++found->second <= kSameWarnings) log(LogLevel::warning, message);
}

void Console::tell_counted() {
  for (const auto& [text, times] : std::exchange(warnings_, {})) {
    if (times <= kSameWarnings) continue;
    const std::string_view first_line = std::string_view(text).substr(0, text.find('\n'));
    log(LogLevel::warning, fmt::format("{} more: {}", times - kSameWarnings, first_line));
  }
}

void Console::set_log_level(LogLevel level) { logger_->set_level(spdlog_level(level)); }

bool Console::finish() {
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!written) {
    const std::string why = errno == 0 ? "write error" : std::generic_category().message(errno);
    error(fmt::format("cannot write to standard output: {}", why));
  }
  return written;
}

}  // namespace jaywalk
