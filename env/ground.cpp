#include "env/ground.h"

#include <algorithm>

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

}  // namespace jaywalk
