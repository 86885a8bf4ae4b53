#pragma once

// Small SVG pictures for the page about searches: box plots, curves, roads.

#include <string>
#include <string_view>
#include <vector>

#include "env/scene.h"

namespace jaywalk::search {

/// Distinguishable for the colour-blind, after Okabe and Ito; they repeat after eight.
[[nodiscard]] std::string_view colour(std::size_t index);

struct Distribution {
  std::string name;
  std::vector<double> values;
};

/// Quartiles as a box, the median as a line, whiskers to the farthest values within 1.5 times the
/// box (Tukey 1977), single values beyond them; `title` above.
[[nodiscard]] std::string box_plots(std::string_view title,
                                    const std::vector<Distribution>& distributions);

struct Curve {
  std::string name;
  /// Values at equal distances over the whole width.
  std::vector<double> values;
};

/// Curves over a horizontal axis that goes from 0 to 100 %; values from 0 to 1.
[[nodiscard]] std::string curves(std::string_view title, const std::vector<Curve>& all);

/// Roads side by side on maps of that size, eight of them in a row.
[[nodiscard]] std::string road_pictures(const std::vector<std::vector<Point>>& roads,
                                        const std::vector<std::string>& captions, double map_m,
                                        std::string_view stroke);

/// The value below which a share of the values lies, between neighbours linearly. REQUIRES: values.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace jaywalk::search
