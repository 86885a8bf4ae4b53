// SPDX-License-Identifier: Apache-2.0
// How each metric is spread, by behaviour.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

/// Few enough metric_numbers of agents to draw: evenly spread, with the first and the last.
std::vector<std::uint32_t> drawn_agents(const std::vector<std::uint32_t>& all) {
  constexpr std::size_t kMost = 4;
  if (all.size() <= kMost) return all;
  std::vector<std::uint32_t> some;
  for (std::size_t i = 0; i < kMost; ++i) some.push_back(all[i * (all.size() - 1) / (kMost - 1)]);
  return some;
}

const AssessmentSummary* find_assessment(const Comparison& comparison, const Summary* summary) {
  if (summary == nullptr) return nullptr;
  return &comparison.assessments[static_cast<std::size_t>(summary - comparison.summaries.data())];
}

std::vector<BoxGroup> groups_of(const Comparison& comparison, std::size_t metric) {
  std::vector<BoxGroup> groups;
  const std::vector<std::string> behaviours = behaviours_of(comparison);
  for (std::size_t i = 0; i < behaviours.size(); ++i) {
    BoxGroup group{.name = behaviours[i], .number = i};
    for (const std::uint32_t agents : drawn_agents(agents_of(comparison))) {
      const auto* assessment =
          find_assessment(comparison, find_summary(comparison, behaviours[i], agents));
      if (assessment == nullptr || metric >= assessment->metrics.size()) continue;
      group.boxes.push_back({std::to_string(agents), assessment->metrics[metric]});
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::string metric_numbers(const Comparison& comparison, std::size_t metric) {
  Table table;
  table.columns({"agents", "tests", "mean", "least", "lower quartile", "median", "upper quartile",
                 "greatest"});
  const std::string* behaviour = nullptr;
  for (std::size_t row = 0; row < comparison.assessments.size(); ++row) {
    const Summary& summary = comparison.summaries[row];
    if (metric >= comparison.assessments[row].metrics.size()) continue;
    if (behaviour == nullptr || *behaviour != summary.behaviour) table.heading(summary.behaviour);
    behaviour = &summary.behaviour;
    const Distribution& of = comparison.assessments[row].metrics[metric];
    std::vector<std::string> cells{std::to_string(summary.agents), grouped(of.count)};
    for (const double value :
         {of.mean, of.least, of.lower_quartile, of.median, of.upper_quartile, of.greatest}) {
      cells.push_back(of.count == 0 ? "–" : decimal(value, 3));
    }
    table.row(std::move(cells));
  }
  return table.html();
}

}  // namespace

std::string section::metrics(const ReportData& data) {
  const Comparison& comparison = data.comparison;
  const bool measured = std::ranges::any_of(
      comparison.assessments, [](const AssessmentSummary& row) { return !row.metrics.empty(); });
  if (!measured) {
    return paragraph(
        data.store == nullptr
            ? "None were measured: <code>--metrics</code> measures each test."
            : fmt::format("None are in the store: <code>jaywalk judge {} --metrics --write</code> "
                          "measures its tests and adds them.",
                          escaped(data.store_path)));
  }
  std::string figures;
  std::string tables;
  for (std::size_t i = 0; i < jaywalk::metrics().size(); ++i) {
    const Metric& metric = jaywalk::metrics()[i];
    const std::string unit(metric.unit);
    const std::string title =
        unit.empty() ? std::string(metric.name) : fmt::format("{}, {}", metric.name, unit);
    figures += figure(fmt::format("{}<small>{}</small>", escaped(title), escaped(metric.formula)),
                      box_plots(title, groups_of(comparison, i)));
    tables += details(title, metric_numbers(comparison, i));
  }
  return paragraph(
             "Of each test the worst road user’s value; tests in which a metric does not exist "
             "are left out. A box reaches from quartile to quartile with the median as a bar, its "
             "line from the least to the greatest value, an arrow stands for an infinite one; at "
             "the left the number of agents. A1 is the automated vehicle, A2 the other road "
             "user.") +
         legend(behaviours_of(comparison)) + gallery(figures) + "<h3>The same as tables</h3>\n" +
         tables;
}

}  // namespace jaywalk::reporting
