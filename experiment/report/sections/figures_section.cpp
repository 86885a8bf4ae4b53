// SPDX-License-Identifier: Apache-2.0
// The measures, each against the number of agents, and the same numbers as a table; in the paper's
// world beside the published values.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/compare/published/agreement.h"
#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

struct MeasureFigure {
  std::string_view measure;
  std::string_view title;
  std::string_view explanation;
  int decimals;
  Scale scale = Scale::linear;
  std::optional<double> least = std::nullopt;
  std::optional<double> most = std::nullopt;
};

constexpr std::array kFigures = {
    MeasureFigure{"accuracy", "Accuracy, %", "tests that met the precondition; bars: 95 %, Wilson",
                  1, Scale::linear, 0, 100},
    MeasureFigure{"score", "Score", "of successful tests; bars: 95 %, Student’s t", 2},
    MeasureFigure{"combined_normalised", "combined_normalised",
                  "score × accuracy / 1000, normalised as the paper draws it", 3},
    MeasureFigure{"cpu", "CPU time, µs per test", "spent reasoning; logarithmic", 1,
                  Scale::logarithmic},
    MeasureFigure{"ticks_all", "Time to test, ticks", "mean of all tests; bars: 95 %, Student’s t",
                  2, Scale::linear, 0},
};

std::vector<PlotSeries> series_of(const Comparison& comparison, const Measure& measure) {
  std::vector<PlotSeries> all;
  const std::vector<std::string> behaviours = behaviours_of(comparison);
  for (std::size_t i = 0; i < behaviours.size(); ++i) {
    PlotSeries ours{.name = behaviours[i], .number = i};
    PlotSeries paper{.name = behaviours[i], .number = i, .published = true};
    for (const std::uint32_t agents : agents_of(comparison)) {
      const Summary* summary = find_summary(comparison, behaviours[i], agents);
      if (summary == nullptr) continue;
      const Estimate estimate = measure.estimate(*summary);
      if (estimate.value) {
        ours.points.push_back(
            {static_cast<double>(agents), *estimate.value, estimate.low, estimate.high});
      }
      const auto figure = published_figure(comparison.published, measure, behaviours[i], agents);
      if (figure && figure->value) {
        paper.points.push_back({static_cast<double>(agents), *figure->value, {}, {}});
      }
    }
    all.push_back(std::move(ours));
    all.push_back(std::move(paper));
  }
  return all;
}

std::string interval(const Estimate& estimate, int decimals) {
  if (!estimate.low || !estimate.high) return "–";
  return fmt::format("{} to {}", decimal(estimate.low, decimals), decimal(estimate.high, decimals));
}

std::string numbers(const Comparison& comparison) {
  Table table;
  const bool shown = !comparison.published.behaviours.empty();
  table.column("agents");
  for (const MeasureFigure& figure : kFigures) {
    const Measure& measure = *find_measure(figure.measure);
    if (!is_shown(comparison.published, measure)) continue;
    table.column(figure.title);
    if (!measure.low_column.empty()) table.column("95 % interval");
    if (shown) table.column("published");
  }
  for (const std::string& behaviour : behaviours_of(comparison)) {
    table.heading(behaviour);
    for (const std::uint32_t agents : agents_of(comparison)) {
      const Summary* summary = find_summary(comparison, behaviour, agents);
      if (summary == nullptr) continue;
      std::vector<std::string> cells{std::to_string(agents)};
      for (const MeasureFigure& figure : kFigures) {
        const Measure& measure = *find_measure(figure.measure);
        if (!is_shown(comparison.published, measure)) continue;
        const Estimate ours = measure.estimate(*summary);
        cells.push_back(decimal(ours.value, figure.decimals));
        if (!measure.low_column.empty()) cells.push_back(interval(ours, figure.decimals));
        if (!shown) continue;
        const auto paper = published_figure(comparison.published, measure, behaviour, agents);
        cells.push_back(decimal(paper ? paper->value : std::nullopt, figure.decimals));
      }
      table.row(std::move(cells));
    }
  }
  return table.html();
}

std::string notes(const Comparison& comparison) {
  const PublishedRows& published = comparison.published;
  std::string text;
  if (!published.behaviours.empty()) {
    text =
        "Dashed, in the same colour: values from the authors’ released figures. Their CPU time is "
        "that of another program on another machine.<br>";
  }
  for (const std::string& note : published_notes(published)) text += escaped(note) + "<br>";
  text += escaped(agreement_note(comparison));
  return text.empty() ? text : fmt::format("<p class=\"note\">{}</p>\n", text);
}

}  // namespace

std::string section::figures(const ReportData& data) {
  const Comparison& comparison = data.comparison;
  if (comparison.summaries.empty()) return {};
  std::string figures;
  for (const MeasureFigure& each : kFigures) {
    const Measure& measure = *find_measure(each.measure);
    if (!is_shown(comparison.published, measure)) continue;
    const PlotAxes axes{.x_title = "agents",
                        .y_title = std::string(each.title),
                        .scale = each.scale,
                        .least = each.least,
                        .most = each.most};
    figures +=
        figure(fmt::format("{}<small>{}</small>", escaped(each.title), escaped(each.explanation)),
               curves(axes, series_of(comparison, measure)));
  }
  std::string html = legend(behaviours_of(comparison));
  html += notes(comparison);
  return html + gallery(figures) + details("The same numbers as a table", numbers(comparison));
}

}  // namespace jaywalk::reporting
