#include "tools/jaywalk/console/progress_text.h"

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

}  // namespace jaywalk
