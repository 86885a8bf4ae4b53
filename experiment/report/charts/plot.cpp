// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/charts/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "experiment/report/html.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

constexpr double kPlotWidth = 360;
constexpr double kHeight = 266;
constexpr double kPlotLeft = 48;
constexpr double kPlotRight = 350;
constexpr double kTop = 26;
constexpr double kBottom = 224;

bool is_shown(double value, Scale scale) {
  return std::isfinite(value) && (scale == Scale::linear || value > 0);
}

/// Whether the point's interval is drawn.
bool has_bar(const PlotSeries& series, const PlotPoint& point) {
  return point.low && point.high && !series.published;
}

/// The range of everything that is shown, with the ends that the axes ask for.
Axis vertical_axis(const PlotAxes& axes, const std::vector<PlotSeries>& series) {
  double least = axes.least.value_or(std::numeric_limits<double>::infinity());
  double most = axes.most.value_or(-std::numeric_limits<double>::infinity());
  const auto reach = [&](std::optional<double> value) {
    if (!value || !is_shown(*value, axes.scale)) return;
    least = std::min(least, *value);
    most = std::max(most, *value);
  };
  for (const PlotSeries& each : series) {
    for (const PlotPoint& point : each.points) {
      reach(point.y);
      if (!has_bar(each, point)) continue;
      reach(point.low);
      reach(point.high);
    }
  }
  if (!(least <= most)) {
    least = axes.scale == Scale::linear ? 0 : 1;
    most = least + 1;
  }
  if (axes.scale == Scale::logarithmic) {
    least = std::max(least / 1.2, std::numeric_limits<double>::min());
    most = std::min(most * 1.2, std::numeric_limits<double>::max());
  } else {
    const double lowest = least;
    widen_if_narrow(least, most);
    if (axes.least && lowest >= *axes.least) least = std::max(least, *axes.least);
    const double room = 0.03 * (most - least);
    if (!axes.most || most > *axes.most) most += room;
    if (!axes.least || least < *axes.least) least -= room;
  }
  return {.least = least, .most = most, .begin = kBottom, .end = kTop, .scale = axes.scale};
}

Axis horizontal_axis(const PlotAxes& axes, const std::vector<PlotSeries>& series) {
  double most = axes.x_most;
  for (const PlotSeries& each : series) {
    for (const PlotPoint& point : each.points) most = std::max(most, point.x);
  }
  return {.least = axes.x_least, .most = most, .begin = kPlotLeft + 8, .end = kPlotRight - 8};
}

std::string frame(const PlotAxes& axes, const Axis& x, const Axis& y) {
  // Above the marks, not turned: the room beside them is too narrow on a phone.
  std::string content = svg_text(2, kTop - 13, "start", axes.y_title) + '\n';
  for (const double mark : y.marks(6)) {
    content += svg_line(kPlotLeft, y.at(mark), kPlotRight, y.at(mark), "class=\"grid\"");
    content += svg_text(kPlotLeft - 6, y.at(mark) + 4, "end", compact(mark)) + '\n';
  }
  content += svg_line(kPlotLeft, kBottom, kPlotRight, kBottom, "class=\"axis\"");
  std::vector<double> marks = x.marks(x.most <= 10 ? 10 : 5);
  if (marks.empty() || marks.front() > x.least) marks.insert(marks.begin(), x.least);
  for (const double mark : marks) {
    if (mark != std::floor(mark)) continue;
    content += svg_line(x.at(mark), kBottom, x.at(mark), kBottom + 4, "class=\"axis\"");
    content += svg_text(x.at(mark), kBottom + 18, "middle", compact(mark)) + '\n';
  }
  return content + svg_text((kPlotLeft + kPlotRight) / 2, kBottom + 36, "middle", axes.x_title) +
         '\n';
}

std::string curve(const PlotSeries& series, const PlotAxes& axes, const Axis& x, const Axis& y) {
  std::string path;
  std::string marks;
  for (const PlotPoint& point : series.points) {
    if (!is_shown(point.y, axes.scale)) continue;
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(point.x), y.at(point.y));
    std::string tip =
        fmt::format("{}{}, {:.0f}: {}", series.name, series.published ? " (published)" : "",
                    point.x, compact(point.y));
    if (has_bar(series, point)) {
      marks += svg_line(x.at(point.x), y.at(*point.low), x.at(point.x), y.at(*point.high));
      tip += fmt::format(" ({} to {})", compact(*point.low), compact(*point.high));
    }
    marks += fmt::format(
        "<g>{}<title>{}</title></g>\n",
        series.published
            ? fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" class=\"target\"/>",
                          x.at(point.x), y.at(point.y))
            : marker(series.number, x.at(point.x), y.at(point.y)),
        escaped(tip));
  }
  if (path.empty()) return {};
  return fmt::format("<g {}><path d=\"{}\" class=\"{}\"/>\n{}</g>\n",
                     series_attributes(series.number), path,
                     series.published ? "published" : "curve", marks);
}

}  // namespace

std::string curves(const PlotAxes& axes, const std::vector<PlotSeries>& series) {
  const Axis x = horizontal_axis(axes, series);
  const Axis y = vertical_axis(axes, series);
  std::string content = frame(axes, x, y);
  for (const PlotSeries& each : series) {
    if (each.published) content += curve(each, axes, x, y);
  }
  for (const PlotSeries& each : series) {
    if (!each.published) content += curve(each, axes, x, y);
  }
  return svg(kPlotWidth, kHeight, axes.y_title, content);
}

}  // namespace jaywalk::reporting
