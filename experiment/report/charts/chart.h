#pragma once

// A comparison as a picture: accuracy and combined score against the number of agents, ours drawn
// solid, the published figures dashed in the same colour.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// A self-contained SVG picture.
[[nodiscard]] std::string render_svg(const Comparison& comparison);

}  // namespace jaywalk
