// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

std::vector<double> linear_marks(double least, double most, int count) {
  const double range = most - least;
  const double power = std::pow(10, std::floor(std::log10(range / count)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (range / (factor * power) <= count) step = factor * power;
  }
  const double first = std::ceil(least / step - 1e-9);
  std::vector<double> marks;
  // Counted, since adding 1 to a large number, or a step to it, may change nothing.
  for (int i = 0; i <= 2 * count; ++i) {
    const double mark = (first + i) * step;
    if (!(mark <= most + 1e-9 * range)) break;
    if (marks.empty() || mark > marks.back()) marks.push_back(mark == 0 ? 0 : mark);
  }
  return marks;
}

/// Powers of ten, and their doubles and fivefolds where these are few.
std::vector<double> logarithmic_marks(double least, double most, int count) {
  const int first = static_cast<int>(std::floor(std::log10(least) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(most) - 1e-9));
  const bool few = last - first <= 2;
  const int step = std::max(1, (last - first + count) / std::max(1, count));
  std::vector<double> marks;
  for (int power = first; power <= last; power += step) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor > 1 && !few) break;
      const double mark = factor * std::pow(10, power);
      if (mark >= least * 0.999 && mark <= most * 1.001) marks.push_back(mark);
    }
  }
  return marks;
}

}  // namespace

void widen_if_narrow(double& least, double& most) {
  // Values that differ by less are equal but for rounding; wider than the resolution of doubles.
  constexpr double kPrecision = 1e-9;
  const double size = std::max(std::fabs(least), std::fabs(most));
  if (most - least > kPrecision * size) return;
  const double middle = least / 2 + most / 2;
  const double room = std::max(0.5, 1e-3 * size);
  least = middle - room;
  most = middle + room;
}

double Axis::at(double value) const {
  const double clamped = std::clamp(value, least, most);
  const double part = scale == Scale::linear ? (clamped - least) / (most - least)
                                             : std::log(clamped / least) / std::log(most / least);
  return begin + (end - begin) * part;
}

std::vector<double> Axis::marks(int count) const {
  return scale == Scale::linear ? linear_marks(least, most, count)
                                : logarithmic_marks(least, most, count);
}

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view attributes) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"{}{}/>", x1, y1, x2, y2,
                     attributes.empty() ? "" : " ", attributes);
}

std::string svg_text(double x, double y, std::string_view anchor, std::string_view text,
                     std::string_view attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}{}>{}</text>", x, y,
                     anchor, attributes.empty() ? "" : " ", attributes, escaped(text));
}

std::string svg(double width, double height, std::string_view label, const std::string& content) {
  return fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">\n{}</svg>\n", width,
      height, escaped(label), content);
}

}  // namespace jaywalk::reporting
