#pragma once

// What a controller outside of this program reads for each decision: a view as one line of JSON.
// external.cpp has its fields. It is written as text, since a test asks a hundred times and more: a
// tree of JSON values takes ten times as long.

#include <cstdint>
#include <string>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// Without a line break. `step`: the number of the question; numbers are tidy (env/process/tidy.h).
[[nodiscard]] std::string view_text(const VehicleView& view, std::uint64_t test, std::size_t step);

}  // namespace jaywalk
