// SPDX-License-Identifier: Apache-2.0
#include "env/ground.h"

#include <algorithm>
#include <array>

namespace jaywalk {

const Area* Ground::av_lane() const {
  const auto found = std::ranges::find_if(areas, &Area::of_av);
  return found == areas.end() ? nullptr : &*found;
}

bool contains(const Area& area, Point point) {
  for (std::size_t i = 0; i < area.corners.size(); ++i) {
    const Point from = area.corners[i];
    const Point to = area.corners[(i + 1) % area.corners.size()];
    const double side =
        (to.x_m - from.x_m) * (point.y_m - from.y_m) - (to.y_m - from.y_m) * (point.x_m - from.x_m);
    if (side < 0) return false;
  }
  return !area.corners.empty();
}

std::string_view name(Surface ground) {
  static constexpr std::array<std::string_view, 4> kNames{"pavement", "lane", "crosswalk",
                                                          "blocked"};
  return kNames[static_cast<std::size_t>(ground)];
}

const PlanBand& GroundPlan::band_of(int row) const {
  std::size_t band = 0;
  while (row >= bands[band].rows) row -= bands[band++].rows;
  return bands[band];
}

}  // namespace jaywalk
