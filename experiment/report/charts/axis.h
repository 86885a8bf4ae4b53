#pragma once

// The places of values and marks on a picture's axis.

#include <string>
#include <string_view>
#include <vector>

#include "experiment/report/charts/plot.h"

namespace jaywalk::reporting {

/// Makes room around values whose spread is below their precision: those are one value. Nothing
/// else changes.
void widen_if_narrow(double& least, double& most);

/// Maps values from `least` to `most` to places from `begin` to `end`. REQUIRES: least < most and
/// not narrow (see above), on a logarithmic scale both positive.
struct Axis {
  double least = 0;
  double most = 1;
  double begin = 0;
  double end = 1;
  Scale scale = Scale::linear;

  /// The place of a value; the nearest end for a value outside.
  [[nodiscard]] double at(double value) const;
  /// About `count` round values, ascending, and never more than twice as many.
  [[nodiscard]] std::vector<double> marks(int count) const;
};

[[nodiscard]] std::string svg_line(double x1, double y1, double x2, double y2,
                                   std::string_view attributes = {});
/// `anchor`: start, middle, end. The text is escaped.
[[nodiscard]] std::string svg_text(double x, double y, std::string_view anchor,
                                   std::string_view text, std::string_view attributes = {});
[[nodiscard]] std::string svg(double width, double height, std::string_view label,
                              const std::string& content);

}  // namespace jaywalk::reporting
