#include "tools/jaywalk/progress_line.h"

#include <cstdio>

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

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

ProgressLine::ProgressLine(Console& console)
    : console_(console), start_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const Progress& progress) {
  if (!console_.error_is_terminal()) return;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  const std::string text = progress_text(progress, passed.count());
  fmt::print(stderr, "\r\x1b[K{}", text);
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressLine::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace jaywalk
