// SPDX-License-Identifier: Apache-2.0
#pragma once

// Writes a view as one line of JSON, which an external controller reads for each decision.
// external.cpp has its fields. It is written as text, since a test needs a hundred and more: a
// tree of JSON values takes ten times as long.

#include <cstdint>
#include <string>
#include <vector>

#include "env/vehicle/vehicle.h"

namespace jaywalk {

/// Names of the view's fields that the controller reads; none: all.
using ViewFields = std::vector<std::string>;

/// In the order of the alphabet.
[[nodiscard]] ViewFields all_view_fields();

/// Without a line break. `step`: the number of the question, which every text has; numbers are tidy
/// (env/process/numbered_process.h).
[[nodiscard]] std::string view_text(const VehicleView& view, std::uint64_t test, std::size_t step,
                                    const ViewFields& fields = {});

}  // namespace jaywalk
