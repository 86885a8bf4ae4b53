#pragma once

// A comparison as a table for the terminal, our values beside the published ones.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// Plain text, a block of lines for each behaviour; empty if nothing is finished.
[[nodiscard]] std::string render_table(const Comparison& comparison);

}  // namespace jaywalk
