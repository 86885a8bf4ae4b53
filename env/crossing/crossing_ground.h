#pragma once

// The ground of the crossing world. Read env/ground.h first.

#include <vector>

#include "env/ground.h"
#include "env/rectangle.h"

namespace jaywalk {

struct CrossingParameters;

/// The bands of the crossing world, as far as its road goes; of a map the stretches of its rows,
/// and its AV's lane over them. REQUIRES: parameters without problems().
[[nodiscard]] Ground ground(const CrossingParameters& parameters);

/// The obstacles of the crossing world, in their order.
[[nodiscard]] std::vector<Rectangle> obstacles(const CrossingParameters& parameters);

}  // namespace jaywalk
