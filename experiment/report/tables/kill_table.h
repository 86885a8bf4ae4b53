#pragma once

// The kill matrix for the terminal: the kills of each behaviour, and the killers of each defect.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// Plain text; empty if no defects were looked for.
[[nodiscard]] std::string render_kills(const Comparison& comparison);
/// The kills alone, without the lines that need other measures of the comparison.
[[nodiscard]] std::string render_kills(const KillMatrix& matrix);

}  // namespace jaywalk
