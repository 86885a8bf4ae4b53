#pragma once

// The kill matrix for the terminal: what each behaviour kills, and who kills each defect.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// Plain text; empty if no defects were looked for.
[[nodiscard]] std::string render_kills(const Comparison& comparison);
/// The same without what needs other measures.
[[nodiscard]] std::string render_kills(const KillMatrix& matrix);

}  // namespace jaywalk
