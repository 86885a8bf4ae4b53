#include "tools/jaywalk/console/progress_line.h"

#include <cstdio>

#include <fmt/format.h>

namespace jaywalk {

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
