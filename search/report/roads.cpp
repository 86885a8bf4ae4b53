#include "search/report/roads.h"

#include <fmt/format.h>

#include "env/lane/road.h"
#include "experiment/report/axis.h"
#include "experiment/report/html.h"
#include "interpreter/support/markup.h"

namespace jaywalk::search {

void RoadPictures::add(const TestRow& row, std::string_view caption) {
  constexpr double kSide = 110;
  constexpr double kRoadWidth_m = 8;
  const double scale = kSide / space_.settings().rules.map_m;
  std::string path;
  for (const Point& point :
       lane::interpolate(space_.road_points(row.test.input)).value_or(lane::Polyline{})) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", scale * point.x_m,
                        kSide - scale * point.y_m);
  }
  const std::string content = fmt::format(
      "<rect width=\"{0}\" height=\"{0}\" class=\"pavement\"/>"
      "<g {1}><path d=\"{2}\" stroke-width=\"{3:.1f}\"/></g>\n",
      kSide, reporting::series_attributes(generator_), path, kRoadWidth_m * scale);
  figures_ += reporting::figure(fmt::format("<small>{}</small>", escaped(caption)),
                                reporting::svg(kSide, kSide, caption, content));
  ++count_;
}

std::string RoadPictures::html() const {
  return figures_.empty() ? std::string()
                          : reporting::gallery(figures_, reporting::PictureSize::small);
}

}  // namespace jaywalk::search
