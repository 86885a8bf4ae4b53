// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/compare/published/published.h"
#include "experiment/export/comparison_files.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

/// Distinguishable for the colour-blind, after Okabe and Ito.
constexpr std::array<std::string_view, 8> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#e69f00", "#56b4e9", "#7f4fc9", "#555555"};

constexpr double kPanelWidth = 420;
constexpr double kPanelHeight = 300;
constexpr double kPanelDistance = 500;
constexpr double kLeft = 60;
constexpr double kTop = 50;
constexpr double kLegendLine = 20;

struct ChartPoint {
  double x = 0;
  Estimate y;
};

/// One behaviour: its colour and its points, ours and the paper's.
struct Series {
  std::string name;
  std::string_view colour;
  std::vector<ChartPoint> ours;
  std::vector<ChartPoint> paper;
};

struct Panel {
  std::string_view title;
  std::string_view explanation;
  const Measure* measure;
  double left = 0;
  double max_x = 1;
  double min_y = 0;
  double max_y = 1;

  [[nodiscard]] double x(double value) const {
    return left + kPanelWidth * (max_x > 1 ? (value - 1) / (max_x - 1) : 0.5);
  }
  [[nodiscard]] double y(double value) const {
    return kTop + kPanelHeight * (max_y - value) / (max_y - min_y);
  }
};

std::vector<Series> series_of(const Comparison& comparison, const Measure& measure) {
  std::vector<Series> all;
  for (const Summary& summary : comparison.summaries) {
    if (all.empty() || all.back().name != summary.behaviour) {
      all.push_back({.name = summary.behaviour, .colour = kColours[all.size() % kColours.size()]});
    }
    const auto x = static_cast<double>(summary.agents);
    const Estimate ours = measure.estimate(summary);
    if (ours.value) all.back().ours.push_back({.x = x, .y = ours});
    const auto paper =
        published_figure(comparison.published, measure, summary.behaviour, summary.agents);
    if (paper) all.back().paper.push_back({.x = x, .y = *paper});
  }
  const auto by_x = [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; };
  for (Series& series : all) {
    std::ranges::sort(series.ours, by_x);
    std::ranges::sort(series.paper, by_x);
  }
  return all;
}

void fit(Panel& panel, double x, double y) {
  panel.max_x = std::max(panel.max_x, x);
  panel.min_y = std::min(panel.min_y, y);
  panel.max_y = std::max(panel.max_y, y);
}

/// Makes the panel show all points, and the intervals of ours.
void fit(Panel& panel, const std::vector<Series>& all) {
  for (const Series& series : all) {
    for (const ChartPoint& point : series.paper) fit(panel, point.x, *point.y.value);
    for (const ChartPoint& point : series.ours) {
      for (const auto& y : {point.y.low, point.y.value, point.y.high}) {
        if (y) fit(panel, point.x, *y);
      }
    }
  }
}

/// A round distance (1, 2 or 5 times a power of ten) between the marks of an axis.
double mark_distance(double range, int marks) {
  const double power = std::pow(10, std::floor(std::log10(range / marks)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range / (factor * power) <= marks) return factor * power;
  }
  return 10 * power;
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1,
                     x2, y2, style);
}

std::string text(double x, double y, std::string_view anchor, std::string_view content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(content));
}

std::string axes(const Panel& panel) {
  std::string svg = fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"title\">{}</text>\n",
                                panel.left, kTop - 34, escaped(panel.title));
  svg += text(panel.left, kTop - 16, "start", panel.explanation);
  const double y_step = mark_distance(panel.max_y - panel.min_y, 6);
  const auto first_y = static_cast<int>(std::ceil(panel.min_y / y_step));
  const auto last_y = static_cast<int>(std::floor(panel.max_y / y_step));
  for (int mark = first_y; mark <= last_y; ++mark) {
    const double y = mark * y_step;
    svg += line(panel.left, panel.y(y), panel.left + kPanelWidth, panel.y(y), "class=\"grid\"");
    svg += text(panel.left - 8, panel.y(y) + 4, "end", fmt::format("{:.4g}", y));
  }
  const double x_step = std::max(1.0, mark_distance(panel.max_x, 10));
  const auto last_x = static_cast<int>(panel.max_x / x_step);
  for (int mark = 1; mark <= last_x; ++mark) {
    const double x = mark * x_step;
    svg += text(panel.x(x), kTop + kPanelHeight + 18, "middle", fmt::format("{:.0f}", x));
  }
  svg += text(panel.left + kPanelWidth / 2, kTop + kPanelHeight + 38, "middle", "agents");
  return svg;
}

