// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the pedestrians of a test begin. The cells depend on the parameters, the seed and the
// number of agents alone, so that behaviours are compared on the same beginnings; the first agents
// of a large group begin where those of a smaller one do.

#include <cstdint>
#include <vector>

#include "env/crossing/parameters.h"

namespace jaywalk {

/// The cells of a row on which agents may spawn; empty if it belongs to no pavement.
[[nodiscard]] Interval spawn_cells(const CrossingParameters& parameters, int row);

/// The pavement cells on which agents may spawn: those in which a body lies over no blocked cell.
[[nodiscard]] std::vector<Position> free_spawn_cells(const CrossingParameters& parameters);

/// Draws the agents' start cells independently; several may begin in the same one.
/// REQUIRES: parameters without problems().
[[nodiscard]] std::vector<Position> spawn(const CrossingParameters& parameters, std::size_t agents,
                                          std::uint64_t seed);

}  // namespace jaywalk
