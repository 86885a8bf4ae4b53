// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/html.h"
#include "search/failing_stretch.h"
#include "search/report/search_page.h"

namespace jaywalk::search {
namespace {

constexpr double kReach_m = 1;
constexpr std::size_t kShownSizes = 20;

struct Failure {
  const SearchRun* run;
  std::size_t number;

  [[nodiscard]] const TestRow& row() const { return run->tests[number]; }
};

std::vector<Failure> failures_of(const GeneratorResults& generator) {
  std::vector<Failure> failures;
  for (const SearchRun* run : generator.runs) {
    for (std::size_t i = 0; i < run->tests.size(); ++i) {
      if (run->tests[i].test.failed) failures.push_back({run, i});
    }
  }
  return failures;
}

using Groups = std::vector<std::vector<std::size_t>>;

Groups by_stretch(const std::vector<Failure>& failures, const SutModel& model) {
  std::vector<FailingStretch> stretches;
  for (const Failure& each : failures) {
    stretches.push_back(failing_stretch(each.row().test, model).value_or(FailingStretch{}));
  }
  return cluster(failures.size(), [&](std::size_t a, std::size_t b) {
    return separation_m(stretches[a], stretches[b]) <= kReach_m;
  });
}

Groups by_signature(const std::vector<Failure>& failures, const SearchSpace& space) {
  std::vector<std::vector<double>> signatures;
  for (const Failure& each : failures) signatures.push_back(signature(each.row().test, space));
  const double reach = median_distance(signatures) / 2;
  return cluster(failures.size(), [&](std::size_t a, std::size_t b) {
    return euclidean_distance(signatures[a], signatures[b]) <= reach;
  });
}

std::string sizes_text(const Groups& groups) {
  std::vector<std::size_t> sizes;
  for (const auto& group : groups) {
    if (sizes.size() < kShownSizes) sizes.push_back(group.size());
  }
  return fmt::format("{}{}", fmt::join(sizes, ", "), groups.size() > kShownSizes ? ", …" : "");
}

}  // namespace

std::string clusters_html(const GeneratorResults& generator, const SutModel& model,
                          std::size_t number) {
  const std::vector<Failure> failures = failures_of(generator);
  if (failures.empty()) return reporting::paragraph("No test failed.");
  const Groups groups = measures_stretches(model) ? by_stretch(failures, model)
                                                  : by_signature(failures, model.space());
  std::string html = reporting::paragraph(fmt::format(
      "{} of {} in {}, of {} tests.", reporting::plural(failures.size(), "failing test"),
      reporting::plural(generator.runs.size(), "repetition"),
      reporting::plural(groups.size(), "cluster"), sizes_text(groups)));
  if (model.road_space() == nullptr) return html;
  RoadPictures roads(model, number);
  for (std::size_t i = 0; i < groups.size() && !roads.full(); ++i) {
    const Failure& founder = failures[groups[i].front()];
    roads.add(founder.row(),
              fmt::format("{}; repetition {}, test {}", reporting::plural(groups[i].size(), "test"),
                          founder.run->repetition, founder.number));
  }
  return html + roads.html();
}

}  // namespace jaywalk::search
