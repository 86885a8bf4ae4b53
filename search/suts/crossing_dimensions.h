#pragma once

// The keys of a scenario that a search chooses values of, as the map `parameters` of a SUT gives
// them with their ranges. Read env/config/reader.h and crossing_space.h first.

#include <vector>

#include "env/config/reader.h"
#include "search/suts/crossing_space.h"

namespace jaywalk::search {

/// Adds the dimensions of the map; replaces the range of a key that is there already. Errors go to
/// the reader's diagnostics.
void read_dimensions(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<CrossingDimension>& dimensions);

}  // namespace jaywalk::search
