// SPDX-License-Identifier: Apache-2.0
// Box plots and bars.

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

constexpr double kBarsWidth = 360;
constexpr double kBarsLeft = 28;
constexpr double kBarsRight = 346;
constexpr double kBoxLine = 11;
constexpr double kNameLine = 18;

Axis value_axis(const std::vector<BoxGroup>& groups) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const BoxGroup& group : groups) {
    for (const Box& box : group.boxes) {
      if (box.values.count == 0) continue;
      const Distribution& of = box.values;
      for (const double value :
           {of.least, of.lower_quartile, of.median, of.upper_quartile, of.greatest}) {
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
  }
  if (!(least <= most)) return {.begin = kBarsLeft, .end = kBarsRight};
  if (least > 0 && least < 0.3 * most) least = 0;
  widen_if_narrow(least, most);
  return {.least = least, .most = most, .begin = kBarsLeft, .end = kBarsRight};
}

std::string arrow(double x, double y, double way) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}l{:.1f} 3.5v-7z\" fill=\"currentColor\"/>", x, y,
                     -5 * way);
}

std::string box_row(const Box& box, std::string_view noun, const Axis& axis, double y) {
  const Distribution& of = box.values;
  std::string row = svg_text(kBarsLeft - 6, y + 3.5, "end", box.label, "class=\"small\"");
  if (of.count == 0) return row;
  std::string drawn = svg_line(axis.at(of.least), y, axis.at(of.greatest), y);
  const double from = axis.at(of.lower_quartile);
  const double to = axis.at(of.upper_quartile);
  drawn +=
      fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"7\" class=\"box\"/>",
                  from, y - 3.5, std::max(0.8, to - from));
  const double median = axis.at(of.median);
  drawn += svg_line(median, y - 4.5, median, y + 4.5, "stroke-width=\"2.5\"");
  if (std::isinf(of.greatest) && of.greatest > 0) drawn += arrow(kBarsRight + 6, y, 1);
  if (std::isinf(of.least) && of.least < 0) drawn += arrow(kBarsLeft - 3, y, -1);
  const std::string lead = box.label.empty() ? "" : escaped(box.label) + ": ";
  return row + fmt::format(
                   "<g>{}<title>{}median {}, quartiles {} and {}, from {} to {}, {}</title></g>\n",
                   drawn, lead, compact(of.median), compact(of.lower_quartile),
                   compact(of.upper_quartile), compact(of.least), compact(of.greatest),
                   plural(of.count, noun));
}

}  // namespace

std::string box_plots(std::string_view x_title, const std::vector<BoxGroup>& groups,
                      std::string_view noun) {
  const Axis axis = value_axis(groups);
  std::string boxes;
  double y = 4;
  for (const BoxGroup& group : groups) {
    boxes += fmt::format("<g {}>", series_attributes(group.number));
    boxes += svg_text(kBarsLeft, y + 11, "start", group.name, "class=\"name\"") + '\n';
    y += kNameLine;
    for (const Box& box : group.boxes) {
      boxes += box_row(box, noun, axis, y + kBoxLine / 2);
      y += kBoxLine;
    }
    boxes += "</g>\n";
    y += 4;
  }
  std::string frame;
  for (const double mark : axis.marks(5)) {
    frame += svg_line(axis.at(mark), 4, axis.at(mark), y + 2, "class=\"grid\"");
    frame += svg_text(axis.at(mark), y + 16, "middle", compact(mark)) + '\n';
  }
  frame += svg_text((kBarsLeft + kBarsRight) / 2, y + 34, "middle", x_title);
  return svg(kBarsWidth, y + 42, x_title, frame + boxes);
}

std::string stacked_bars(const std::vector<std::string>& classes, const std::vector<Bar>& bars) {
  const Axis axis{.least = 0, .most = 100, .begin = 4, .end = kBarsRight + 6};
  std::string content;
  double y = 2;
  for (const Bar& bar : bars) {
    double all = 0;
    for (const double part : bar.parts) all += part;
    content += svg_text(4, y + 11, "start", bar.name, "class=\"name\"");
    y += 15;
    double from = 0;
    for (std::size_t i = 0; i < bar.parts.size() && all > 0; ++i) {
      const double share = 100 * bar.parts[i] / all;
      if (share <= 0) continue;
      const double left = axis.at(from);
      const double width = axis.at(from + share) - left;
      content += fmt::format(
          "<g><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"14\" class=\"part-{}\"/>",
          left, y, width, classes[i]);
      if (width > 34) {
        content += svg_text(left + width / 2, y + 11, "middle", fmt::format("{:.0f} %", share),
                            fmt::format("class=\"on-{}\"", classes[i]));
      }
      content +=
          fmt::format("<title>{}: {} {:.1f} %</title></g>\n", escaped(bar.name), classes[i], share);
      from += share;
    }
    y += 20;
  }
  return svg(kBarsWidth, y, "shares of tests", content);
}

}  // namespace jaywalk::reporting
