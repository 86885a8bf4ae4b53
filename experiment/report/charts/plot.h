// SPDX-License-Identifier: Apache-2.0
#pragma once

// Curves, box plots and stacked bars as SVG of one width, which fits a narrow screen unscaled.
// Colours and fonts are the page's (page.html). Read html.h first.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/ground.h"
#include "env/scene.h"
#include "experiment/compare/test_assessment.h"

namespace jaywalk::reporting {

enum class Scale { linear, logarithmic };

struct PlotPoint {
  double x = 0;
  double y = 0;
  std::optional<double> low;
  std::optional<double> high;
};

struct PlotSeries {
  std::string name;
  /// The series' number, which decides its colour and mark.
  std::size_t number = 0;
  /// Whether it is a published series: dashed, without marks.
  bool published = false;
  /// Ascending in x. Those that are not finite, or not positive on a logarithmic scale, are left
  /// out.
  std::vector<PlotPoint> points;
};

struct PlotAxes {
  std::string x_title;
  std::string y_title;
  Scale scale = Scale::linear;
  /// Values that the vertical axis includes, even if there are no points there.
  std::optional<double> least;
  std::optional<double> most;
  /// Where the horizontal axis begins, and how far it goes at least.
  double x_least = 1;
  double x_most = 2;
};

/// Curves over whole numbers.
[[nodiscard]] std::string curves(const PlotAxes& axes, const std::vector<PlotSeries>& series);

/// A box from quartile to quartile with the median, lines to the least and the greatest value.
struct Box {
  /// Short; may be empty, if the group has no other.
  std::string label;
  Distribution values;
};
struct BoxGroup {
  std::string name;
  std::size_t number = 0;
  std::vector<Box> boxes;
};

/// Horizontal box plots, group below group; each value belongs to one `noun`. Infinite values are
/// drawn as an arrow at the edge.
[[nodiscard]] std::string box_plots(std::string_view x_title, const std::vector<BoxGroup>& groups,
                                    std::string_view noun = "test");

struct Bar {
  std::string name;
  /// How many of each kind.
  std::vector<double> parts;
};
/// Bars from 0 to 100 %; part i has the class `part-<classes[i]>`.
[[nodiscard]] std::string stacked_bars(const std::vector<std::string>& classes,
                                       const std::vector<Bar>& bars);

// The places of values and marks on a picture's axis.

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

// The road as a picture, along it from left to right: what lies on the ground is drawn over it.

/// Maps places of the ground to places on the picture, in its units.
class RoadPicture {
 public:
  /// A picture of that ground, as wide as the page's pictures.
  explicit RoadPicture(const Ground& ground);

  /// Along the road and to the right of the AV's way.
  [[nodiscard]] double across(double y_m) const { return kMargin + (y_m - begin_m_) * along_; }
  [[nodiscard]] double down(double x_m) const { return 2 + (x_m - left_m_) * sideways_; }
  [[nodiscard]] double length(double metres) const { return metres * along_; }
  [[nodiscard]] double breadth(double metres) const { return metres * sideways_; }

  /// The middle of the line below the marks, whose left half is free.
  [[nodiscard]] double legend_line() const { return height_ + 34; }

  /// Lanes and pavements; `content` on them, metres below.
  [[nodiscard]] std::string draw(std::string_view label, const std::string& content) const;

 private:
  static constexpr double kMargin = 6;
  static constexpr double kWidth = 520;

  const Ground& ground_;
  double begin_m_ = 0;
  double left_m_ = 0;
  double height_ = 0;
  double end_m_ = 1;
  double along_ = 1;
  double sideways_ = 1;
};

}  // namespace jaywalk::reporting
