#include "tools/jaywalk/search_progress.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace jaywalk {

std::string search_progress_text(const search::SearchProgress& progress, double seconds) {
  std::string text =
      fmt::format("{} tests, {} failing, best fitness {:.2f}, {:.0f} % of the budget",
                  progress.tests, progress.failures, progress.best_fitness, 100 * progress.spent);
  if (progress.errors > 0) text += fmt::format(", {} without a result", progress.errors);
  if (progress.spent <= 0 || seconds <= 0) return text;
  const double left = seconds * (1 - progress.spent) / progress.spent;
  if (left < 60) return text + fmt::format(", {:.0f} s left", left);
  return text +
         fmt::format(", {:.0f} min {:02.0f} s left", std::floor(left / 60), std::fmod(left, 60));
}

SearchProgressLine::SearchProgressLine(Console& console)
    : console_(console), start_(std::chrono::steady_clock::now()) {}

SearchProgressLine::~SearchProgressLine() { clear(); }

void SearchProgressLine::show(const search::SearchProgress& progress) {
  if (!console_.error_is_terminal()) return;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  fmt::print(stderr, "\r\x1b[K{}", search_progress_text(progress, passed.count()));
  std::fflush(stderr);
  drawn_ = true;
}

void SearchProgressLine::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace jaywalk
