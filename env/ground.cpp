#include "env/ground.h"

#include <algorithm>

#include "env/crossing/parameters.h"

namespace jaywalk {

const Area* Ground::av_lane() const {
  const auto found = std::ranges::find_if(areas, &Area::of_av);
  return found == areas.end() ? nullptr : &*found;
}

Ground ground(const CrossingParameters& parameters) {
  const double cell = parameters.cell_m;
  const double end = parameters.length * cell;
  const std::vector<Interval> rows = band_rows(parameters);
  Ground result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double left = rows[i].first * cell;
    const double right = (rows[i].last + 1) * cell;
    const bool lane = parameters.bands[i].kind == BandKind::lane;
    result.areas.push_back({.kind = lane ? AreaKind::lane : AreaKind::pavement,
                            .corners = {{left, 0}, {right, 0}, {right, end}, {left, end}},
                            .of_av = lane && rows[i].contains(parameters.av.rows.first)});
  }
  return result;
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
