#pragma once

// The road of a crossing world as ASAM OpenDRIVE 1.6 has it.

#include <string>

#include "env/crossing/parameters.h"

namespace jaywalk {

/// One straight road along y in the plane of env/scene.h. The reference line runs between the lanes
/// that go forward and the others; traffic keeps to the left, so that lane 1 drives along the road.
/// A world that is drawn as a map is exported with the bands that its rows begin with.
[[nodiscard]] std::string to_opendrive(const CrossingParameters& parameters);

}  // namespace jaywalk
