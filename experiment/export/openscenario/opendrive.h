#pragma once

// The ground of a crossing world as ASAM OpenDRIVE 1.6 has it.

#include <string>

#include "experiment/export/openscenario/road_plan.h"

namespace jaywalk {

/// Roads in the plane of env/scene.h, the AV's along y. The reference line runs between the lanes
/// that go the road's way and the others; traffic keeps to the left, so that lane 1 drives along
/// the road.
[[nodiscard]] std::string to_opendrive(const RoadPlan& plan, double cell_m);

}  // namespace jaywalk