std::string polyline(const Panel& panel, const std::vector<ChartPoint>& points,
                     std::string_view style) {
  if (points.empty()) return {};
  std::string svg = "<polyline points=\"";
  for (const ChartPoint& point : points) {
    svg += fmt::format("{:.1f},{:.1f} ", panel.x(point.x), panel.y(*point.y.value));
  }
  return svg + fmt::format("\" {}/>\n", style);
}

std::string curves(const Panel& panel, const Series& series) {
  std::string svg = fmt::format("<g stroke=\"{}\" fill=\"none\">\n", series.colour);
  svg += polyline(panel, series.paper, "stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
  svg += polyline(panel, series.ours, "stroke-width=\"2\"");
  for (const ChartPoint& point : series.ours) {
    if (point.y.low && point.y.high) {
      svg += line(panel.x(point.x), panel.y(*point.y.low), panel.x(point.x), panel.y(*point.y.high),
                  "stroke-width=\"1\"");
    }
    svg +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\" stroke=\"none\"/>\n",
                    panel.x(point.x), panel.y(*point.y.value), series.colour);
  }
  return svg + "</g>\n";
}

std::string legend(const std::vector<Series>& all, const PublishedRows& published, double top) {
  std::string svg;
  double x = kLeft;
  double y = top;
  const double right = kLeft + kPanelDistance + kPanelWidth;
  for (const Series& series : all) {
    // Seven pixels are about the width of a letter.
    const double width = 60 + 7 * static_cast<double>(series.name.size());
    if (x + width > right && x > kLeft) {
      x = kLeft;
      y += kLegendLine;
    }
    svg += line(x, y, x + 24, y, fmt::format("stroke=\"{}\" stroke-width=\"2\"", series.colour));
    svg += text(x + 30, y + 4, "start", series.name);
    x += width;
  }
  y += kLegendLine;
  svg += line(kLeft, y, kLeft + 24, y, "stroke=\"#777\" stroke-width=\"2\"");
  svg += text(kLeft + 30, y + 4, "start", "this run, bars: 95 % intervals");
  if (published.behaviours.empty()) return svg;
  svg += line(kLeft + 260, y, kLeft + 284, y,
              "stroke=\"#777\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
  return svg + text(kLeft + 290, y + 4, "start", "published (Chance et al. 2020)");
}

}  // namespace

std::string render_svg(const Comparison& comparison) {
  std::array panels = {
      Panel{.title = "Accuracy, %",
            .explanation = "tests that reach the precondition",
            .measure = find_measure("accuracy"),
            .left = kLeft,
            .max_y = 100},
      Panel{.title = "combined_normalised",
            .explanation = "(score × accuracy / 1000 + 0.45) / 4.71",
            .measure = find_measure("combined_normalised"),
            .left = kLeft + kPanelDistance},
  };
  if (!is_shown(comparison.published, *panels[1].measure)) {
    panels[1].title = "combined";
    panels[1].explanation = "score × accuracy / 1000";
    panels[1].measure = find_measure("combined");
  }
  std::string body;
  std::vector<Series> all;
  for (Panel& panel : panels) {
    all = series_of(comparison, *panel.measure);
    fit(panel, all);
    body += axes(panel);
    for (const Series& series : all) body += curves(panel, series);
  }
  const double legend_top = kTop + kPanelHeight + 65;
  body += legend(all, comparison.published, legend_top);
  const double width = kLeft + kPanelDistance + kPanelWidth + 20;
  const double height = legend_top + 3 * kLegendLine + 10;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"system-ui, sans-serif\" font-size=\"12\" fill=\"#222\">\n"
      "<style>.title{{font-size:14px;font-weight:600}}.grid{{stroke:#ddd}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
      width, height, body);
}

}  // namespace jaywalk
