// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "env/lane/road.h"
#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "interpreter/support/markup.h"
#include "search/failing_stretch.h"
#include "search/report/search_page.h"

namespace jaywalk::search {
namespace {

constexpr double kSide = 110;

/// A round number of metres that takes at least a fifth of the picture.
double bar_metres(double map_m) {
  const double least = map_m / 5;
  double metres = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (metres < least) metres *= factor;
  }
  return metres;
}

std::string scale_bar(double map_m) {
  const double metres = bar_metres(map_m);
  const double right = kSide - 5;
  const double left = right - metres * kSide / map_m;
  return reporting::svg_line(left, kSide - 5, right, kSide - 5, "class=\"axis\"") +
         reporting::svg_text((left + right) / 2, kSide - 8, "middle",
                             fmt::format("{:.6g} m", metres), "class=\"small\"");
}

}  // namespace

void RoadPictures::add(const TestRow& row, std::string_view caption) {
  const double scale = kSide / space_.settings().rules.map_m;
  const auto x = [&](const Point& point) { return scale * point.x_m; };
  const auto y = [&](const Point& point) { return kSide - scale * point.y_m; };
  const auto road = lane::make_road(space_.road_points(row.test.input));
  std::string drawn;
  if (road) {
    std::string path;
    for (const Point& point : road->middle) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(point), y(point));
    }
    drawn = fmt::format("<path d=\"{}\" stroke-width=\"{:.1f}\"/>", path, lane::kRoadWidth * scale);
    drawn +=
        reporting::svg_line(x(road->left.front()), y(road->left.front()), x(road->right.front()),
                            y(road->right.front()), "class=\"axis\" stroke-width=\"2\"");
  }
  if (const auto place = road ? worst_place(row.test, model_) : std::nullopt) {
    drawn += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" class=\"dot\"><title>farthest out of the "
        "lane</title></circle>",
        x(*place), y(*place));
  }
  const std::string content = fmt::format(
      "<rect width=\"{0}\" height=\"{0}\" class=\"pavement\"/><g {1}>{2}</g>\n{3}", kSide,
      reporting::series_attributes(generator_), drawn, scale_bar(space_.settings().rules.map_m));
  figures_ += reporting::figure(fmt::format("<small>{}</small>", escaped(caption)),
                                reporting::svg(kSide, kSide, caption, content));
  ++count_;
}

std::string RoadPictures::html() const {
  return figures_.empty() ? std::string()
                          : reporting::gallery(figures_, reporting::PictureSize::small);
}

}  // namespace jaywalk::search
