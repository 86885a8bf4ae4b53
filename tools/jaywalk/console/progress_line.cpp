// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/progress_line.h"

#include <cstdio>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_text(const Progress& progress, double seconds) {
  const auto done = static_cast<double>(progress.done);
  const auto total = static_cast<double>(progress.total);
  std::string text = fmt::format("{} of {} tests ({:.0f} %)", progress.done, progress.total,
                                 progress.total > 0 ? 100 * done / total : 100.0);
  if (progress.done == 0 || seconds <= 0) return text;
  const double rate = done / seconds;
  return text + fmt::format(", {:.{}f} per second, {} left", rate, rate < 10 ? 1 : 0,
                            duration_text((total - done) / rate));
}

std::string progress_text(const search::SearchProgress& progress, double seconds) {
  std::string text = fmt::format("{}, {} failing, best fitness {:.2f}, {:.0f} % of the budget",
                                 counted(progress.tests, "test"), progress.failures,
                                 progress.best_fitness, 100 * progress.spent);
  if (progress.errors > 0) text += fmt::format(", {} without a result", progress.errors);
  if (progress.spent <= 0 || seconds <= 0) return text;
  const double left = seconds * (1 - progress.spent) / progress.spent;
  return text + fmt::format(", {} left", duration_text(left));
}

ProgressLine::ProgressLine(Console& console)
    : console_(console), start_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const Progress& progress) { draw(progress_text(progress, seconds())); }

void ProgressLine::show(const Progress& progress, std::string_view how) {
  draw(fmt::format("{}: {}", how, progress_text(progress, seconds())));
}

void ProgressLine::show(const search::SearchProgress& progress) {
  draw(progress_text(progress, seconds()));
}

double ProgressLine::seconds() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  return passed.count();
}

void ProgressLine::draw(std::string_view text) {
  if (!console_.error_is_terminal()) return;
  std::fputs(fmt::format("\r\x1b[K{}", text).c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressLine::clear() {
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace jaywalk
