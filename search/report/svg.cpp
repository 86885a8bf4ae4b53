#include "search/report/svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/support/markup.h"

namespace jaywalk::search {
namespace {

constexpr std::array<std::string_view, 8> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#e69f00", "#56b4e9", "#7f4fc9", "#555555"};

constexpr double kHeight = 240;
constexpr double kTop = 40;
constexpr double kLeft = 60;
constexpr double kColumn = 110;
constexpr double kCurveWidth = 620;

std::string opening(double width, double height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" font-size=\"12\" fill=\"#222\">\n",
      width, height);
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1,
                     x2, y2, style);
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

/// A round distance of an axis' marks: about five of them.
double mark_distance(double range) {
  const double power = std::pow(10, std::floor(std::log10(range / 5)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range / (factor * power) <= 6) return factor * power;
  }
  return 10 * power;
}

/// A vertical axis from 0.
struct Axis {
  double most = 1;

  [[nodiscard]] double y(double value) const { return kTop + kHeight * (1 - value / most); }
  [[nodiscard]] std::string draw(std::string_view title, double right) const {
    std::string svg = fmt::format(
        "<text x=\"{}\" y=\"20\" font-size=\"14\" font-weight=\"600\">{}"
        "</text>\n",
        kLeft, escaped(title));
    const double step = mark_distance(most);
    for (int mark = 0; mark * step <= most * 1.0001; ++mark) {
      svg += line(kLeft, y(mark * step), right, y(mark * step), "stroke=\"#ddd\"");
      svg += label(kLeft - 8, y(mark * step) + 4, "end", fmt::format("{:.4g}", mark * step));
    }
    return svg;
  }
};

std::string box(const Distribution& distribution, const Axis& axis, double x,
                std::string_view stroke) {
  if (distribution.values.empty()) return {};
  const std::vector<double>& values = distribution.values;
  const double lower = quantile(values, 0.25);
  const double middle = quantile(values, 0.5);
  const double upper = quantile(values, 0.75);
  const double reach = 1.5 * (upper - lower);
  double least = middle;
  double most = middle;
  std::string svg = fmt::format("<g stroke=\"{}\" fill=\"none\">\n", stroke);
  for (const double value : values) {
    if (value < lower - reach || value > upper + reach) {
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>\n", x, axis.y(value));
    } else {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  svg += line(x, axis.y(most), x, axis.y(upper), "");
  svg += line(x, axis.y(lower), x, axis.y(least), "");
  svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"50\" height=\"{:.1f}\"/>\n", x - 25,
                     axis.y(upper), std::max(0.5, axis.y(lower) - axis.y(upper)));
  svg += line(x - 25, axis.y(middle), x + 25, axis.y(middle), "stroke-width=\"3\"");
  return svg + "</g>\n";
}

}  // namespace

std::string_view colour(std::size_t index) { return kColours[index % kColours.size()]; }

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::string box_plots(std::string_view title, const std::vector<Distribution>& distributions) {
  Axis axis{0};
  for (const Distribution& each : distributions) {
    for (const double value : each.values) axis.most = std::max(axis.most, value);
  }
  if (!(axis.most > 0)) axis.most = 1;
  const double right = kLeft + kColumn * static_cast<double>(distributions.size());
  std::string svg = opening(right + 20, kTop + kHeight + 40) + axis.draw(title, right);
  for (std::size_t i = 0; i < distributions.size(); ++i) {
    const double x = kLeft + kColumn * (static_cast<double>(i) + 0.5);
    svg += box(distributions[i], axis, x, colour(i));
    svg += label(x, kTop + kHeight + 20, "middle", distributions[i].name);
  }
  return svg + "</svg>\n";
}

std::string curves(std::string_view title, const std::vector<Curve>& all) {
  const Axis axis{1};
  const double right = kLeft + kCurveWidth;
  std::string svg = opening(right + 180, kTop + kHeight + 40) + axis.draw(title, right);
  for (int percent = 0; percent <= 100; percent += 20) {
    svg += label(kLeft + kCurveWidth * percent / 100, kTop + kHeight + 20, "middle",
                 fmt::format("{} %", percent));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<double>& values = all[i].values;
    svg += fmt::format("<polyline fill=\"none\" stroke-width=\"2\" stroke=\"{}\" points=\"",
                       colour(i));
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double x =
          kLeft + kCurveWidth * (static_cast<double>(k) + 0.5) / static_cast<double>(values.size());
      svg += fmt::format("{:.1f},{:.1f} ", x, axis.y(values[k]));
    }
    svg += "\"/>\n";
    const double y = kTop + 20 * static_cast<double>(i) + 10;
    svg += line(right + 12, y, right + 36, y,
                fmt::format("stroke-width=\"2\" stroke=\"{}\"", colour(i)));
    svg += label(right + 42, y + 4, "start", all[i].name);
  }
  return svg + "</svg>\n";
}

std::string road_pictures(const std::vector<std::vector<Point>>& roads,
                          const std::vector<std::string>& captions, double map_m,
                          std::string_view stroke) {
  constexpr double kSide = 110;
  constexpr double kCell = 120;
  constexpr std::size_t kInRow = 8;
  const double scale = kSide / map_m;
  const std::size_t rows = (roads.size() + kInRow - 1) / kInRow;
  std::string svg =
      opening(kCell * static_cast<double>(kInRow), (kCell + 20) * static_cast<double>(rows));
  for (std::size_t i = 0; i < roads.size(); ++i) {
    const double left = kCell * static_cast<double>(i % kInRow);
    const double top = (kCell + 20) * static_cast<double>(i / kInRow);
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"#f7f7f7\" "
        "stroke=\"#ccc\"/>\n",
        left, top, kSide, kSide);
    svg += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.1f}\" points=\"",
                       stroke, 8 * scale);
    for (const Point& point : roads[i]) {
      svg +=
          fmt::format("{:.1f},{:.1f} ", left + scale * point.x_m, top + kSide - scale * point.y_m);
    }
    svg += "\"/>\n" + label(left + kSide / 2, top + kSide + 15, "middle", captions[i]);
  }
  return svg + "</svg>\n";
}

}  // namespace jaywalk::search
