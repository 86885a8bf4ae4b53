#pragma once

// What a controller outside of this program reads for each decision: a view as one line of JSON.
// external.cpp has its fields. It is written as text, since a test asks a hundred times and more: a
// tree of JSON values takes ten times as long.

#include <cstdint>
#include <string>
#include <vector>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// Names of a view's fields, those that somebody reads; none: all.
using ViewFields = std::vector<std::string>;

/// In the order of the alphabet.
[[nodiscard]] ViewFields all_view_fields();

/// Without a line break. `step`: the number of the question, which every text has; numbers are tidy
/// (env/process/tidy.h).
[[nodiscard]] std::string view_text(const VehicleView& view, std::uint64_t test, std::size_t step,
                                    const ViewFields& fields = {});

}  // namespace jaywalk
