#include "env/world/ground_plan.h"

#include <array>

namespace jaywalk {

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
