// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"

namespace jaywalk::reporting {

RoadPicture::RoadPicture(const Ground& ground) : ground_(ground) {
  constexpr double kMostHeight = 260;
  constexpr double kLeastHeight = 60;
  double right = -std::numeric_limits<double>::infinity();
  double end = right;
  begin_m_ = left_m_ = -right;
  for (const Area& area : ground.areas) {
    for (const Point& corner : area.corners) {
      left_m_ = std::min(left_m_, corner.x_m);
      right = std::max(right, corner.x_m);
      begin_m_ = std::min(begin_m_, corner.y_m);
      end = std::max(end, corner.y_m);
    }
  }
  if (!(left_m_ < right) || !(begin_m_ < end)) {
    begin_m_ = left_m_ = 0;
    right = end = 1;
  }
  end_m_ = end;
  along_ = (kWidth - 2 * kMargin) / (end - begin_m_);
  // True to scale unless the road is so long or so broad that nothing could be seen.
  height_ = std::clamp((right - left_m_) * along_, kLeastHeight, kMostHeight);
  sideways_ = height_ / (right - left_m_);
}

std::string RoadPicture::draw(std::string_view label, const std::string& content) const {
  std::string drawn;
  for (const AreaKind kind : {AreaKind::pavement, AreaKind::lane}) {
    for (const Area& area : ground_.areas) {
      if (area.kind != kind) continue;
      std::string points;
      for (const Point& corner : area.corners) {
        points += fmt::format("{:.1f},{:.1f} ", across(corner.y_m), down(corner.x_m));
      }
      drawn += fmt::format("<polygon points=\"{}\" class=\"{}\"/>\n", points,
                           kind == AreaKind::lane ? "lane" : "pavement");
    }
  }
  const double bottom = 2 + height_;
  const Axis axis{
      .least = begin_m_, .most = end_m_, .begin = across(begin_m_), .end = across(end_m_)};
  for (const double mark : axis.marks(6)) {
    drawn += svg_line(axis.at(mark), bottom, axis.at(mark), bottom + 4, "class=\"axis\"");
    drawn += svg_text(axis.at(mark), bottom + 18, "middle", fmt::format("{:g}", mark)) + '\n';
  }
  drawn += svg_text(across(end_m_) - 4, bottom + 36, "end", "metres along the AV’s way →");
  return svg(kWidth, bottom + 42, label, drawn + content);
}

}  // namespace jaywalk::reporting
