// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/published/agreement.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace jaywalk {
namespace {

constexpr double kPublishedTests = 1000;
/// The number of standard deviations that contain 99.9 % of a normal distribution.
constexpr double kWithin999 = 3.2905;
/// Scores and ticks were published with two decimals; accuracies are exact.
constexpr double kHalfAHundredth = 0.005;
/// An upper limit of rounding errors.
constexpr double kTiny = 1e-9;

/// The standard error of the difference of two means, ours and that of `published_tests` tests.
double standard_error(const Sample& ours, double published_tests) {
  if (ours.count < 2 || published_tests == 0) return 0;
  const auto count = static_cast<double>(ours.count);
  return std::sqrt(ours.squares / (count - 1) * (1 / count + 1 / published_tests));
}

/// The standard error of the difference of two shares in percent. If both come from one program,
/// the share of all tests is the best estimate of its probability.
double standard_error(const Summary& ours, double published_pct) {
  const auto tests = static_cast<double>(ours.judged());
  const double both =
      (static_cast<double>(ours.successes) + published_pct / 100 * kPublishedTests) /
      (tests + kPublishedTests);
  return 100 * std::sqrt(both * (1 - both) * (1 / tests + 1 / kPublishedTests));
}

class Comparer {
 public:
  Comparer(const Comparison& comparison, const Summary& ours, Agreement& agreement)
      : rows_(comparison.published), ours_(ours), agreement_(agreement) {}

  void compare() {
    const auto accuracy = published("accuracy");
    if (!accuracy || ours_.judged() == 0) return;
    add("accuracy", standard_error(ours_, *accuracy), 0);
    if (ours_.score.count > 0) {
      add("score", standard_error(ours_.score, *accuracy / 100 * kPublishedTests), kHalfAHundredth);
    }
    add("ticks_all", standard_error(ours_.ticks_all, kPublishedTests), kHalfAHundredth);
  }

 private:
  [[nodiscard]] std::optional<double> published(std::string_view measure) const {
    const auto figure =
        published_figure(rows_, *find_measure(measure), ours_.behaviour, ours_.agents);
    return figure ? figure->value : std::nullopt;
  }

  void add(std::string_view measure, double standard_error, double rounding) {
    const auto theirs = published(measure);
    const auto ours = find_measure(measure)->estimate(ours_).value;
    if (!theirs || !ours) return;
    ++agreement_.values;
    if (std::abs(*theirs - *ours) <= kWithin999 * standard_error + rounding + kTiny) return;
    agreement_.outside.push_back(fmt::format("{} {} {}", ours_.behaviour, ours_.agents, measure));
  }

  const PublishedRows& rows_;
  const Summary& ours_;
  Agreement& agreement_;
};

}  // namespace

Agreement agreement_with_published(const Comparison& comparison) {
  Agreement agreement;
  for (const Summary& summary : comparison.summaries) {
    Comparer(comparison, summary, agreement).compare();
  }
  return agreement;
}

std::string agreement_note(const Comparison& comparison) {
  const Agreement agreement = agreement_with_published(comparison);
  if (agreement.values == 0) return {};
  return fmt::format(
      "{} of {} published accuracies, scores and ticks differ from ours by more than chance "
      "explains (99.9 %).",
      agreement.outside.size(), agreement.values);
}

}  // namespace jaywalk
