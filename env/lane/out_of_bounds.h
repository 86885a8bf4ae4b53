// SPDX-License-Identifier: Apache-2.0
#pragma once

// How much of the car is outside of the right lane: the competition's oob_percentage. Read
// vehicle.h and road.h first.

#include <cstddef>

#include "env/lane/road.h"
#include "env/lane/vehicle.h"

namespace jaywalk::lane {

/// The share of the car's box outside of the right lane, 0 to 1. `near`: the middle line's point
/// beside the car; stretches farther than 14 points from it are not looked at.
[[nodiscard]] double out_of_bounds_share(const Road& road, const VehicleState& state,
                                         const VehicleParameters& parameters, std::size_t near);

}  // namespace jaywalk::lane
